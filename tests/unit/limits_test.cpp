// SPDX-License-Identifier: BSD-3-Clause
// Every limit: values just below it pass, values just above it are reported, and raising it helps.
#include "smurf/limits.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

#include "archive/zip.hpp"
#include "base/sanitizer.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"
#include "support/repeat.hpp"
#include "support/zip_writer.hpp"

using namespace smurf;
using smurf::test::repeat;

namespace {

/// Files that need `amount` of a limited resource, and the file to load.
struct Demand {
  MemoryFiles files;
  std::string entry;

  Demand(std::string main, std::string text) : entry(std::move(main)) {
    files.add(entry, std::move(text));
  }
};

Demand of_file(std::uint64_t bytes) {
  const std::string model = "files: []\n#";
  return {"r.smurf", model + repeat("x", bytes - model.size())};
}

Demand of_mesh(std::uint64_t bytes) {
  Demand demand("r.urdf",
                "<robot name='r'><link name='a'><visual><geometry><mesh filename='m.stl'/>"
                "</geometry></visual></link></robot>");
  demand.files.add("m.stl", repeat(" ", bytes));
  return demand;
}

Demand of_yaml_cpp(std::uint64_t bytes) {
  const std::string model = "files: &a []\n#";
  return {"r.smurf", model + repeat("x", bytes - model.size())};
}

Demand of_yaml_depth(std::uint64_t depth) {
  return {"r.smurf", "x: " + repeat("[", depth - 1) + repeat("]", depth - 1) + "\n"};
}

/// The mapping and its keys' values.
Demand of_yaml_nodes(std::uint64_t nodes) {
  std::string text;
  for (std::uint64_t i = 1; i < nodes; ++i) text += "x" + std::to_string(i) + ": y\n";
  return {"r.smurf", text};
}

Demand of_expanded_nodes(std::uint64_t nodes) {
  return {"r.smurf", "a: &a x\nb: [" + repeat("*a, ", nodes) + "]\n"};
}

Demand of_xml_depth(std::uint64_t depth) {
  return {"r.urdf",
          "<robot name='r'>" + repeat("<a>", depth - 1) + repeat("</a>", depth - 1) + "</robot>"};
}

Demand of_xml_elements(std::uint64_t elements) {
  return {"r.urdf", "<robot>" + repeat("<a/>", elements - 1) + "</robot>"};
}

Demand of_xml_attributes(std::uint64_t attributes) {
  std::string text = "<robot";
  for (std::uint64_t i = 0; i < attributes; ++i) text += " a" + std::to_string(i) + "='1'";
  return {"r.urdf", text + "/>"};
}

Demand of_annotation_entries(std::uint64_t entries) {
  return {"r.smurf", "motors:\n- {}\nx:\n" + repeat("- {}\n", entries - 1)};
}

Demand of_urdf_parts(std::uint64_t parts) {
  return {"r.urdf", "<robot name='r'>" + repeat("<link name='a'/>", parts) + "</robot>"};
}

/// A scene in this number of others.
Demand of_include_depth(std::uint64_t depth) {
  Demand demand("s0.smurfs", "entities: [{name: e, file: s1.smurfs}]\n");
  for (std::uint64_t i = 1; i <= depth; ++i) {
    const std::string next = "[{name: e, file: s" + std::to_string(i + 1) + ".smurfs}]";
    demand.files.add("s" + std::to_string(i) + ".smurfs",
                     "entities: " + (i == depth ? "[]" : next) + "\n");
  }
  return demand;
}

/// The second model reads them again.
Demand of_repeated_bytes(std::uint64_t bytes) {
  Demand demand("s.smurfs",
                "entities: [{name: a, type: smurf, file: a.smurf}, {name: b, type: smurf, file: "
                "b.smurf}]\n");
  for (const char* model : {"a.smurf", "b.smurf"}) {
    demand.files.add(model, "modelname: r\nfiles: [r.urdf]\n");
  }
  const std::string robot = "<robot name='r'><link name='a'/></robot>";
  demand.files.add("r.urdf", robot + repeat(" ", bytes - robot.size()));
  return demand;
}

/// The scene itself is included in the number.
Demand of_instances(std::uint64_t instances) {
  Demand demand("s.smurfs", "entities:\n" + repeat("- {type: urdf, file: r.urdf}\n", instances));
  demand.files.add("r.urdf", "<robot name='r'><link name='a'/></robot>");
  return demand;
}

/// The bytes are those of the name, path, type and file of the first entity.
Demand of_scene_bytes(std::uint64_t bytes) {
  const std::string file = repeat("x", bytes - std::string_view("aaurdf.urdf").size()) + ".urdf";
  return {"s.smurfs", "entities: [{name: a, type: urdf, file: " + file +
                          "}, {name: b, type: urdf, file: r.urdf}]\n"};
}

Demand of_findings(std::uint64_t findings) { return {"r.smurf", repeat("x: y\n", findings + 1)}; }

/// A scene, in which nothing else is found.
Demand of_all_findings(std::uint64_t findings) {
  return {"s.smurfs", "entities: []\n" + repeat("x: y\n", findings + 1)};
}

/// A robot of xacro with this content.
Demand of_xacro(const std::string& content) {
  return {"r.urdf.xacro",
          "<robot name='r' xmlns:xacro='x'>" + content + "<link name='a'/></robot>"};
}

std::string use_of(const std::string& expression) {
  return "<xacro:property name='p' value='" + expression + "' lazy_eval='false'/>";
}

/// The link is one of them; the root is not counted.
Demand of_xacro_elements(std::uint64_t elements) { return of_xacro(repeat("<a/>", elements - 1)); }

Demand of_xacro_depth(std::uint64_t depth) {
  std::string macros = "<xacro:macro name='m1' params=''/>";
  for (std::uint64_t i = 2; i <= depth; ++i) {
    macros += "<xacro:macro name='m" + std::to_string(i) + "' params=''><xacro:m" +
              std::to_string(i - 1) + "/></xacro:macro>";
  }
  return of_xacro(macros + "<xacro:m" + std::to_string(depth) + "/>");
}

Demand of_xacro_files(std::uint64_t files) {
  Demand demand = of_xacro(repeat("<xacro:include filename='part.xacro'/>", files));
  demand.files.add("part.xacro", "<robot xmlns:xacro='x'/>");
  return demand;
}

Demand of_xacro_text(std::uint64_t bytes) {
  return of_xacro(use_of("${\"x\" * " + std::to_string(bytes) + "}"));
}

Demand of_xacro_items(std::uint64_t items) {
  return of_xacro(use_of("${[1] * " + std::to_string(items) + "}"));
}

Demand of_xacro_integer(std::uint64_t bits) {
  return of_xacro(use_of("${2**" + std::to_string(bits - 1) + "}"));
}

struct LimitCase {
  std::string_view name;
  std::uint64_t amount;  ///< a small limit to test
  std::function<Demand(std::uint64_t amount)> demand;
};

const LimitCase kCases[] = {{"file-bytes", 100, of_file},
                            {"mesh-bytes", 100, of_mesh},
                            {"yaml-cpp-bytes", 100, of_yaml_cpp},
                            {"yaml-depth", 20, of_yaml_depth},
                            {"yaml-nodes", 20, of_yaml_nodes},
                            {"yaml-expanded-nodes", 20, of_expanded_nodes},
                            {"xml-depth", 20, of_xml_depth},
                            {"xml-elements", 20, of_xml_elements},
                            {"xml-attributes", 20, of_xml_attributes},
                            {"annotation-entries", 20, of_annotation_entries},
                            {"urdf-parts", 20, of_urdf_parts},
                            {"repeated-bytes", 100, of_repeated_bytes},
                            {"include-depth", 20, of_include_depth},
                            {"instances", 20, of_instances},
                            {"scene-bytes", 100, of_scene_bytes},
                            {"findings", 20, of_findings},
                            {"all-findings", 20, of_all_findings},
                            {"xacro-elements", 20, of_xacro_elements},
                            {"xacro-depth", 20, of_xacro_depth},
                            {"xacro-files", 20, of_xacro_files},
                            {"xacro-text-bytes", 2000, of_xacro_text},
                            {"xacro-items", 200, of_xacro_items},
                            {"xacro-integer-bits", 200, of_xacro_integer}};

/// The findings of a rule.
std::vector<Diagnostic> found(const Demand& demand, const Limits& limits, std::string_view rule) {
  SourceMap sources;
  DiagnosticSink sink(limits);
  MeshLibrary meshes;
  LoadContext context{sources, demand.files, sink, limits, {}, {}, &meshes};
  if (demand.entry.ends_with(".smurfs")) {
    load_scene(demand.entry, context);
  } else {
    lint_model(load_model(demand.entry, context), {}, sink);
  }
  std::vector<Diagnostic> all = sink.take();
  std::erase_if(all, [&](const Diagnostic& one) {
    return one.rule->id != rule || one.help_text.find("--limit") == std::string::npos;
  });
  return all;
}

const LimitInfo& info_of(std::string_view name) {
  const auto* info = std::find_if(kLimits.begin(), kLimits.end(),
                                  [&](const LimitInfo& one) { return one.name == name; });
  REQUIRE(info != kLimits.end());
  return *info;
}

}  // namespace

