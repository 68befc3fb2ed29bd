// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3606_hardware_wrong_value_file {
namespace {

constexpr Circumstance kNew{"not read by Humble"};

bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isdigit(static_cast<unsigned char>(c));
  });
}

bool is_bool(std::string_view text) { return is_one_of(path::to_lower(text), {"true", "false"}); }
bool is_positive(std::string_view text) { return is_digits(text) && text.front() != '0'; }
/// "[1, 2]"; parse_array() takes no other form.
bool is_integers(std::string_view text) {
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return false;
  text = text.substr(1, text.size() - 2);
  if (trimmed(text).empty()) return true;
  for (;;) {
    const std::size_t comma = text.find(',');
    std::string_view word = trimmed(text.substr(0, comma));
    if (word.starts_with('-')) word.remove_prefix(1);
    if (!is_digits(word)) return false;
    if (comma == std::string_view::npos) return true;
    text.remove_prefix(comma + 1);
  }
}
/// std::stoi() reads a number at the beginning and ignores what follows.
bool is_rate(std::string_view text) { return !text.empty() && is_digits(text.substr(0, 1)); }

/// An attribute whose value is restricted; `parent` may be empty.
struct Value {
  std::string_view parent, element, attribute;
  bool (*is_good)(std::string_view);
  std::string_view wanted;
  bool is_new = true;  ///< Humble does not read it
};
constexpr Value kValues[] = {
    {"robot", "ros2_control", "is_async", is_bool, "true or false"},
    {"robot", "ros2_control", "rw_rate", is_rate, "a positive whole number"},
    {"robot", "ros2_control", "thread_priority", is_positive, "a positive whole number"},
    {"properties", "async", "thread_priority", is_positive, "a positive whole number"},
    {"properties", "async", "print_warnings", is_bool, "true or false"},
    {"properties", "async", "affinity", is_integers, "a list of whole numbers in brackets, [1, 2]"},
    {"ros2_control", "joint", "mimic", is_bool, "true or false"},
    {"", "limits", "enable", is_bool, "true or false"},
    {"transmission", "joint", "read_only", is_bool, "true or false"},
    {"transmission", "actuator", "read_only", is_bool, "true or false"},
    {"gpio", "command_interface", "size", is_positive, "a positive whole number", false},
    {"gpio", "state_interface", "size", is_positive, "a positive whole number", false},
    {"", "command_interface", "size", is_positive, "a positive whole number"},
    {"", "state_interface", "size", is_positive, "a positive whole number"},
};

/// The parser reads the priority only if the component has its own thread.
bool is_unread(xml::View element, std::string_view attribute) {
  return element.name() == "ros2_control" && attribute == "thread_priority" &&
         path::to_lower(attribute_text(element, "is_async")) != "true";
}

void check_element(xml::View element, Findings& findings) {
  std::string_view last;
  for (const Value& row : kValues) {
    if (row.element != element.name() || row.attribute == last) continue;
    if (!row.parent.empty() && row.parent != element.parent().name()) continue;
    if (is_unread(element, row.attribute)) continue;
    last = row.attribute;
    const xml::Attribute* attribute = element.attribute(row.attribute);
    if (attribute == nullptr) continue;
    const std::string_view text = trimmed(attribute->value());
    if (row.is_good(text)) continue;
    Diagnostic& found = findings.report(place_of(element, row.attribute),
                                        quoted(row.attribute) + " of " + quoted(element.name()) +
                                            " is " + quoted(text));
    if (row.is_new) found.when(kNew);
    found.help("write " + std::string(row.wanted));
  }
  for (const xml::View child : element) check_element(child, findings);
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& one : hardware_of(model)) check_element(one.element, findings);
}

constexpr std::string_view kUnread = "ros2_control does not read it";

constexpr Fact kFacts[] = {in_humble(Effect::ignores, kUnread, when(kNew)), no_hardware(),
                           in_ros_humble(Effect::ignores, kUnread, when(kNew)),
                           no_hardware_in_ros()};

}  // namespace

extern constinit const Rule sml3606_hardware_wrong_value{
    .id = "SML3606",
    .name = "hardware-wrong-value",
    .severity = Severity::error,
    .summary = "An attribute in `ros2_control` has a value that the parser refuses.",
    .remedy = "Write true or false, or a positive whole number.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3606_hardware_wrong_value_file
