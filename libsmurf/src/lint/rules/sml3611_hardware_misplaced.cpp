// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3611_hardware_misplaced_file {
namespace {

constexpr std::array<std::string_view, 1> kTag = {"ros2_control"};

constexpr Circumstance kOnly{"no other one"};

class Search {
 public:
  Search(bool is_only, Findings& findings) : is_only_(is_only), findings_(findings) {}

  void look_into(xml::View element) {
    for (const xml::View child : element) {
      if (is_same(child.name(), "ros2_control")) {
        report(child, "ros2_control does not find this `ros2_control`, because it is in " +
                          quoted(element.name()))
            .help("move it directly into `robot`");
      } else {
        look_into(child);
      }
    }
  }

  /// A part of a `ros2_control` that is not in one.
  static bool is_part(xml::View element) {
    if (is_one_of(element.name(), {"hardware", "gpio"})) return true;
    if (is_same(element.name(), "transmission")) return static_cast<bool>(element.child("plugin"));
    if (!is_one_of(element.name(), {"sensor", "joint"})) return false;
    return element.child("state_interface") || element.child("command_interface");
  }

  void look_at(xml::View child) {
    if (is_part(child)) {
      report(child, "ros2_control does not look at this " + quoted(child.name()) +
                        ", because it is not in a `ros2_control`")
          .help("move it into one");
    }
    const bool is_usual =
        is_one_of(child.name(), {"link", "joint", "material", "gazebo", "transmission"});
    if (!is_usual && only_nearest(child.name(), kTag)) {
      report(child, "ros2_control does not look at " + quoted(child.name()))
          .help("did you mean `ros2_control`?");
    }
    look_into(child);
  }

 private:
  Diagnostic& report(xml::View element, std::string message) {
    Diagnostic& found = findings_.report(element.name_span(), std::move(message));
    if (is_only_) found.when(kOnly);
    return found;
  }

  bool is_only_;
  Findings& findings_;
};

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  if (!model.robot) return;
  Search search(hardware_of(model).empty(), findings);
  for (const xml::View child : model.robot->document.view()) {
    if (child.name() != "ros2_control") search.look_at(child);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::refuses, "finds no `ros2_control` and throws an exception",
     "ros2_control hardware_interface/src/component_parser.cpp, run", when(kOnly)},
    {&readers::ros2_control, Effect::loses, "does not see it",
     "ros2_control hardware_interface/src/component_parser.cpp parse_control_resources_from_urdf"},
    {&readers::ros, Effect::loses, "ros2_control does not see it",
     "ros2_control hardware_interface/src/component_parser.cpp parse_control_resources_from_urdf"},
};

}  // namespace

extern constinit const Rule sml3611_hardware_misplaced{
    .id = "SML3611",
    .name = "hardware-misplaced",
    .severity = Severity::warning,
    .summary = "An element `ros2_control` is misspelt, or not directly in `robot`.",
    .remedy = "Correct its name, or move it directly into `robot`.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3611_hardware_misplaced_file
