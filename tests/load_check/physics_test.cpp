// SPDX-License-Identifier: BSD-3-Clause
// Compares the world with textbook physics.
#include "load_check/built.hpp"

using namespace smurf;
using namespace smurf::load_check;

namespace {

const std::string kBox = "<collision><geometry><box size=\"0.4 0.4 0.2\"/></geometry></collision>";

}  // namespace

TEST_CASE("a compound pendulum has the period of the formula") {
  constexpr double kMass = 2;
  constexpr double kLength = 0.5;
  constexpr double kMoment = 0.03;
  constexpr double kAmplitude = 0.1;
  const Built built(kBase + link("arm", "0 0 -0.5", kMass, kMoment) + joint("continuous", "0 1 0"),
                    Base::Kind::world, {{"j", kAmplitude}});
  World world(built.plan, {});
  CHECK(world.joint_position(0) == doctest::Approx(kAmplitude).epsilon(1e-12));
  const double period = period_of(world, [&] { return world.joint_position(0); });
  const double expected = pendulum_period(kMass, kLength, kMoment, kAmplitude);
  MESSAGE("period " << period << " s, formula " << expected << " s, off by "
                    << 100 * std::fabs(period / expected - 1) << " %");
  CHECK(std::fabs(period / expected - 1) < 5e-3);
  CHECK(world.joint_error(0).gap < 1e-5);
}

TEST_CASE("a box falls as it should and comes to rest on the ground") {
  const Built built(link("base", "0 0 0", 3, 0.05, kBox), Base::Kind::free, {},
                    Pose{{0, 0, 2}, {}});
  WorldSetup setup;
  setup.contacts = true;
  World world(built.plan, setup);
  CHECK(world.lowest_point().value() == doctest::Approx(1.9));
  world.add_ground(0);
  const double start = world.energy();
  run(world, 0.5);
  MESSAGE("after 0.5 s at " << world.body_pose(0).position[2] << " m, formula "
                            << 2 - kGravity * 0.125 << " m");
  CHECK(world.body_pose(0).position[2] == doctest::Approx(2 - kGravity * 0.125).epsilon(5e-3));
  CHECK(std::fabs(world.energy() - start) < 5e-3);
  run(world, 2.5);
  CHECK(world.body_pose(0).position[2] == doctest::Approx(0.1).epsilon(1e-2));
  CHECK(world.speed(0) < 1e-3);
}

TEST_CASE("a slider falls onto its stop") {
  const Built built(kBase + link("arm", "0 0 0", 1, 0.01) +
                        joint("prismatic", "0 0 1",
                              "<limit lower=\"-0.3\" upper=\"0.1\" effort=\"1\" velocity=\"1\"/>"),
                    Base::Kind::world);
  World world(built.plan, {});
  run(world, 0.2);
  CHECK(world.joint_position(0) == doctest::Approx(-kGravity * 0.02).epsilon(1e-2));
  run(world, 2);
  MESSAGE("at " << world.joint_position(0) << " m, stop at -0.3 m");
  CHECK(world.joint_position(0) == doctest::Approx(-0.3).epsilon(1e-3));
  CHECK(world.link_pose(built.plan.links[1]).position[2] == doctest::Approx(-0.3).epsilon(1e-3));
}

TEST_CASE("a hinge turns about its axis by the right-hand rule, from the zero of the URDF") {
  for (const double sign : {1.0, -1.0}) {
    const JointPositions positions{{"j", 0.3 * sign}};
    const std::string axis = sign > 0 ? "0 1 0" : "0 -1 0";
    const Built built(kBase + link("arm", "0.5 0 0", 1, 0.01) + joint("continuous", axis),
                      Base::Kind::world, positions);
    World world(built.plan, {});
    CHECK(world.joint_position(0) == doctest::Approx(0.3 * sign));
    // About +y, an arm along x moves down.
    run(world, 0.1);
    MESSAGE("axis " << axis << ": from " << 0.3 * sign << " to " << world.joint_position(0));
    CHECK(world.joint_position(0) * sign > 0.31);
    const JointPositions now{{"j", world.joint_position(0)}};
    const Pose expected = *forward_kinematics(built.model, now)[1];
    CHECK(angle_between(expected.orientation, world.link_pose(built.plan.links[1]).orientation) <
          1e-6);
  }
}

