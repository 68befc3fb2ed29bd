// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>

#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/frames.hpp"

namespace smurf::rules::sml3713_controller_unknown_frame_file {
namespace {

/// Parameters that are links of the robot. Others, such as `odom_frame_id` and
/// `fixed_world_frame.frame.id`, are frames around it.
constexpr std::string_view kFrames[] = {
    "frame_id",         "base_frame_id",   "ft_sensor.frame.id",
    "control.frame.id", "kinematics.tip",  "gravity_compensation.frame.id",
    "kinematics.base",  "kinematics.root",
};

/// Whether the names of its frames get a prefix when the controller starts.
bool has_prefix(const RosController& controller) {
  const yaml::View prefix = controller.parameter("tf_frame_prefix");
  return prefix && prefix.is_scalar() && !prefix.text().empty();
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot || !model.is_complete) return;
  for_each_known_controller(
      companions, [&](const RosController& controller, const std::vector<RosParameter>& known) {
        if (has_prefix(controller)) return;
        for_each_parameter(controller.section, known,
                           [&](yaml::View value, const std::string& path, const RosParameter&) {
                             const bool is_frame = std::find(std::begin(kFrames), std::end(kFrames),
                                                             path) != std::end(kFrames);
                             if (!is_frame || !value.is_scalar()) return;
                             check_frame(model, value.text(), value.span(),
                                         quoted(path) + " of " + title_of(controller), findings);
                           });
      });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::breaks,
     "publishes in a frame that the robot does not have, and tf2 refuses the name",
     "geometry2 buffer_core.cpp: frame ids cannot start with a slash", when(kSlashedFrame)},
    {&readers::ros2_control, Effect::changes, "publishes in a frame that the robot does not have",
     "ros2_controllers diff_drive_controller.cpp, imu_sensor_broadcaster.cpp",
     when(kMisspeltFrame)},
    {&readers::ros2_control, Effect::ignores,
     "publishes in this frame, which another node may connect with the robot",
     "ros2_controllers diff_drive_controller.cpp, imu_sensor_broadcaster.cpp"},
};

}  // namespace

extern constinit const Rule sml3713_controller_unknown_frame{
    .id = "SML3713",
    .name = "controller-unknown-frame",
    .severity = Severity::warning,
    .summary = "A controller names a frame that is no link of the robot.",
    .remedy = "Write the name of a link.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3713_controller_unknown_frame_file
