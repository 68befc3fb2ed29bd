// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>

#include "base/numbers.hpp"
#include "base/path.hpp"
#include "base/words.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3606_hardware_wrong_value_file {
namespace {

constexpr Circumstance kSinceJazzy{"since jazzy"};

bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isdigit(static_cast<unsigned char>(c));
  });
}

bool is_bool(std::string_view text) { return is_one_of(path::to_lower(text), {"true", "false"}); }
bool is_positive(std::string_view text) { return is_digits(text) && text.front() != '0'; }
/// std::stoi() reads a number at the beginning and ignores what follows.
bool is_rate(std::string_view text) { return !text.empty() && is_digits(text.substr(0, 1)); }

/// An attribute whose value is restricted; `parent` may be empty.
struct Value {
  std::string_view parent, element, attribute;
  bool (*is_good)(std::string_view);
  std::string_view wanted;
  bool is_since_jazzy;
};
constexpr Value kValues[] = {
    {"robot", "ros2_control", "is_async", is_bool, "true or false", true},
    {"robot", "ros2_control", "rw_rate", is_rate, "a positive whole number", true},
    {"robot", "ros2_control", "thread_priority", is_positive, "a positive whole number", true},
    {"properties", "async", "thread_priority", is_positive, "a positive whole number", true},
    {"properties", "async", "print_warnings", is_bool, "true or false", true},
    {"ros2_control", "joint", "mimic", is_bool, "true or false", true},
    {"", "limits", "enable", is_bool, "true or false", true},
    {"transmission", "joint", "read_only", is_bool, "true or false", true},
    {"transmission", "actuator", "read_only", is_bool, "true or false", true},
    {"", "command_interface", "size", is_positive, "a positive whole number", false},
    {"", "state_interface", "size", is_positive, "a positive whole number", false},
};

void check_element(xml::View element, Findings& findings) {
  for (const Value& row : kValues) {
    if (row.element != element.name()) continue;
    if (!row.parent.empty() && row.parent != element.parent().name()) continue;
    const xml::Attribute* attribute = element.attribute(row.attribute);
    if (attribute == nullptr) continue;
    const std::string_view text = trimmed(attribute->value());
    if (row.is_good(text)) continue;
    Diagnostic& found = findings.report(place_of(element, row.attribute),
                                        quoted(row.attribute) + " of " + quoted(element.name()) +
                                            " is " + quoted(text));
    if (row.is_since_jazzy) found.when(kSinceJazzy);
    found.help("write " + std::string(row.wanted));
  }
  for (const xml::View child : element) check_element(child, findings);
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& one : hardware_of(model)) check_element(one.element, findings);
}

constexpr Fact kFacts[] = {
    no_hardware(when(kSinceJazzy),
                "throws an exception and loads no hardware (from Jazzy on; Humble "
                "reads it as false, or not at all)"),
    no_hardware(), no_hardware_in_ros()};

}  // namespace

extern constinit const Rule sml3606_hardware_wrong_value{
    .id = "SML3606",
    .name = "hardware-wrong-value",
    .severity = Severity::error,
    .summary = "An attribute in `ros2_control` has a value that the parser refuses.",
    .remedy = "Write true or false, or a positive whole number.",
    .facts = kFacts};

}  // namespace smurf::rules::sml3606_hardware_wrong_value_file

namespace smurf::companion_checks {

extern constinit const CompanionCheck sml3606_hardware_wrong_value =
    rules::sml3606_hardware_wrong_value_file::check;

}  // namespace smurf::companion_checks
