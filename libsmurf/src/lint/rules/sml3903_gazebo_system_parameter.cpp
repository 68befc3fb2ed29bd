// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"
#include "lint/companions/frames.hpp"
#include "lint/companions/gazebo.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3903_gazebo_system_parameter_file {
namespace {

constexpr Circumstance kOldWord{"old word"};
constexpr Circumstance kMissing{"missing"};
constexpr Circumstance kSides{"sides"};
constexpr Circumstance kFrame{"frame"};

class Check {
 public:
  Check(const LinkedModel& model, const GazeboPlugin& plugin, Findings& findings)
      : model_(model), plugin_(plugin), findings_(findings) {}

  void run() {
    for (const gazebo::OldWord& one : gazebo::old_words()) {
      if (one.system == plugin_.system->name) old_word(one);
    }
    for (const gazebo::Needs& one : gazebo::needs()) {
      if (one.system == plugin_.system->name) needs(one.required);
    }
    if (plugin_.system->name == "odometry-publisher") dimensions();
    if (is_one_of(plugin_.system->name, {"diff-drive", "ackermann-steering"})) sides();
    for (const std::string_view name : {"child_frame_id", "robot_base_frame"}) {
      const xml::View frame = plugin_.element.child(name);
      if (frame) check_base(frame);
    }
  }

  /// The same joint on both sides, or each side with the name of the other.
  void sides() {
    const auto left = all("left_joint"), right = all("right_joint");
    for (const xml::View a : left) {
      for (const xml::View b : right) {
        if (text_in(a).empty() || text_in(a) != text_in(b)) continue;
        findings_
            .report(place_in(b),
                    "`right_joint` is " + quoted(text_in(b)) + ", which is `left_joint`, too")
            .label(place_in(a), "it is the left joint here")
            .help("name the joint of the right side")
            .when(kSides);
        return;
      }
    }
    const auto holds = [](xml::View one, std::string_view word, std::string_view other) {
      return text_in(one).find(word) != std::string_view::npos &&
             text_in(one).find(other) == std::string_view::npos;
    };
    if (left.size() != 1 || right.size() != 1) return;
    if (!holds(left.front(), "right", "left") || !holds(right.front(), "left", "right")) return;
    findings_
        .report(place_in(left.front()),
                "left and right are exchanged: `left_joint` is " + quoted(text_in(left.front())))
        .label(place_in(right.front()), "and `right_joint` is " + quoted(text_in(right.front())))
        .help("exchange the two names")
        .when(kSides);
  }

 private:
  void old_word(const gazebo::OldWord& word) {
    const xml::View written = plugin_.element.child(word.word);
    if (!written || plugin_.element.child(word.now)) return;
    Diagnostic& found =
        findings_.report(written.name_span(), "the system " + quoted(plugin_.system->name) +
                                                  " has no parameter " + quoted(word.word));
    found.when(kOldWord);
    const auto number = parse_number(text_in(written));
    const std::string value =
        number && word.factor != 1 ? " with " + format_rounded(*number * word.factor) : "";
    found.help("write " + quoted(word.now) + value);
  }

  void needs(std::string_view required) {
    for (std::size_t at = 0;;) {
      const std::string_view name = next_word(required, at);
      if (name.empty()) return;
      if (plugin_.element.child(name)) continue;
      Diagnostic& found = findings_.report(plugin_.element.name_span(),
                                           "the system " + quoted(plugin_.system->name) +
                                               " needs the parameter " + quoted(name));
      found.when(kMissing);
      found.help("add `<" + std::string(name) + ">`");
      return;  // one finding per plugin
    }
  }

  void dimensions() {
    const xml::View element = plugin_.element.child("dimensions");
    const auto number = element ? parse_number(text_in(element)) : std::nullopt;
    if (!element || !number || *number == 2 || *number == 3) return;
    findings_
        .report(place_in(element),
                "`dimensions` is " + quoted(text_in(element)) + ", but must be 2 or 3")
        .help("write 2 or 3")
        .when(kMissing);
  }

  std::vector<xml::View> all(std::string_view name) const {
    std::vector<xml::View> found;
    for (const xml::View child : plugin_.element) {
      if (child.name() == name) found.push_back(child);
    }
    return found;
  }

  void check_base(xml::View frame) {
    Diagnostic* found =
        check_frame(model_, text_in(frame), place_in(frame),
                    quoted(frame.name()) + " of " + quoted(plugin_.system->name), findings_);
    if (found == nullptr) return;
    found->when(kFrame);
    // The frame of the robot is one of its own.
    if (found->severity == Severity::info && model_.is_complete)
      found->severity = Severity::warning;
  }

  const LinkedModel& model_;
  const GazeboPlugin& plugin_;
  Findings& findings_;
};

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const GazeboPlugin& plugin : gazebo_plugins(model)) {
    if (plugin.system != nullptr) {
      Check(model, plugin, findings).run();
    } else if (plugin.file == "libgazebo_ros_diff_drive.so") {
      Check(model, plugin, findings).sides();
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses,
     "ignores the parameter, and uses the default of the one that is meant",
     "gz-sim src/systems of ign-gazebo6 to gz-sim10", when(kOldWord)},
    {&readers::gazebo, Effect::breaks, "reports an error, and the system does nothing",
     "gz-sim src/systems of ign-gazebo6 to gz-sim10", when(kMissing)},
    {&readers::gazebo, Effect::changes, "turns the robot the wrong way",
     "gz-sim src/systems/diff_drive/DiffDrive.cc", when(kSides)},
    {&readers::gazebo, Effect::changes, "publishes a frame that no link of the robot has",
     "gz-sim DiffDrive.cc, OdometryPublisher.cc", when(kFrame)},
};

}  // namespace

extern constinit const Rule sml3903_gazebo_system_parameter{
    .id = "SML3903",
    .name = "gazebo-system-parameter",
    .severity = Severity::warning,
    .summary =
        "A parameter of a system of Gazebo is missing, of Gazebo Classic, or names the wrong side.",
    .why = "Systems ignore unknown parameters without a message.",
    .remedy = "Write the parameter that the system reads.",
    .check_companions = check,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml3903_gazebo_system_parameter_file
