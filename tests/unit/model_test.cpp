// SPDX-License-Identifier: BSD-3-Clause
// The files that belong to a model, and the order in which they are merged.
#include <doctest/doctest.h>

#include "ast/sections.hpp"
#include "smurf/load.hpp"
#include "unit/parsed.hpp"

using namespace smurf;
using smurf::test::join;
using smurf::test::Lines;

namespace {

constexpr const char* kUrdf = "<robot name='r'><link name='a'/></robot>";

struct LoadedFiles {
  SourceMap sources;
  MemoryFiles files;
  DiagnosticSink sink;
  LinkedModel model;

  LoadedFiles(std::initializer_list<std::pair<std::string, std::string>> given,
              const std::string& path) {
    for (const auto& [name, text] : given) files.add(name, text);
    LoadContext context{sources, files, sink, {}, {}};
    model = load_model(path, context);
  }

  Lines briefs() const { return test::briefs(sink, sources); }
  Lines motors() const {
    Lines names;
    for (const Motor& motor : model.annotations.motors) names.push_back(motor.name.value_or("?"));
    return names;
  }
  Lines paths() const {
    Lines paths;
    for (const ModelFile& file : model.files) paths.push_back(sources.path(file.source));
    return paths;
  }
};

std::string motor(const std::string& name) { return "{name: " + name + ", joint: j, type: PID}"; }

}  // namespace

TEST_CASE("model: lists are joined in the order of the files, inline sections first") {
  const LoadedFiles loaded({{"m/r.smurf", "motors: [" + motor("inline") +
                                              "]\n"
                                              "files: [r_b.yml, ../u/r.urdf, r_a.yml]\n"},
                            {"m/r_a.yml", "motors: [" + motor("a1") + ", " + motor("a2") + "]\n"},
                            {"m/r_b.yml", "motors: [" + motor("b1") + "]\nmaterials: []\n"},
                            {"u/r.urdf", kUrdf}},
                           "m/r.smurf");
  CHECK(join(loaded.briefs()) == "");
  CHECK(join(loaded.motors()) == join({"inline", "b1", "a1", "a2"}));
  CHECK(join(loaded.paths()) == join({"m/r.smurf", "m/r_b.yml", "u/r.urdf", "m/r_a.yml"}));
  CHECK(loaded.model.has_main);
  CHECK(loaded.model.is_complete);
  CHECK(loaded.model.urdf_path == "u/r.urdf");
  CHECK(loaded.model.motor_names.find("b1") == 1);
}

TEST_CASE("model: singular and plural names are one section") {
  const LoadedFiles loaded({{"r.smurf", "files: [r.urdf, a.yml]\n"},
                            {"a.yml", "material:\n- {name: x}\nmaterials:\n- {name: y}\n"},
                            {"r.urdf", kUrdf}},
                           "r.smurf");
  REQUIRE(loaded.model.annotations.materials.size() == 2);
  CHECK(*loaded.model.annotations.materials[0].name == "x");
  CHECK(loaded.sources.text(loaded.model.annotations.materials[0].section) == "material");
  CHECK(loaded.sources.text(loaded.model.annotations.materials[1].section) == "materials");
}

TEST_CASE("model: every section of every file is merged") {
  std::string text = "mine: [1]\n";
  for (const SectionSpec* section : all_sections()) {
    const bool is_named = section->form == SectionForm::named;
    text += std::string(section->name) + (is_named ? ": {x: {}}\n" : ": [{name: x}]\n");
  }
  const LoadedFiles loaded({{"r.smurf", "files: [r.urdf, a.yml, b.yml]\n"},
                            {"a.yml", text},
                            {"b.yml", text},
                            {"r.urdf", kUrdf}},
                           "r.smurf");
  for (const SectionSpec* section : all_sections()) {
    CAPTURE(section->name);
    CHECK(section->list.entries(loaded.model.annotations).size() == 2);
  }
  CHECK(loaded.model.annotations.custom.size() == 2);
}

TEST_CASE("model: of several URDFs the last one counts") {
  const LoadedFiles loaded({{"r.smurf", "files: [a.urdf, b.URDF]\n"},
                            {"a.urdf", "<robot name='a'/>"},
                            {"b.URDF", "<robot name='b'/>"}},
                           "r.smurf");
  CHECK(*loaded.model.robot->name == "b");
  CHECK(loaded.model.urdf_path == "b.URDF");
  CHECK(loaded.model.files.size() == 3);
}

