// SPDX-License-Identifier: BSD-3-Clause
// Poses computed by hand, and graphs that are not trees.
#include <doctest/doctest.h>

#include <cmath>

#include "smurf/load.hpp"

using namespace smurf;

namespace {

struct Arm {
  SourceMap sources;
  MemoryFiles files;
  DiagnosticSink sink;
  LinkedModel model;

  explicit Arm(const std::string& inside, const std::string& annotations = "motors: []") {
    files.add("r.smurf", "files: [r.urdf, a.yml]\n");
    files.add("r.urdf", "<robot name='r'>" + inside + "</robot>");
    files.add("a.yml", annotations);
    LoadContext context{sources, files, sink, {}, {}};
    model = load_model("r.smurf", context);
  }

  std::optional<Pose> pose(std::string_view link, const JointPositions& positions = {}) const {
    return forward_kinematics(model, positions).at(model.link_names.find(link).value());
  }
};

std::string links(std::initializer_list<const char*> names) {
  std::string all;
  for (const char* name : names) all += "<link name='" + std::string(name) + "'/>";
  return all;
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& more = {}) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/>" + more + "</joint>";
}

void check_pose(const std::optional<Pose>& pose, const Vector3& position, const Vector3& rpy) {
  REQUIRE(pose);
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::fabs(pose->position[i] - position[i]) < 1e-14);
  CHECK(angle_between(pose->orientation, from_rpy(rpy)) < 1e-14);
}

constexpr double kQuarter = 1.5707963267948966;

std::string planar_arm() {
  return links({"base", "upper", "fore", "tip"}) +
         joint("shoulder", "revolute", "base", "upper",
               "<origin xyz='0 0 1'/><axis xyz='0 0 1'/>") +
         joint("elbow", "continuous", "upper", "fore",
               "<origin xyz='2 0 0'/><axis xyz='0 0 -3'/>") +
         joint("slide", "prismatic", "fore", "tip", "<origin xyz='1 0 0' rpy='0 0 0'/>");
}

}  // namespace

TEST_CASE("kinematics: an arm in the plane") {
  const Arm arm(planar_arm());
  check_pose(arm.pose("base"), {0, 0, 0}, {0, 0, 0});
  check_pose(arm.pose("tip"), {3, 0, 1}, {0, 0, 0});
  check_pose(arm.pose("upper", {{"shoulder", kQuarter}}), {0, 0, 1}, {0, 0, kQuarter});
  check_pose(arm.pose("tip", {{"shoulder", kQuarter}}), {0, 3, 1}, {0, 0, kQuarter});
  // The elbow turns about -z; for its axis of length 3, only the direction matters.
  check_pose(arm.pose("tip", {{"shoulder", kQuarter}, {"elbow", kQuarter}}), {1, 2, 1}, {0, 0, 0});
  // Without an axis, the default is x. The slide moves along the forearm.
  check_pose(arm.pose("tip", {{"slide", 0.5}}), {3.5, 0, 1}, {0, 0, 0});
  check_pose(arm.pose("tip", {{"shoulder", kQuarter}, {"slide", 0.5}}), {0, 3.5, 1},
             {0, 0, kQuarter});
  check_pose(arm.pose("tip", {{"unknown", 9}}), {3, 0, 1}, {0, 0, 0});
}

TEST_CASE("kinematics: a tilted joint") {
  const Arm arm(
      links({"plate", "arm", "flange"}) +
      joint("j1", "revolute", "plate", "arm", "<origin xyz='0 0 0.4'/><axis xyz='0 1 0'/>") +
      joint("f", "fixed", "arm", "flange", "<origin xyz='0.3 0 0'/>"));
  check_pose(arm.pose("flange", {{"j1", 0.5}}), {0.3 * std::cos(0.5), 0, 0.4 - 0.3 * std::sin(0.5)},
             {0, 0.5, 0});
  // A fixed joint has no position.
  check_pose(arm.pose("flange", {{"f", 0.5}}), {0.3, 0, 0.4}, {0, 0, 0});
}

TEST_CASE("kinematics: origins turn what follows") {
  const Arm arm(
      links({"a", "b", "c"}) +
      joint("j", "fixed", "a", "b", "<origin xyz='1 0 0' rpy='0 0 1.5707963267948966'/>") +
      joint("k", "revolute", "b", "c",
            "<origin xyz='1 0 0' rpy='1.5707963267948966 0 0'/>"
            "<axis xyz='0 1 0'/>"));
  check_pose(arm.pose("c"), {1, 1, 0}, {kQuarter, 0, kQuarter});
  // The axis is y of the joint frame, which points up.
  check_pose(arm.pose("c", {{"k", kQuarter}}), {1, 1, 0}, {kQuarter, 0, 2 * kQuarter});
}

