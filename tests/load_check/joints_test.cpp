// SPDX-License-Identifier: BSD-3-Clause
// Joints with several degrees of freedom, compared with textbook physics.
#include <Eigen/Geometry>
#include <numbers>

#include "load_check/built.hpp"

using namespace smurf;
using namespace smurf::load_check;

namespace {

/// A pendulum below the base, with different moments about x and y; joint `j` as annotated.
std::string hanging_arm(double mass, double length, double moment_x, double moment_y) {
  return kBase + "<link name=\"arm\"><inertial><origin xyz=\"0 0 -" + std::to_string(length) +
         "\"/><mass value=\"" + std::to_string(mass) + "\"/><inertia ixx=\"" +
         std::to_string(moment_x) + "\" ixy=\"0\" ixz=\"0\" iyy=\"" + std::to_string(moment_y) +
         "\" iyz=\"0\" izz=\"0.05\"/></inertial></link>" + joint("continuous", "1 0 0");
}

/// Gravity turned about an axis, so that a body hanging along -z swings about it.
WorldSetup tilted(const Eigen::Vector3d& axis, double angle) {
  WorldSetup setup;
  setup.gravity = Eigen::AngleAxisd(angle, axis) * Eigen::Vector3d(0, 0, -kGravity);
  return setup;
}

/// Angle of the arm about an axis, relative to the direction of gravity.
double angle_about(const World& world, const Plan& plan, const Eigen::Vector3d& axis, double rest) {
  const Vector3 down = rotate(world.link_pose(plan.links[1]).orientation, {0, 0, -1});
  const Eigen::Vector3d side = axis.cross(Eigen::Vector3d(0, 0, -1));
  return std::atan2(to_eigen(down).dot(side), -down[2]) - rest;
}

const char* const kUniversal =
    "joint:\n- {name: j, type: universal, axis1: {x: 1}, axis2: {y: 1}}\n";

}  // namespace

TEST_CASE("a universal joint swings about both axes with the period of the formula, and no third") {
  constexpr double kMass = 2;
  constexpr double kLength = 0.5;
  constexpr double kAmplitude = 0.1;
  const Built built(hanging_arm(kMass, kLength, 0.02, 0.06), Base::Kind::world, {}, {}, kUniversal);
  REQUIRE(built.plan.joints.size() == 1);
  CHECK(built.plan.joints[0].kind == JointKind::universal);
  for (const bool is_first : {true, false}) {
    const Eigen::Vector3d axis =
        is_first ? Eigen::Vector3d::UnitX() : Eigen::Vector3d(Eigen::Vector3d::UnitY());
    World world(built.plan, tilted(axis, kAmplitude));
    const double period =
        period_of(world, [&] { return angle_about(world, built.plan, axis, kAmplitude); });
    const double expected = pendulum_period(kMass, kLength, is_first ? 0.02 : 0.06, kAmplitude);
    MESSAGE("period " << period << " s, formula " << expected << " s");
    CHECK(std::fabs(period / expected - 1) < 5e-3);
    CHECK(world.joint_error(0).gap < 1e-5);
    CHECK(world.joint_error(0).angle < 1e-6);
  }
}

TEST_CASE(
    "the axes of a universal joint are those of the root's frame, wherever the robot stands") {
  const Pose X_WR{{1, 2, 3}, from_rpy({0, 0, std::numbers::pi / 2})};
  const Built built(hanging_arm(1, 0.5, 0.02, 0.02), Base::Kind::world, {}, X_WR, kUniversal);
  CHECK((built.plan.joints[0].axis_W - Eigen::Vector3d::UnitY()).norm() < 1e-12);
  CHECK((built.plan.joints[0].axis2_W + Eigen::Vector3d::UnitX()).norm() < 1e-12);
}

TEST_CASE("an annotated type replaces that of the URDF") {
  const auto kind_of = [](const std::string& type) {
    const Built built(hanging_arm(1, 0.5, 0.02, 0.02), Base::Kind::world, {}, {},
                      "joint:\n- {name: j, type: " + type + "}\n");
    return built.plan.joints.empty() ? std::nullopt : std::optional(built.plan.joints[0].kind);
  };
  CHECK(kind_of("hinge") == JointKind::hinge);
  CHECK(kind_of("slider") == JointKind::slider);
  CHECK(kind_of("ball") == JointKind::ball);
  CHECK(kind_of("fixed") == std::nullopt);
}