TEST_CASE("limits: the last that passes, the first that does not, and the same with a higher one") {
  for (const LimitCase& one : kCases) {
    CAPTURE(one.name);
    const LimitInfo& info = info_of(one.name);
    Limits limits;
    limits.*info.value = one.amount;
    CHECK(found(one.demand(one.amount), limits, info.diagnostic).empty());
    const auto told = found(one.demand(one.amount + 1), limits, info.diagnostic);
    REQUIRE(told.size() == 1);
    CHECK(told[0].help_text == "raise the limit with `--limit " + std::string(one.name) + "=N`");
    limits.*info.value = one.amount + 1;
    CHECK(found(one.demand(one.amount + 1), limits, info.diagnostic).empty());
  }
}

TEST_CASE("limits: all of them hold at the most that can be asked for") {
  // The other limits would need more memory than a test has.
  for (const std::string_view name :
       {"yaml-depth", "xml-depth", "xml-attributes", "include-depth", "xacro-depth"}) {
    CAPTURE(name);
    const LimitInfo& info = info_of(name);
    const auto one = std::find_if(std::begin(kCases), std::end(kCases),
                                  [&](const LimitCase& tried) { return tried.name == name; });
    // The frames of AddressSanitizer are ten times as large: 1000 scenes need 9 MB of stack.
    const std::uint64_t most = SMURF_HAS_ADDRESS_SANITIZER ? info.most / 2 : info.most;
    Limits limits;
    limits.*info.value = most;
    SourceMap sources;
    DiagnosticSink sink;
    const Demand demand = one->demand(most);
    LoadContext context{sources, demand.files, sink, limits, {}};
    const bool is_read = demand.entry.ends_with(".smurfs")
                             ? load_scene(demand.entry, context).is_complete
                             : !load_model(demand.entry, context).files.empty();
    CHECK(is_read);
    for (const Diagnostic& diagnostic : sink.diagnostics()) {
      const std::string id(diagnostic.rule->id);
      CHECK_MESSAGE((id != "SML0010" && id != "SML0014" && id != "SML1001" && id != "SML5021" &&
                     id != "SML3312"),
                    diagnostic.message);
    }
  }
}

