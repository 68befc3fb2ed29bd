// SPDX-License-Identifier: BSD-3-Clause
// Every element of URDF is read into its struct, with its byte span.
#include "ast/urdf_reader.hpp"

#include <doctest/doctest.h>

#include "unit/parsed.hpp"

using namespace smurf;
using smurf::test::join;
using smurf::test::ParsedXml;

namespace {

/// A text read up to urdf::Robot.
struct ReadUrdf {
  ParsedXml xml;
  std::optional<urdf::Robot> robot;

  explicit ReadUrdf(const std::string& text) : xml(text) {
    REQUIRE(xml.document);
    robot = read_urdf(std::move(*xml.document), xml.sink);
  }
  template <class T>
  std::string slice(const Field<T>& field) const {
    return std::string(xml.sources.text(field.span));
  }
};

ReadUrdf read_in_robot(const std::string& inside) {
  return ReadUrdf("<robot name='r'>" + inside + "</robot>");
}

}  // namespace

TEST_CASE("urdf: a link with everything") {
  const ReadUrdf read = read_in_robot(R"(
    <material name='red'><color rgba='1 0 0 0.5'/></material>
    <material name='wood'><texture filename='wood.png'/></material>
    <link name='arm'>
      <inertial><origin xyz='1 2 3' rpy='0.1 0.2 0.3'/><mass value='4.5'/>
        <inertia ixx='1' ixy='2' ixz='3' iyy='4' iyz='5' izz='6'/></inertial>
      <visual name='v1'><origin xyz='0 0 1'/><geometry><box size='1 2 3'/></geometry>
        <material name='red'/></visual>
      <visual><geometry><mesh filename='package://p/m.stl' scale='2 2 2'/></geometry>
        <material name='own'><color rgba='0 1 0 1'/><texture filename='t.png'/></material></visual>
      <collision name='c1'><geometry><sphere radius='0.5'/></geometry></collision>
      <collision><geometry><cylinder radius='1' length='2'/></geometry></collision>
      <collision><origin rpy='0 0 1'/><geometry><capsule radius='3' length='4'/></geometry></collision>
    </link>)");
  CHECK(join(read.xml.briefs()) == "");
  REQUIRE(read.robot);
  const urdf::Robot& robot = *read.robot;
  CHECK(*robot.name == "r");
  CHECK(!robot.version.written);

  REQUIRE(robot.materials.size() == 2);
  CHECK(*robot.materials[0].name == "red");
  CHECK(*robot.materials[0].rgba == std::array<double, 4>{1, 0, 0, 0.5});
  CHECK(!robot.materials[0].texture.written);
  CHECK(*robot.materials[1].texture == "wood.png");

  REQUIRE(robot.links.size() == 1);
  const urdf::Link& link = robot.links[0];
  CHECK(*link.name == "arm");
  CHECK(read.slice(link.name) == "arm");
  CHECK(read.xml.sources.text(link.span).starts_with("<link name='arm'>"));
  CHECK(read.xml.sources.text(link.span).ends_with("</link>"));
  REQUIRE(link.inertial);
  CHECK(*link.inertial->mass == 4.5);
  CHECK(read.slice(link.inertial->mass) == "4.5");
  CHECK(*link.inertial->origin.xyz == Vector3{1, 2, 3});
  CHECK(*link.inertial->origin.rpy == Vector3{0.1, 0.2, 0.3});
  CHECK(*link.inertial->ixx == 1);
  CHECK(*link.inertial->ixy == 2);
  CHECK(*link.inertial->ixz == 3);
  CHECK(*link.inertial->iyy == 4);
  CHECK(*link.inertial->iyz == 5);
  CHECK(*link.inertial->izz == 6);

  REQUIRE(link.visuals.size() == 2);
  CHECK(*link.visuals[0].name == "v1");
  CHECK(*link.visuals[0].origin.xyz == Vector3{0, 0, 1});
  CHECK(!link.visuals[0].origin.rpy.written);
  CHECK(*std::get<urdf::Box>(link.visuals[0].geometry.shape).size == Vector3{1, 2, 3});
  CHECK(*link.visuals[0].material->name == "red");
  CHECK(!link.visuals[0].material->rgba.written);
  CHECK(!link.visuals[1].name.written);
  CHECK(link.visuals[1].origin.element == xml::kNoElement);
  const auto& mesh = std::get<urdf::Mesh>(link.visuals[1].geometry.shape);
  CHECK(*mesh.filename == "package://p/m.stl");
  CHECK(*mesh.scale == Vector3{2, 2, 2});
  CHECK(*link.visuals[1].material->texture == "t.png");

  REQUIRE(link.collisions.size() == 3);
  CHECK(*link.collisions[0].name == "c1");
  CHECK(*std::get<urdf::Sphere>(link.collisions[0].geometry.shape).radius == 0.5);
  const auto& cylinder = std::get<urdf::Cylinder>(link.collisions[1].geometry.shape);
  CHECK(*cylinder.radius == 1);
  CHECK(*cylinder.length == 2);
  const auto& capsule = std::get<urdf::Capsule>(link.collisions[2].geometry.shape);
  CHECK(*capsule.radius == 3);
  CHECK(*capsule.length == 4);
  CHECK(*link.collisions[2].origin.rpy == Vector3{0, 0, 1});
}