TEST_CASE("on a slope a planar joint slides freely, and neither lifts nor tilts") {
  constexpr double kSlope = std::numbers::pi / 6;
  const std::string normal =
      std::to_string(std::sin(kSlope)) + " 0 " + std::to_string(std::cos(kSlope));
  const Built built(kBase + link("arm", "0.2 0.1 0.3", 1, 0.01) + joint("planar", normal),
                    Base::Kind::world);
  REQUIRE(built.plan.joints[0].kind == JointKind::planar);
  World world(built.plan, {});
  const double start = world.energy();
  run(world, 1);
  const Vector3 p = world.link_pose(built.plan.links[1]).position;
  const double way = std::hypot(p[0], p[1], p[2]);
  const double expected = kGravity * std::sin(kSlope) / 2;
  MESSAGE("slid " << way << " m, formula " << expected << " m");
  CHECK(way == doctest::Approx(expected).epsilon(5e-3));
  CHECK(p[0] == doctest::Approx(way * std::cos(kSlope)).epsilon(1e-5));
  CHECK(world.joint_error(0).gap < 1e-9);
  CHECK(world.joint_error(0).angle < 1e-9);
  CHECK(std::fabs(world.energy() - start) < 5e-3);
}

TEST_CASE("a planar joint between two moving bodies keeps the energy") {
  // A plate swings about y; a puck lies on it and starts to slide when the plate has tilted.
  const std::string puck =
      link("puck", "0.1 0 0.05", 0.5, 0.002) +
      "<joint name=\"slide\" type=\"planar\"><parent link=\"arm\"/><child link=\"puck\"/>"
      "<axis xyz=\"0 0 1\"/></joint>";
  const Built built(kBase + link("arm", "0.3 0 0", 1, 0.02) + joint("continuous", "0 1 0") + puck,
                    Base::Kind::world);
  World world(built.plan, {});
  const double start = world.energy();
  double worst_gap = 0;
  double worst_angle = 0;
  for (int i = 0; i < 1000; ++i) {
    world.step();
    worst_gap = std::fmax(worst_gap, world.joint_error(1).gap);
    worst_angle = std::fmax(worst_angle, world.joint_error(1).angle);
  }
  const double way = (world.body_pose(1).position[0] - 0.1);
  MESSAGE("puck moved " << way << " m; gap " << worst_gap << " m, tilt " << worst_angle
                        << " rad, energy " << world.energy() - start << " m");
  CHECK(std::fabs(way) > 0.1);
  CHECK(worst_gap < 1e-3);
  CHECK(worst_angle < 1e-3);
  CHECK(std::fabs(world.energy() - start) < 2e-2);
}

TEST_CASE("a floating joint leaves all six freedoms") {
  const Built built(kBase + link("arm", "0 0 0", 1, 0.01) + joint("floating", "0 0 1"),
                    Base::Kind::world);
  World world(built.plan, {});
  run(world, 1);
  CHECK(world.body_pose(0).position[2] == doctest::Approx(-kGravity / 2).epsilon(5e-3));
}

TEST_CASE("a mimicking joint starts where its leader puts it, inside its limits") {
  const std::string follower =
      "<joint name=\"k\" type=\"revolute\"><parent link=\"arm\"/><child link=\"hand\"/>"
      "<axis xyz=\"0 1 0\"/><limit lower=\"0.2\" upper=\"1\" effort=\"1\" velocity=\"1\"/>"
      "<mimic joint=\"j\" multiplier=\"2\" offset=\"0.3\"/></joint>";
  const Built built(kBase + link("arm", "0 0 -0.5", 1, 0.01) + link("hand", "0 0 -0.2", 1, 0.01) +
                        joint("continuous", "0 1 0") + follower,
                    Base::Kind::world, {{"j", 0.1}});
  CHECK(built.plan.joints[1].start == doctest::Approx(0.5));
  WorldSetup weightless;
  weightless.gravity.setZero();
  World world(built.plan, weightless);
  run(world, 0.1);
  CHECK(world.joint_position(1) == doctest::Approx(0.5).epsilon(1e-9));
}
