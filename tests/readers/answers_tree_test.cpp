// SPDX-License-Identifier: BSD-3-Clause
// The printed verdicts of targets on a robot with more links, joints or extensions.
#include <doctest/doctest.h>

#include "readers/answers.hpp"

using namespace smurf;

TEST_CASE("MuJoCo refuses settings that it cannot read") {
  using enum Answer;
  const auto answer_with = [](std::string_view settings) {
    return answer_to("mujoco", with("<mujoco>" + std::string(settings) + "</mujoco>"));
  };
  CHECK(answer_with("<size memory=\"-1\"/>") == takes);
  CHECK(answer_with("<size memory=\"1M\"/>") == unknown);
  CHECK(answer_with("<size memory=\"1MB\"/>") == refuses);
  CHECK(answer_with("<size memory=\"1e6\"/>") == refuses);
  CHECK(answer_with("<size nconmax=\"-1\"/>") == takes);
  CHECK(answer_with("<size nconmax=\"-2\"/>") == refuses);
  CHECK(answer_with("<size nuser_body=\"1.5\"/>") == refuses);
  CHECK(answer_with("<option iterations=\"\"/>") == takes);
  CHECK(answer_with("<option iterations=\"5.5\"/>") == refuses);
  CHECK(answer_with("<option timestep=\"1e-310\"/>") == refuses);
  CHECK(answer_with("<option o_solref=\"1\"/>") == takes);
  CHECK(answer_with("<option o_solref=\"1 2 3\"/>") == refuses);
  CHECK(answer_with("<option actuatorgroupdisable=\"31\"/>") == refuses);
  CHECK(answer_with("<option/><option/>") == refuses);
  CHECK(answer_with("<option><flag gravity=\"disable\"/></option>") == takes);
  CHECK(answer_with("<option><flag gravity=\"off\"/></option>") == refuses);
  CHECK(answer_with("<compiler inertiagrouprange=\"1\"/>") == refuses);
}

TEST_CASE("a body can float in what is fixed to the root, which MuJoCo makes a part of the world") {
  const std::string tip = std::string(kTip) + joint("f", "floating", "arm", "tip");
  const std::string fixed = damaged("revolute", "fixed");
  CHECK(answer_to("mujoco", with(tip, fixed)) == Answer::takes);
  CHECK(answer_to("mujoco", with(tip)) == Answer::refuses);
  CHECK(answer_to("mujoco", with(tip + "<mujoco><compiler fusestatic=\"false\"/></mujoco>",
                                 fixed)) == Answer::refuses);
}

TEST_CASE("MuJoCo builds joints that mimic each other, but none that mimics itself") {
  using enum Answer;
  constexpr std::string_view kLimit =
      "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
  const auto mimic = [&](std::string_view followed) {
    return std::string(kLimit) + "<mimic joint=\"" + std::string(followed) + "\"/>";
  };
  const auto tip = [&](std::string_view type, std::string_view followed) {
    return std::string(kTip) + joint("b", type, "arm", "tip", mimic(followed));
  };
  const std::string follower = damaged("velocity=\"1\"/>", "velocity=\"1\"/><mimic joint=\"b\"/>");
  CHECK(answer_to("mujoco", with(tip("revolute", "a"), follower)) == loses);
  CHECK(answer_to("mujoco", with(tip("revolute", "b"))) == refuses);
  CHECK(answer_to("mujoco", with(tip("fixed", "b"))) == takes);
  const std::string far = std::string(kLimit) + "<mimic joint=\"a\" offset=\"1e200\"/>";
  CHECK(answer_to("mujoco", with(std::string(kTip) + joint("b", "revolute", "arm", "tip", far))) ==
        loses);
}