TEST_CASE("urdf: a joint with everything") {
  const ReadUrdf read = read_in_robot(R"(<link name='a'/><link name='b'/>
    <joint name='j' type='prismatic'>
      <origin xyz='1 2 3' rpy='0 0 1'/><parent link='a'/><child link='b'/><axis xyz='0 0 2'/>
      <limit lower='-1' upper='2' effort='3' velocity='4'/>
      <dynamics damping='5' friction='6'/>
      <mimic joint='k' multiplier='7' offset='8'/>
      <safety_controller soft_lower_limit='9' soft_upper_limit='10' k_position='11' k_velocity='12'/>
      <calibration rising='13' falling='14'/>
    </joint>)");
  CHECK(join(read.xml.briefs()) == "");
  REQUIRE(read.robot->joints.size() == 1);
  const urdf::Joint& joint = read.robot->joints[0];
  CHECK(*joint.name == "j");
  CHECK(joint.type == urdf::JointType::prismatic);
  CHECK(read.slice(joint.type_name) == "prismatic");
  CHECK(*joint.origin.xyz == Vector3{1, 2, 3});
  CHECK(*joint.parent == "a");
  CHECK(*joint.child == "b");
  CHECK(*joint.axis == Vector3{0, 0, 2});
  CHECK(*joint.limit->lower == -1);
  CHECK(*joint.limit->upper == 2);
  CHECK(*joint.limit->effort == 3);
  CHECK(*joint.limit->velocity == 4);
  CHECK(*joint.dynamics->damping == 5);
  CHECK(*joint.dynamics->friction == 6);
  CHECK(*joint.mimic->joint == "k");
  CHECK(*joint.mimic->multiplier == 7);
  CHECK(*joint.mimic->offset == 8);
  CHECK(*joint.safety_controller->soft_lower_limit == 9);
  CHECK(*joint.safety_controller->soft_upper_limit == 10);
  CHECK(*joint.safety_controller->k_position == 11);
  CHECK(*joint.safety_controller->k_velocity == 12);
  CHECK(*joint.calibration->rising == 13);
  CHECK(*joint.calibration->falling == 14);
}

TEST_CASE("urdf: joint types") {
  using enum urdf::JointType;
  struct Row {
    std::string name;
    urdf::JointType type;
    bool is_movable, has_one_axis;
  };
  const Row rows[] = {{"revolute", revolute, true, true},   {"continuous", continuous, true, true},
                      {"prismatic", prismatic, true, true}, {"fixed", fixed, false, false},
                      {"floating", floating, true, false},  {"planar", planar, true, false},
                      {"Revolute", unknown, false, false},  {"", unknown, false, false}};
  for (const Row& row : rows) {
    CAPTURE(row.name);
    const ReadUrdf read = read_in_robot("<joint name='j' type='" + row.name + "'/>");
    const urdf::Joint& joint = read.robot->joints.at(0);
    CHECK(joint.type == row.type);
    CHECK(joint.is_movable() == row.is_movable);
    CHECK(joint.has_one_axis() == row.has_one_axis);
  }
}

