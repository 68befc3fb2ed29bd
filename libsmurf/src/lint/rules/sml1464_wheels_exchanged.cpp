// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/path.hpp"
#include "base/numbers/vectors.hpp"
#include "base/ranges.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/queries.hpp"
#include "lint/sides.hpp"

namespace smurf::rules::sml1464_wheels_exchanged_file {
namespace {

/// The elements of a plugin that name joints of one side.
struct Wheels {
  std::vector<xml::View> left, right;
};

Wheels wheels_of(xml::View plugin) {
  Wheels wheels;
  for (const xml::View child : plugin) {
    const std::string name = path::to_lower(child.name());
    if (name.find("joint") == std::string::npos) continue;
    const bool is_left = name.find("left") != std::string::npos;
    const bool is_right = name.find("right") != std::string::npos;
    if (is_left == is_right) continue;
    (is_left ? wheels.left : wheels.right).push_back(child);
  }
  return wheels;
}

/// Whether `left` is the name of the right one of two sides, and `right` that of the left one.
bool are_exchanged(std::string_view left, std::string_view right) {
  return ranges::contains(right_names_of(right), std::string(left));
}

/// The axes of joints in the frame of the root, while all joints are at zero.
class Axes {
 public:
  explicit Axes(const LinkedModel& model) : model_(model) {}

  std::optional<Vector3> of(std::string_view name) {
    const auto index = model_.joint_index(name);
    if (!index) return std::nullopt;
    const auto child = model_.tree.joint_child[to_size(*index)];
    if (!child) return std::nullopt;
    if (!poses_) poses_ = forward_kinematics(model_, {});
    const auto& pose = (*poses_)[to_size(*child)];
    const Vector3 axis = model_.joint(*index).axis.value_or({1, 0, 0});
    const double length = std::sqrt(dot(axis, axis));
    if (!pose || !(length > 0)) return std::nullopt;
    return rotate(pose->orientation, {axis[0] / length, axis[1] / length, axis[2] / length});
  }

 private:
  const LinkedModel& model_;
  std::optional<std::vector<std::optional<Pose>>>
      poses_;  ///< few robots have such wheels, and some have many
};

/// The name of a joint, where somebody gives it to one side.
struct Wheel {
  std::string_view name;
  Span place;
};

/// `drive`: what gives both wheels the same sign, "the plugin".
void check_axes(Axes& axes, const Wheel& left, const Wheel& right, const std::string& drive,
                Findings& findings) {
  constexpr double kOpposite = -0.9;  // cosine
  const auto a = axes.of(left.name);
  const auto b = axes.of(right.name);
  if (!a || !b || dot(*a, *b) > kOpposite) return;
  findings
      .report(left.place, "the axes of the wheel joints " + quoted(left.name) + " and " +
                              quoted(right.name) + " point in opposite directions")
      .label(right.place, "the other side")
      .help("write the same `axis` for both: " + drive +
            " gives both the same sign to drive straight, and the robot would turn");
}

void check_pair(Axes& axes, xml::View left, xml::View right, Findings& findings) {
  const Wheel one{trimmed(left.text()), left.text_span()};
  const Wheel other{trimmed(right.text()), right.text_span()};
  if (!are_exchanged(one.name, other.name)) {
    return check_axes(axes, one, other, "the plugin", findings);
  }
  if (left.name() == "left_joint") return;  // SML3903
  findings
      .report(one.place, "the plugin takes " + quoted(one.name) + " for a left wheel and " +
                             quoted(other.name) + " for a right one")
      .label(other.place, "the other side")
      .help("exchange the two names, or the robot turns the wrong way");
}

/// The wheels of a differential drive of ros2_controllers.
void check_controllers(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot) return;
  Axes axes(model);
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& one : file.controllers) {
      if (one.known == nullptr || one.known->name != "diff_drive_controller/DiffDriveController")
        continue;
      const auto left = one.list("left_wheel_names"), right = one.list("right_wheel_names");
      for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i) {
        check_axes(axes, {left[i].text(), left[i].span()}, {right[i].text(), right[i].span()},
                   "the controller", findings);
      }
    }
  });
}

void find_plugins(Axes& axes, xml::View element, Findings& findings) {
  for (const xml::View child : element) {
    if (child.name() != "plugin") {
      find_plugins(axes, child, findings);
      continue;
    }
    const Wheels wheels = wheels_of(child);
    for (std::size_t i = 0; i < std::min(wheels.left.size(), wheels.right.size()); ++i) {
      check_pair(axes, wheels.left[i], wheels.right[i], findings);
    }
  }
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  Axes axes(model);
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() == "gazebo") find_plugins(axes, gazebo, findings);
  }
}

}  // namespace

extern constinit const Rule sml1464_wheels_exchanged{
    .id = "SML1464",
    .name = "wheels-exchanged",
    .severity = Severity::warning,
    .summary = "A plugin drives the wheels of the two sides in a way that turns the robot.",
    .why = "The robot turns away from the goal, or spins when it should drive straight, while its "
           "odometry says that it drives.",
    .remedy = "Name the joints of the left side as left ones, and give both sides the same axis.",
    .sources = "create_robot issue 77, ros2_controllers issue 597. By the words for sides in the "
               "names of the elements and joints.",
    .check_model = check,
    .check_companions = check_controllers,
    .about = About::robot};

}  // namespace smurf::rules::sml1464_wheels_exchanged_file
