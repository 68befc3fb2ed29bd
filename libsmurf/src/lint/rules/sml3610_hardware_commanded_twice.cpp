// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <map>
#include <string>

#include "base/text/counted.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3610_hardware_commanded_twice_file {
namespace {

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  std::map<std::string, Span> known;
  for (const Hardware& hardware : hardware_of(model)) {
    Diagnostic* found = nullptr;  // one finding for all interfaces
    std::size_t count = 0;
    for (const HardwarePart& part : hardware.parts) {
      if (part.name.empty()) continue;
      std::map<std::string, Span> own;
      for (const HardwareInterface& one : part.interfaces) {
        if (!one.is_command || one.name.empty()) continue;
        const std::string full = std::string(part.name) + "/" + std::string(one.name);
        const Span place = place_of(one.element, "name");
        own.emplace(full, place);
        const auto first = known.find(full);
        if (first == known.end() || ++count > 1) continue;
        found = &findings.report(place, title_of(hardware) + " commands " + quoted(full) +
                                            ", which another ros2_control commands, too");
        found->label(first->second, "it is commanded here, too").help("delete one of them");
      }
      known.merge(own);
    }
    if (count > 1) found->note("the same is true of " + counted(count - 1, "more interface"));
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::changes, "warns and lets one of them drive the joint",
     "ros2_control hardware_interface/src/resource_manager.cpp add_command_interfaces"},
};

}  // namespace

extern constinit const Rule sml3610_hardware_commanded_twice{
    .id = "SML3610",
    .name = "hardware-commanded-twice",
    .severity = Severity::warning,
    .summary = "Two elements `ros2_control` command the same interface of a joint.",
    .remedy = "Delete the command interface in one of them.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3610_hardware_commanded_twice_file
