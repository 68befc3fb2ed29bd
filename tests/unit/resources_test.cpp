// SPDX-License-Identifier: BSD-3-Clause
// The places where readers look for meshes and textures, and the number of times a file is opened.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "smurf/load.hpp"
#include "smurf/verdict.hpp"
#include "support/loaded.hpp"

using namespace smurf;

namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\n";

std::string robot(const std::vector<std::string>& meshes) {
  std::string text = "<robot name='r'><link name='a'>";
  for (const std::string& mesh : meshes) {
    text += "<visual><geometry><mesh filename='" + mesh + "'/></geometry></visual>";
  }
  return text + "</link></robot>";
}

/// Counts how often each file is opened.
class CountedFiles final : public FileReader {
 public:
  MemoryFiles files;
  mutable std::map<std::string, int> reads;

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override {
    ++reads[path];
    return files.read(path, max_bytes);
  }
  bool is_file(const std::string& path) const override { return files.is_file(path); }
  std::vector<std::string> list(const std::string& folder) const override {
    return files.list(folder);
  }
};

struct Models {
  CountedFiles files;
  SourceMap sources;
  DiagnosticSink sink;
  MeshLibrary meshes;
  std::vector<std::string> package_folders;

  LinkedModel load(const std::string& path, bool opens = true) {
    LoadContext context{sources, files, sink, {}, {}, package_folders, opens ? &meshes : nullptr};
    return load_model(path, context);
  }
};

}  // namespace