TEST_CASE("limits: those of archives") {
  const std::string bytes = test::zip({{"a", "12345"}, {"b", "12345"}});
  Limits limits;
  limits.archive_bytes = 10;
  limits.archive_files = 2;
  CHECK(read_zip(bytes, limits).reason == "");
  limits.archive_bytes = 9;
  CHECK(read_zip(bytes, limits).reason ==
        "unpacks to more than 9 bytes; raise the limit with `--limit archive-bytes=N`");
  limits.archive_bytes = 10'000'000;
  limits.archive_growth = 0;
  const std::string large = test::zip({{"a", repeat("x", 8'000'001)}});
  CHECK(read_zip(large, limits).reason ==
        "unpacks to more than 8000000 bytes; raise the limit with `--limit archive-growth=N`");
  limits.archive_growth = 1;
  CHECK(read_zip(large, limits).reason == "");
  limits.archive_bytes = 10;
  limits.archive_files = 1;
  CHECK(read_zip(bytes, limits).reason ==
        "contains more than 1 files; raise the limit with `--limit archive-files=N`");
}

TEST_CASE("limits: the work and the values of a xacro file") {
  const std::string loop = use_of("${[i*j for i in python.range(100) for j in python.range(100)]}");
  const Demand work = of_xacro(loop);
  const Demand values = of_xacro(use_of("${\"x\" * 100000 + \"y\"}"));
  const auto told_by = [](const Demand& demand, std::string_view name, std::uint64_t limit) {
    Limits limits;
    limits.*info_of(name).value = limit;
    const auto told = found(demand, limits, "SML3312");
    return told.empty() ? std::string() : told[0].help_text;
  };
  CHECK(told_by(work, "xacro-steps", 1'000'000).empty());
  CHECK(told_by(work, "xacro-steps", 10'000) == "raise the limit with `--limit xacro-steps=N`");
  CHECK(told_by(values, "xacro-bytes", 1'000'000).empty());
  CHECK(told_by(values, "xacro-bytes", 100'000) == "raise the limit with `--limit xacro-bytes=N`");
}

TEST_CASE("limits: every row of the table has a name of its own, a usual value and a test") {
  // Tests of the other limits.
  constexpr std::string_view kElsewhere[] = {
      "image-pixels",   "archive-bytes", "archive-files", "archive-growth",  "srdf-bytes",
      "folder-entries", "ignore-checks", "suggestions",   "rechecked-bytes", "path-checks",
      "differences",    "xacro-steps",   "xacro-bytes",   "xacro-variants"};
  for (const LimitInfo& info : kLimits) {
    CAPTURE(info.name);
    CHECK(&info_of(info.name) == &info);
    CHECK(Limits{}.*info.value <= info.most);
    CHECK((info.diagnostic.empty() || find_rule(info.diagnostic) != nullptr));
    const bool is_tested =
        std::any_of(std::begin(kCases), std::end(kCases),
                    [&](const LimitCase& one) { return one.name == info.name; }) ||
        std::find(std::begin(kElsewhere), std::end(kElsewhere), info.name) != std::end(kElsewhere);
    CHECK(is_tested);
  }
}