TEST_CASE("a stop counts from the zero of the URDF, wherever the joint starts") {
  const Built built(kBase + link("arm", "0.5 0 0", 1, 0.01) +
                        joint("revolute", "0 1 0",
                              "<limit lower=\"-1\" upper=\"0.5\" effort=\"1\" velocity=\"1\"/>"),
                    Base::Kind::world, {{"j", 0.2}});
  World world(built.plan, {});
  run(world, 3);
  CHECK(world.joint_position(0) == doctest::Approx(0.5).epsilon(1e-2));
}

TEST_CASE("links that are fixed to each other are one body with the inertia of the whole") {
  // Two cubes of 0.2 m side by side, the second one rotated, form a bar of 0.4 m.
  constexpr double kMass = 3;
  constexpr double kEdge = 0.2;
  const double cube = kMass * kEdge * kEdge / 6;
  const Built built(
      link("base", "0 0 0", kMass, cube) + link("arm", "0 0 0", kMass, cube) +
          "<joint name=\"j\" type=\"fixed\"><parent link=\"base\"/><child link=\"arm\"/>"
          "<origin xyz=\"0.2 0 0\" rpy=\"0 0 0.7853981633974483\"/></joint>",
      Base::Kind::free);
  REQUIRE(built.plan.bodies.size() == 1);
  CHECK(built.plan.joints.empty());
  const MassProperties& mass = built.plan.bodies[0].mass;
  CHECK(mass.mass == doctest::Approx(6));
  CHECK((mass.center - Eigen::Vector3d(0.1, 0, 0)).norm() < 1e-12);
  const double along = 6 * (kEdge * kEdge + kEdge * kEdge) / 12;
  const double across = 6 * (4 * kEdge * kEdge + kEdge * kEdge) / 12;
  const Eigen::Vector3d bar(along, across, across);
  MESSAGE("off by " << (mass.inertia - Eigen::Matrix3d(bar.asDiagonal())).norm() << " kg m^2");
  CHECK((mass.inertia - Eigen::Matrix3d(bar.asDiagonal())).norm() < 1e-12);
}

TEST_CASE("shapes touch unless bitmasks or joints say otherwise") {
  const std::string ball = "<collision><geometry><sphere radius=\"0.3\"/></geometry></collision>";
  const std::string links = link("base", "0 0 0", 1, 0.01, ball) +
                            link("arm", "0 0 0", 1, 0.01, ball) +
                            link("hand", "0 0 0", 1, 0.01, ball);
  const auto hinge = [](const std::string& parent, const std::string& child) {
    return "<joint name=\"" + child + "\" type=\"continuous\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/><origin xyz=\"0.25 0 0\"/></joint>";
  };
  Built built(links + hinge("base", "arm") + hinge("arm", "hand"), Base::Kind::world);
  const std::vector<Overlap> overlaps = World(built.plan, {}).overlaps();
  REQUIRE(overlaps.size() == 1);
  CHECK(overlaps[0].depth == doctest::Approx(0.1));
  CHECK(built.plan.shapes[overlaps[0].first].link == LinkIndex{0});
  CHECK(built.plan.shapes[overlaps[0].second].link == LinkIndex{2});
  built.plan.shapes[overlaps[0].second].bitmask = 2;
  CHECK(World(built.plan, {}).overlaps().size() == 1);
  built.plan.shapes[overlaps[0].first].bitmask = 1;
  CHECK(World(built.plan, {}).overlaps().empty());
}