TEST_CASE("resources: threads open each mesh once, and see the same facts") {
  struct SlowFiles final : FileReader {
    mutable std::mutex mutex;
    mutable std::map<std::string, int> reads;

    FileContent read(const std::string& path, std::uint64_t) const override {
      {
        const std::lock_guard lock(mutex);
        ++reads[path];
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      return {ReadStatus::ok, kTriangle, {}};
    }
    bool is_file(const std::string&) const override { return true; }
    std::vector<std::string> list(const std::string&) const override { return {}; }
  };
  const SlowFiles files;
  MeshLibrary meshes;
  std::vector<std::vector<const MeshFile*>> seen(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    threads.emplace_back([&, i] {
      for (int k = 0; k < 20; ++k) {
        seen[i].push_back(&meshes.read("m" + std::to_string(k) + ".obj", files, {}));
        if (seen[i].back()->facts.triangles != 1) seen[i].back() = nullptr;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(files.reads.size() == 20);
  for (const auto& [path, count] : files.reads) CHECK(count == 1);
  for (const auto& one : seen) CHECK(one == seen[0]);
  CHECK(std::find(seen[0].begin(), seen[0].end(), nullptr) == seen[0].end());
}

TEST_CASE("resources: a mesh is opened once, and only for who asks") {
  Models models;
  models.files.files.add("a.urdf", robot({"m.obj", "m.obj", "./m.obj"}));
  models.files.files.add("b.urdf", robot({"m.obj"}));
  models.files.files.add("m.obj", kTriangle);
  CHECK(models.load("a.urdf", false).meshes[0].file == nullptr);
  CHECK(models.files.reads["m.obj"] == 0);
  const LinkedModel a = models.load("a.urdf");
  const LinkedModel b = models.load("b.urdf");
  CHECK(models.files.reads["m.obj"] == 1);
  REQUIRE(a.meshes.size() == 3);
  REQUIRE(a.meshes[0].file != nullptr);
  CHECK(a.meshes[0].file->facts.triangles == 1);
  CHECK(a.meshes[2].file == a.meshes[0].file);
  CHECK(b.meshes[0].file == a.meshes[0].file);
}

TEST_CASE("resources: what MARS opens") {
  Models models;
  models.files.files.add("smurf/r.smurf", "files: [../urdf/r.urdf]\n");
  models.files.files.add("urdf/r.urdf", robot({"../obj/a.obj", "../stl/b.stl", "../obj/c.obj",
                                               "d.obj", "package://p/e.obj"}));
  for (const char* path :
       {"obj/a.obj", "obj/a.bobj", "stl/b.stl", "bobj/b.bobj", "obj/c.obj", "urdf/d.obj"}) {
    models.files.files.add(path, kTriangle);
  }
  const LinkedModel model = models.load("smurf/r.smurf");
  std::vector<std::string> seen;
  for (const MeshReference& mesh : model.meshes) {
    seen.push_back(mesh.mars_path + (mesh.mars_exists ? " there" : " gone"));
  }
  CHECK(seen == std::vector<std::string>{"obj/a.bobj there", "bobj/b.bobj there", "obj/c.obj there",
                                         "smurf/d.obj gone", " gone"});
  // MARS does not open a URDF alone.
  CHECK(models.load("urdf/r.urdf").meshes[0].mars_path.empty());
}

TEST_CASE("resources: packages") {
  Models models;
  models.files.files.add("ws/own/package.xml", "<package><name> arm </name></package>");
  models.files.files.add("ws/own/urdf/r.urdf",
                         robot({"package://arm/meshes/gone.obj", "package://far/m.obj",
                                "package://share/m.obj", "package://none/m.obj"}));
  models.files.files.add("opt/share/far/m.obj", kTriangle);
  models.package_folders = {"elsewhere", "opt/share"};
  const LinkedModel model = models.load("ws/own/urdf/r.urdf");
  std::vector<std::string> paths;
  for (const MeshReference& mesh : model.meshes) paths.push_back(mesh.path);
  CHECK(paths == std::vector<std::string>{"ws/own/meshes/gone.obj", "opt/share/far/m.obj",
                                          "opt/share/m.obj", ""});
  CHECK(model.meshes[1].exists);
  CHECK(!model.meshes[0].exists);
}

TEST_CASE("resources: packages in folders of another name") {
  Models models;
  for (const char* folder : {"ws/arm", "ws/leg-main"}) {
    const std::string name = std::string(folder).substr(3, 3);
    models.files.files.add(std::string(folder) + "/package.xml",
                           "<package><name>" + name + "</name></package>");
    models.files.files.add(
        std::string(folder) + "/urdf/r.urdf",
        robot({"package://" + name + "/m.obj", "package://" + name + "/no.obj"}));
    models.files.files.add(std::string(folder) + "/m.obj", kTriangle);
  }
  const LinkedModel arm = models.load("ws/arm/urdf/r.urdf");
  const LinkedModel leg = models.load("ws/leg-main/urdf/r.urdf");
  CHECK(arm.meshes[0].exists);
  CHECK(leg.meshes[0].exists);
  CHECK(!arm.meshes[0].is_package_elsewhere);
  CHECK(leg.meshes[0].is_package_elsewhere);
}

TEST_CASE("resources: names that are nearly right") {
  Models models;
  models.files.files.add("r.urdf",
                         robot({"Meshes/SHADE.obj", "meshes\\shade.obj", "meshes/shades.obj"}));
  models.files.files.add("meshes/shade.obj", kTriangle);
  const LinkedModel model = models.load("r.urdf");
  CHECK(model.meshes[0].similar == "meshes/shade.obj");
  CHECK(model.meshes[1].similar == "meshes/shade.obj");
  CHECK(model.meshes[2].similar.empty());
}

TEST_CASE("resources: a name that cannot be written is not suggested") {
  Models models;
  models.files.files.add("r.urdf", robot({"M&#x85;.obj", "SHADE.obj"}));
  models.files.files.add("m\xC2\x85.obj", kTriangle);
  models.files.files.add("shade.obj", kTriangle);
  const LinkedModel model = models.load("r.urdf");
  CHECK(model.meshes[0].similar.empty());
  CHECK(model.meshes[1].similar == "shade.obj");
}

TEST_CASE("resources: a mesh above the limit is not read") {
  Models models;
  models.files.files.add("r.urdf", robot({"m.obj"}));
  models.files.files.add("m.obj", std::string(100, ' '));
  Limits limits;
  limits.mesh_bytes = 99;
  LoadContext context{models.sources, models.files, models.sink, limits, {}, {}, &models.meshes};
  const LinkedModel model = load_model("r.urdf", context);
  REQUIRE(model.meshes[0].file != nullptr);
  CHECK(model.meshes[0].file->status == ReadStatus::too_large);
}

TEST_CASE("resources: a mesh that exists from a folder above is suggested") {
  test::Loaded loaded;
  loaded.files.add("assets/arm/r.urdf",
                   "<robot name='r'><link name='a'><visual><geometry><mesh filename='arm/m/a.stl'/>"
                   "</geometry></visual></link></robot>");
  loaded.files.add("assets/arm/m/a.stl", "solid a\nendsolid a\n");
  loaded.load("assets/arm/r.urdf");
  bool is_found = false;
  for (const Diagnostic& diagnostic : loaded.diagnostics) {
    if (diagnostic.rule->id != "SML1604") continue;
    is_found = true;
    CHECK(diagnostic.help_text == "did you mean `m/a.stl`?");
  }
  CHECK(is_found);
}

TEST_CASE("resources: an STL too large for MuJoCo") {
  constexpr std::uint32_t kTriangles = 200001;
  std::string bytes(84 + std::size_t{kTriangles} * 50, '\0');
  for (std::size_t i = 0; i < 4; ++i) bytes[80 + i] = static_cast<char>(kTriangles >> (8 * i));
  for (std::size_t i = 0; i < 9; i += 4) bytes[84 + 12 + 4 * i + 3] = 0x3f;
  test::Loaded loaded;
  loaded.files.add("r.urdf",
                   "<robot name='r'><link name='a'><collision><geometry><mesh filename='m.stl'/>"
                   "</geometry></collision></link></robot>");
  loaded.files.add("m.stl", bytes);
  loaded.load("r.urdf");
  bool is_found = false;
  for (const Diagnostic& diagnostic : loaded.diagnostics) {
    if (diagnostic.rule->id != "SML1619") continue;
    is_found = true;
    CHECK(diagnostic.severity == Severity::warning);  // every other reader of URDFs loads it
    CHECK(diagnostic.message == "the collision mesh has 200001 triangles");
    for (const auto& [target, answer] :
         {std::pair{"mujoco", Answer::refuses}, {"dart", Answer::takes}}) {
      CHECK(judge_target(*find_target(target), std::vector{diagnostic}).answer() == answer);
    }
  }
  CHECK(is_found);
}
