// SPDX-License-Identifier: BSD-3-Clause
// The export and its proof: a proof must fail when the robot changed.
#include <doctest/doctest.h>

#include "smurf/convert.hpp"
#include "smurf/load.hpp"
#include "support/replaced.hpp"

using namespace smurf;
using smurf::test::replaced;

namespace {

const std::string kUrdf = R"(<?xml version="1.0"?>
<robot name="lamp">
  <!-- stays where it is -->
  <link name="stand">
    <inertial><mass value="2"/><inertia ixx="0.03" ixy="0" ixz="0" iyy="0.03" iyz="0" izz="0.003"/></inertial>
    <visual><geometry><mesh filename="../meshes/a&amp;b.stl"/></geometry></visual>
    <collision><geometry><mesh filename="package://lamp/meshes/b.stl"/></geometry></collision>
  </link>
  <link name="arm">
    <inertial><origin xyz="0 0 0.1"/><mass value="0.5"/><inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.0002"/></inertial>
  </link>
  <joint name="hinge" type="revolute">
    <origin xyz="0 0 0.4"/><parent link="stand"/><child link="arm"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
  </joint>
</robot>
)";

struct Read {
  SourceMap sources;
  MemoryFiles files;
  DiagnosticSink sink;
  LinkedModel model;

  explicit Read(const std::string& text) {
    files.add("lamp/urdf/lamp.urdf", text);
    LoadContext context{sources, files, sink, {}, {}};
    model = load_model("lamp/urdf/lamp.urdf", context);
    REQUIRE(model.robot);
  }
};

}  // namespace

TEST_CASE("an export edits mesh paths and nothing else") {
  const Read source(kUrdf);
  const auto to = [&](const std::string& folder) {
    UrdfExport options;
    options.output_folder = folder;
    options.current_folder = "/home/ada";
    DiagnosticSink sink;
    return export_urdf(source.model, source.sources, options, sink);
  };
  CHECK(to("lamp/urdf") == kUrdf);
  CHECK(to("lamp/other") == kUrdf);  // resolves from there as well
  CHECK(to(".") == replaced(kUrdf, "../meshes/a&amp;b.stl", "lamp/meshes/a&amp;b.stl"));
  CHECK(to("/tmp") ==
        replaced(kUrdf, "../meshes/a&amp;b.stl", "../home/ada/lamp/meshes/a&amp;b.stl"));
}

TEST_CASE("the proof holds for the same robot and names what differs") {
  const Read source(kUrdf);
  CHECK(compare_models(source.model, Read(kUrdf).model).holds());

  struct Row {
    std::string from, to, difference;
  };
  const Row rows[] = {
      {"xyz=\"0 0 0.4\"", "xyz=\"0 0 0.400000001\"", "centre of mass differs"},
      {"axis xyz=\"0 1 0\"", "axis xyz=\"0 -1 0\"", "pose of the link `arm`"},
      {"mass value=\"0.5\"", "mass value=\"0.6\"", "total mass"},
      {"<origin xyz=\"0 0 0.1\"/>", "<origin xyz=\"0 0 0.11\"/>", "centre of mass"},
      {"ixx=\"0.002\"", "ixx=\"0.003\"", "inertia"},
      {"upper=\"1\"", "upper=\"1.1\"", "limits of the joint `hinge`"},
      {"effort=\"10\"", "effort=\"11\"", "limits of the joint `hinge`"},
      {"link name=\"arm\"", "link name=\"forearm\"", "link `arm` is lost"},
      {"joint name=\"hinge\"", "joint name=\"elbow\"", "joint `hinge` is lost"},
  };
  for (const Row& row : rows) {
    CAPTURE(row.to);
    const Read changed(replaced(kUrdf, row.from, row.to));
    const Proof proof = compare_models(source.model, changed.model);
    CHECK_MESSAGE(proof.difference.find(row.difference) != std::string::npos, proof.difference);
  }
}

TEST_CASE("urdfdom is asked only what it can bear") {
  CHECK(ask_urdfdom(kUrdf).accepts);
  const RefereeVerdict refused = ask_urdfdom(replaced(kUrdf, " effort=\"10\"", ""));
  CHECK(refused.was_asked);
  CHECK_FALSE(refused.accepts);
  CHECK(refused.messages.find("effort") != std::string::npos);
  CHECK_FALSE(ask_urdfdom(replaced(kUrdf, "value=\"2\"", "value=\"%s%s%s\"")).was_asked);
}