TEST_CASE("urdf: what is not written stays absent") {
  const ReadUrdf read = read_in_robot("<link/><joint/><link name='a'><visual/><collision/></link>");
  REQUIRE(read.robot->links.size() == 2);
  CHECK(!read.robot->links[0].name.written);
  CHECK(!read.robot->links[0].inertial);
  const urdf::Joint& joint = read.robot->joints.at(0);
  CHECK(!joint.name.written);
  CHECK(joint.type == urdf::JointType::unknown);
  CHECK(joint.origin.element == xml::kNoElement);
  CHECK(!joint.axis.written);
  CHECK(!joint.limit);
  CHECK(!joint.mimic);
  CHECK(urdf::to_pose(joint.origin) == Pose{});
  const urdf::Link& link = read.robot->links[1];
  CHECK(std::holds_alternative<std::monostate>(link.visuals.at(0).geometry.shape));
  CHECK(link.collisions.at(0).geometry.element == xml::kNoElement);
}

TEST_CASE("urdf: what cannot be understood is written but has no value") {
  const ReadUrdf read = read_in_robot(
      "<link name='a'><inertial><mass value='heavy'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' "
      "iyz='0' izz='1'/></inertial><visual><origin xyz='1 2'/><geometry><cone/></geometry></visual></link>");
  const urdf::Link& link = read.robot->links.at(0);
  CHECK(link.inertial->mass.written);
  CHECK(!link.inertial->mass);
  CHECK(read.slice(link.inertial->mass) == "heavy");
  CHECK(link.visuals.at(0).origin.xyz.written);
  CHECK(!link.visuals.at(0).origin.xyz);
  CHECK(std::holds_alternative<std::monostate>(link.visuals.at(0).geometry.shape));
  CHECK(link.visuals.at(0).geometry.shape_element != xml::kNoElement);
}

TEST_CASE("urdf: order and duplicates are the author's") {
  const ReadUrdf read = read_in_robot(
      "<joint name='j1'/><link name='b'/><transmission name='t'/><link name='a'/><gazebo/>"
      "<joint name='j2'/><link name='b'/><x:y xmlns:x='u'/>");
  const urdf::Robot& robot = *read.robot;
  REQUIRE(robot.links.size() == 3);
  CHECK(*robot.links[0].name == "b");
  CHECK(*robot.links[1].name == "a");
  CHECK(*robot.links[2].name == "b");
  CHECK(robot.joints.size() == 2);
  REQUIRE(robot.extensions.size() == 3);
  CHECK(xml::View(robot.document, robot.extensions[0]).name() == "transmission");
  CHECK(xml::View(robot.document, robot.extensions[1]).name() == "gazebo");
  CHECK(xml::View(robot.document, robot.extensions[2]).name() == "x:y");
}

TEST_CASE("urdf: of a repeated single element the first counts") {
  const ReadUrdf read = read_in_robot(
      "<link name='a'><inertial><mass value='1'/></inertial><inertial><mass value='2'/></inertial>"
      "</link><joint name='j'><origin xyz='1 0 0'/><origin xyz='2 0 0'/></joint>");
  CHECK(*read.robot->links.at(0).inertial->mass == 1);
  CHECK(*read.robot->joints.at(0).origin.xyz == Vector3{1, 0, 0});
}

TEST_CASE("urdf: entities in names are decoded, spans show the bytes") {
  const ReadUrdf read = read_in_robot("<link name='a&amp;b'/>");
  CHECK(*read.robot->links.at(0).name == "a&b");
  CHECK(read.slice(read.robot->links[0].name) == "a&amp;b");
}

TEST_CASE("urdf: an origin as a transform") {
  const ReadUrdf read =
      read_in_robot("<joint><origin xyz='1 2 3' rpy='0 0 1.5707963267948966'/></joint>"
                    "<joint><origin rpy='0 0 0.5'/></joint>");
  const Pose pose = urdf::to_pose(read.robot->joints.at(0).origin);
  CHECK(pose.position == Vector3{1, 2, 3});
  CHECK(angle_between(pose.orientation, from_rpy_degrees({0, 0, 90})) < 1e-15);
  CHECK(urdf::to_pose(read.robot->joints.at(1).origin).position == Vector3{0, 0, 0});
}

TEST_CASE("urdf: another root is no robot") {
  CHECK(!ReadUrdf("<sdf version='1.6'/>").robot);
  CHECK(join(ReadUrdf("<sdf version='1.6'/>").xml.briefs()) == join({"SML1101 1:2 [sdf]"}));
  CHECK(!ReadUrdf("<Robot name='r'/>").robot);
}