TEST_CASE("model: a file name that no text can hold is not suggested") {
  for (const char* name : {"mod\xE9l.urdf", "mod\nl.urdf", "mode\xE2\x80\xAEl.urdf"}) {
    CAPTURE(name);
    const LoadedFiles loaded({{"r.smurf", "files: [modl.urdf]\n"}, {name, kUrdf}}, "r.smurf");
    REQUIRE(!loaded.sink.diagnostics().empty());
    const Diagnostic& missing = loaded.sink.diagnostics()[0];
    CHECK(missing.help_text.empty());
    CHECK(missing.fixes.empty());
  }
  const LoadedFiles loaded({{"r.smurf", "files: [modl.urdf]\n"}, {"model.urdf", kUrdf}}, "r.smurf");
  CHECK(loaded.sink.diagnostics()[0].fixes.size() == 1);
}

TEST_CASE("model: files beside it whose names no text can hold are not missed in its list") {
  const LoadedFiles loaded({{"m\xE9.smurf", "files: [r.urdf]\n"},
                            {"m\xE9_motors.yml", "motors: []\n"},
                            {"r.urdf", kUrdf}},
                           "m\xE9.smurf");
  CHECK(loaded.model.unlisted_files.empty());
}

TEST_CASE("model: a single name in place of the list") {
  const LoadedFiles loaded({{"r.smurf", "files: r.urdf\n"}, {"r.urdf", kUrdf}}, "r.smurf");
  CHECK(loaded.model.robot);
  CHECK(loaded.model.main.files->size() == 1);
}

TEST_CASE("model: other entries of the list are not opened") {
  const LoadedFiles loaded({{"r.smurf", "files: [r.urdf, r.srdf, mesh.stl]\n"}, {"r.urdf", kUrdf}},
                           "r.smurf");
  CHECK(join(loaded.briefs()) == "");
  CHECK(loaded.model.is_complete);
}

TEST_CASE("model: keys of a plug-in or a scene are kept") {
  const LoadedFiles loaded({{"r.smurf", "modelname: r\nversion: 1.2\nposition: [1, 2, 3]\n"
                                        "files: [r.urdf]\n"},
                            {"r.urdf", kUrdf}},
                           "r.smurf");
  CHECK(*loaded.model.main.modelname == "r");
  CHECK(*loaded.model.main.version == "1.2");
  REQUIRE(loaded.model.main.extra.size() == 1);
  CHECK(loaded.model.main.extra[0].name.value == "position");
  CHECK(loaded.sources.text(loaded.model.main.extra[0].span) == "[1, 2, 3]");
}

TEST_CASE("model: files beside it that it does not list") {
  const LoadedFiles loaded({{"m/r.smurf", "files: [r.urdf, ./r_motors.yml]\n"},
                            {"m/r.urdf", kUrdf},
                            {"m/r_motors.yml", "motors: []\n"},
                            {"m/r_sensors.yml", "sensors: []\n"},
                            {"m/r_notes.yml", "a: b\n"},
                            {"m/q_materials.yml", "materials: []\n"},
                            {"m/r_materials.txt", ""},
                            {"r_visuals.yml", ""}},
                           "m/r.smurf");
  CHECK(join(loaded.model.unlisted_files) == join({"r_sensors.yml"}));
}

TEST_CASE("model: missing and broken files") {
  struct Case {
    std::string files;
    Lines briefs;
  };
  const Case cases[] = {
      {"[r.urdf, gone.yml]", {"SML2001 1:17 [gone.yml]"}},
      {"[gone.urdf]", {"SML2001 1:9 [gone.urdf]"}},
      {"[r.urdf, bad.yml]", {"SML0010 1:4 [[]"}},
      {"[r.urdf, list.yml]", {"SML2011 1:1 [[1]]"}},
      {"[r.urdf, empty.yml]", {"SML2011 1:1 []"}},
      {"[bad.urdf]", {"SML1001 1:2 [robot]"}},
      {"[sdf.urdf]", {"SML1101 1:2 [sdf]"}},
      {"[r.urdf, 'gone dir/x.yml']", {"SML2001 1:17 ['gone dir/x.yml']"}},
  };
  for (const Case& one : cases) {
    CAPTURE(one.files);
    const LoadedFiles loaded({{"r.smurf", "files: " + one.files},
                              {"r.urdf", kUrdf},
                              {"bad.yml", "a: [1, 2"},
                              {"list.yml", "[1]"},
                              {"empty.yml", ""},
                              {"bad.urdf", "<robot"},
                              {"sdf.urdf", "<sdf/>"}},
                             "r.smurf");
    CHECK(join(loaded.briefs()) == join(one.briefs));
    CHECK(!loaded.model.is_complete);
  }
}