TEST_CASE("sdformat does not build joints to links that it drops") {
  using enum Answer;
  const auto answer_with = [](std::string_view link, std::string_view type) {
    return answer_to("gazebo", with(std::string(link) + joint("f", type, "arm", "tip")));
  };
  CHECK(answer_with(kTip, "floating") == refuses);
  CHECK(answer_with(kFrame, "floating") != refuses);
  CHECK(answer_with(kTip, "planar") == refuses);
  CHECK(answer_with(kFrame, "planar") != refuses);
  CHECK(answer_to("gazebo", with(std::string(kTip) + joint("tip", "continuous", "arm", "tip"))) ==
        refuses);
  CHECK(answer_to("gazebo", with(std::string(kFrame) + joint("tip", "continuous", "arm", "tip"))) !=
        refuses);
}

TEST_CASE("sdformat merges a link into both of its parents if its last joint is fixed") {
  using enum Answer;
  const auto answer_with = [](std::string_view last) {
    return answer_to("gazebo", with(std::string(kTip) + joint("b", "fixed", "base", "tip") +
                                    joint("c", last, "arm", "tip")));
  };
  CHECK(answer_with("fixed") == loses);
  CHECK(answer_with("continuous") == refuses);
}

TEST_CASE("sdformat drops a root without mass if it is told to keep its fixed joint") {
  std::string robot = damaged("revolute", "fixed");
  const std::size_t inertial = robot.find("  <inertial>");
  robot.erase(inertial, robot.find("  <collision>") - inertial);
  CHECK(answer_to("gazebo", robot) != Answer::refuses);
  CHECK(answer_to("gazebo", with("<gazebo reference=\"a\"><preserveFixedJoint> true "
                                 "</preserveFixedJoint></gazebo>",
                                 robot)) == Answer::refuses);
}

TEST_CASE("Gazebo leaves out what a misspelt element means") {
  using enum Answer;
  const auto answer_with = [](std::string_view element) {
    return answer_to("gazebo",
                     with("<gazebo reference=\"arm\">" + std::string(element) + "</gazebo>"));
  };
  CHECK(answer_with("<mu1>1</mu1>") == takes);
  CHECK(answer_with("<m1u>1</m1u>") == loses);
  CHECK(answer_with("<MaxVel>1</MaxVel>") == loses);
  CHECK(answer_with("<gravity>true</gravity>") == takes);
}

TEST_CASE("whether Gazebo accepts masses that are merged from far away is not known") {
  const auto answer_at = [](std::string_view distance) {
    const std::string origin = "<origin xyz=\"" + std::string(distance) + " 0 0\"/>";
    return answer_to("gazebo", with(std::string(kTip) + joint("f", "fixed", "arm", "tip", origin)));
  };
  CHECK(answer_at("1") == Answer::takes);
  CHECK(answer_at("1e6") == Answer::unknown);
}

TEST_CASE("whether Gazebo accepts the sum of inertias that are 0 or unreadable is not known") {
  const auto answer_with = [](std::string_view first, std::string_view second) {
    const auto link = [](std::string_view name, std::string_view ixx) {
      return "<link name=\"" + std::string(name) +
             "\"><inertial><mass value=\"1\"/><inertia ixy=\"0\" ixz=\"0\" iyz=\"0\" iyy=\"0\" "
             "izz=\"0\" ixx=\"" +
             std::string(ixx) + "\"/></inertial></link>";
    };
    return answer_to("gazebo", with(link("tip", first) + link("nail", second) +
                                    joint("t", "fixed", "tip", "nail", R"(<origin xyz="1 2 3"/>)") +
                                    joint("n", "continuous", "arm", "tip")));
  };
  CHECK(answer_with("0", "0") == Answer::unknown);
  CHECK(answer_with("abc", "nan") == Answer::unknown);
}

TEST_CASE("MuJoCo checks each inertia, also where nothing moves") {
  const std::string tip =
      "<link name=\"tip\"><inertial><mass value=\"1\"/><inertia ixx=\"1e308\" ixy=\"0\" ixz=\"0\" "
      "iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>";
  CHECK(answer_to("mujoco", with(tip + joint("f", "fixed", "base", "tip"))) == Answer::refuses);
}