TEST_CASE("kinematics: mimic joints follow") {
  const auto mimic = [](const std::string& leader, const std::string& more) {
    return "<axis xyz='0 0 1'/><mimic joint='" + leader + "' " + more + "/>";
  };
  const Arm arm(links({"a", "b", "c", "d", "e"}) +
                joint("one", "revolute", "a", "b", "<axis xyz='0 0 1'/>") +
                joint("two", "revolute", "b", "c", mimic("one", "multiplier='2' offset='0.1'")) +
                joint("three", "revolute", "c", "d", mimic("two", "multiplier='-1'")) +
                joint("lost", "revolute", "a", "e", mimic("nobody", "offset='1'")));
  check_pose(arm.pose("c", {{"one", 0.2}}), {0, 0, 0}, {0, 0, 0.2 + 0.5});
  check_pose(arm.pose("d", {{"one", 0.2}}), {0, 0, 0}, {0, 0, 0.2 + 0.5 - 0.5});
  check_pose(arm.pose("c"), {0, 0, 0}, {0, 0, 0.1});
  check_pose(arm.pose("e"), {0, 0, 0}, {0, 0, 0});
  // A given position of a mimic joint is used.
  check_pose(arm.pose("c", {{"one", 0.2}, {"two", 1}}), {0, 0, 0}, {0, 0, 1.2});
}

TEST_CASE("kinematics: a circle of mimic joints ends") {
  const auto mimic = [](const std::string& leader) {
    return "<mimic joint='" + leader + "' multiplier='1'/>";
  };
  const Arm arm(links({"a", "b", "c"}) + joint("one", "revolute", "a", "b", mimic("two")) +
                joint("two", "revolute", "b", "c", mimic("one")));
  check_pose(arm.pose("c"), {0, 0, 0}, {0, 0, 0});
  const Arm self(links({"a", "b"}) + joint("one", "revolute", "a", "b", mimic("one")));
  check_pose(self.pose("b"), {0, 0, 0}, {0, 0, 0});
}

TEST_CASE("kinematics: joints without one axis stand still") {
  const Arm arm(links({"a", "b", "c", "d", "e"}) + joint("f", "floating", "a", "b") +
                joint("p", "planar", "b", "c") + joint("u", "ball", "c", "d") +
                joint("z", "revolute", "d", "e", "<axis xyz='0 0 0'/>"));
  check_pose(arm.pose("e", {{"f", 1}, {"p", 1}, {"u", 1}, {"z", 1}}), {0, 0, 0}, {0, 0, 0});
}

TEST_CASE("kinematics: trees that are none") {
  // Two links of one name, two parents, a joint to itself, unknown ends, two roots.
  const Arm arm(links({"a", "b", "b", "c", "island"}) +
                joint("j", "fixed", "a", "b", "<origin xyz='1 0 0'/>") +
                joint("again", "fixed", "c", "b", "<origin xyz='9 0 0'/>") +
                joint("self", "fixed", "a", "a") + joint("k", "fixed", "b", "c") +
                joint("up", "fixed", "nobody", "c") + joint("down", "fixed", "a", "nobody"));
  const KinematicTree& tree = arm.model.tree;
  REQUIRE(tree.roots.size() == 3);
  CHECK(to_size(tree.roots[0]) == 0);
  CHECK(to_size(tree.roots[1]) == 2);
  CHECK(to_size(tree.roots[2]) == 4);
  CHECK(to_size(*tree.parent_joint[1]) == 0);
  CHECK(tree.order.size() == 5);
  CHECK(!tree.joint_parent[4]);
  CHECK(!tree.joint_child[5]);
  check_pose(arm.pose("c"), {1, 0, 0}, {0, 0, 0});
  CHECK(!arm.pose("island"));
  CHECK(!forward_kinematics(arm.model, {})[2]);
}

TEST_CASE("kinematics: a circle of links") {
  const Arm beside(links({"root", "a", "b"}) + joint("j", "fixed", "a", "b") +
                   joint("k", "fixed", "b", "a"));
  CHECK(beside.model.tree.roots.size() == 1);
  CHECK(beside.model.tree.order.size() == 1);
  CHECK(beside.pose("root"));
  CHECK(!beside.pose("a"));
  const Arm all(links({"a", "b"}) + joint("j", "fixed", "a", "b") + joint("k", "fixed", "b", "a"));
  CHECK(all.model.tree.roots.empty());
  CHECK(!all.pose("a"));
}

TEST_CASE("kinematics: no robot, no links") {
  const Arm empty("");
  CHECK(forward_kinematics(empty.model, {}).empty());
  const Arm broken("<link");
  CHECK(!broken.model.robot);
  CHECK(forward_kinematics(broken.model, {}).empty());
}

TEST_CASE("kinematics: named joint positions") {
  const Arm arm(
      planar_arm(),
      "motors: [{name: m, joint: shoulder, type: PID}, {name: elbow, joint: slide, type: PID}]\n"
      "poses: [{name: up, joints: {m: 1, elbow: 2, wrist: 3}}, {name: up, joints: {m: 9}}]\n");
  const auto positions = joint_positions(arm.model, "up");
  REQUIRE(positions);
  // The name of a motor takes precedence over that of a joint.
  CHECK(*positions == JointPositions{{"shoulder", 1}, {"slide", 2}, {"wrist", 3}});
  CHECK(!joint_positions(arm.model, "down"));
}

TEST_CASE("kinematics: a long chain needs no stack") {
  constexpr int kLength = 20000;
  std::string text = "<link name='l0'/>";
  for (int i = 1; i <= kLength; ++i) {
    const std::string child = "l" + std::to_string(i);
    text += "<link name='" + child + "'/>" +
            joint("j" + std::to_string(i), "fixed", "l" + std::to_string(i - 1), child,
                  "<origin xyz='1 0 0'/>");
  }
  const Arm arm(text);
  const auto pose = arm.pose("l" + std::to_string(kLength));
  REQUIRE(pose);
  CHECK(pose->position[0] == doctest::Approx(kLength));
}