TEST_CASE("model: a misspelt file name is suggested") {
  const LoadedFiles loaded({{"m/r.smurf", "files: [r.urdf, r_moters.yml]\n"},
                            {"m/r.urdf", kUrdf},
                            {"m/r_motors.yml", "motors: []\n"}},
                           "m/r.smurf");
  REQUIRE(loaded.sink.diagnostics().size() == 1);
  const Diagnostic& diagnostic = loaded.sink.diagnostics().front();
  CHECK(diagnostic.help_text == "did you mean `r_motors.yml`?");
  REQUIRE(diagnostic.fixes.size() == 1);
  const Edit& edit = diagnostic.fixes.front().edits.front();
  CHECK(loaded.sources.text(edit.span) == "r_moters.yml");
  CHECK(edit.text == "r_motors.yml");
}

TEST_CASE("model: a main file that is none") {
  for (const char* text : {"", "[1]", "text", "files: {a: b}"}) {
    CAPTURE(text);
    const LoadedFiles loaded({{"r.smurf", text}}, "r.smurf");
    CHECK(!loaded.briefs().empty());
  }
  const LoadedFiles gone({}, "gone.smurf");
  CHECK(join(gone.briefs()) == join({"SML0001 1:1 []"}));
  CHECK(!gone.model.is_complete);
  CHECK(gone.sources.path(gone.sink.diagnostics().front().span.source) == "gone.smurf");
}

TEST_CASE("model: a URDF or an annotation file alone") {
  const LoadedFiles urdf({{"r.urdf", kUrdf}}, "./r.urdf");
  CHECK(!urdf.model.has_main);
  CHECK(urdf.model.path == "r.urdf");
  CHECK(urdf.model.robot);
  const LoadedFiles yaml({{"a.yml", "motors: [" + motor("x") + "]"}}, "a.yml");
  CHECK(!yaml.model.has_main);
  CHECK(!yaml.model.robot);
  CHECK(join(yaml.motors()) == join({"x"}));
}

TEST_CASE("model: files that are too large") {
  SourceMap sources;
  MemoryFiles files;
  files.add("r.urdf", std::string(100, ' '));
  DiagnosticSink sink;
  Limits limits;
  limits.file_bytes = 99;
  LoadContext context{sources, files, sink, limits, {}};
  CHECK(!load_model("r.urdf", context).is_complete);
  REQUIRE(sink.diagnostics().size() == 1);
  CHECK(sink.diagnostics().front().rule->id == "SML0002");
}

TEST_CASE("model: meshes and textures are looked up") {
  const auto visual = [](const std::string& file) {
    return "<visual><geometry><mesh filename='" + file + "'/></geometry></visual>";
  };
  const LoadedFiles loaded(
      {{"pkg/urdf/r.urdf",
        "<robot name='r'><material name='m'><texture filename='t.png'/></material><link name='a'>" +
            visual("../meshes/a.stl") + visual("package://pkg/meshes/a.stl") +
            visual("package://other/meshes/a.stl") + visual("package://other/meshes/b.stl") +
            visual("file:///abs/c.stl") + visual("http://x/y.stl") + visual("gone.stl") +
            visual("") + "</link></robot>"},
       {"pkg/meshes/a.stl", ""},
       {"pkg/urdf/t.png", ""},
       {"/abs/c.stl", ""}},
      "pkg/urdf/r.urdf");
  Lines lines;
  for (const MeshReference& mesh : loaded.model.meshes) {
    lines.push_back(mesh.path + (mesh.exists ? " there" : " gone") +
                    (mesh.is_texture ? " texture" : ""));
  }
  CHECK(join(lines) ==
        join({"pkg/urdf/t.png there texture", "pkg/meshes/a.stl there", "pkg/meshes/a.stl there",
              "pkg/meshes/a.stl there", "pkg/meshes/b.stl gone", "/abs/c.stl there", " gone",
              "pkg/urdf/gone.stl gone", " gone"}));
}

TEST_CASE("model: two loads do not know of each other") {
  MemoryFiles files;
  files.add("a.urdf", "<robot name='a'><link name='x'/></robot>");
  files.add("b.urdf", "<robot name='b'><link name='y'/></robot>");
  SourceMap sources;
  DiagnosticSink sink;
  LoadContext context{sources, files, sink, {}, {}};
  LinkedModel a = load_model("a.urdf", context);
  const LinkedModel b = load_model("b.urdf", context);
  const LinkedModel moved = std::move(a);
  CHECK(moved.link_names.contains("x"));
  CHECK(!moved.link_names.contains("y"));
  CHECK(b.link_names.contains("y"));
}
