// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string>

#include "base/floating.hpp"
#include "base/ranges.hpp"
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

constexpr std::string_view kWhole = "maxContacts";
/// Elements that sdformat reads with std::stod (kWhole: std::stoi), which throws.
constexpr std::string_view kNumbers[] = {"mu1",
                                         "mu2",
                                         "kp",
                                         "kd",
                                         "minDepth",
                                         "maxVel",
                                         "dampingFactor",
                                         "stopCfm",
                                         "stopErp",
                                         "springStiffness",
                                         "springReference",
                                         "fudgeFactor",
                                         "laserRetro",
                                         kWhole};
/// Numbers of sensors, which sdformat copies and then reads like those of SDF.
struct SensorNumber {
  std::string_view name;
  double least, most;
};
constexpr double kAny = std::numeric_limits<double>::max();
constexpr SensorNumber kSensorNumbers[] = {{"update_rate", -kAny, kAny},
                                           {"horizontal_fov", 0.1, 6.283186},
                                           {"near", 0, kAny},
                                           {"far", 0.1, kAny},
                                           {"width", -kAny, kAny},
                                           {"height", -kAny, kAny}};
constexpr std::string_view kFlags[] = {"true", "false", "1", "0", ""};

std::from_chars_result read_number(std::string_view text, int& number) {
  return std::from_chars(text.data(), text.data() + text.size(), number);
}
std::from_chars_result read_number(std::string_view text, double& number) {
  return read_floating(text, number);
}

/// Reads like std::stod and std::stoi: skips leading white space, ignores what follows the number.
template <class Number>
std::optional<Number> leading_number(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  return read_number(text, number).ec == std::errc() ? std::optional<Number>(number) : std::nullopt;
}

void report(const xml::View element, const char* construct, Findings& findings) {
  const xml::Attribute* value = element.attribute("value");
  const Span place = value != nullptr ? value->span() : element.text_span();
  const bool is_empty = place.empty();
  findings
      .report(is_empty ? element.name_span() : place,
              quoted(element.name()) + (is_empty ? " is empty" : " cannot be read by Gazebo"))
      .construct = construct;
}

void check_value(const xml::View element, Findings& findings) {
  // sdformat reads the attribute `value` where there is one.
  const xml::Attribute* value = element.attribute("value");
  const std::string_view name = element.name();
  const std::string_view text = value != nullptr ? value->value() : element.text();
  if (ranges::contains(kNumbers, name)) {
    const auto number = leading_number<double>(text);
    const bool is_read =
        name == kWhole ? leading_number<int>(text).has_value() : number.has_value();
    if (!is_read) return report(element, "number", findings);
    if (name.starts_with("mu") && *number < 0) report(element, "friction", findings);
  } else if (name == "gravity" && !ranges::contains(kFlags, text)) {
    report(element, "flag", findings);
  }
}

void check_sensor(const xml::View element, Findings& findings) {
  for (const xml::View child : element) check_sensor(child, findings);
  for (const SensorNumber& known : kSensorNumbers) {
    if (known.name != element.name() || element.begin() != element.end()) continue;
    const auto number = leading_number<double>(element.text());
    if (!number || *number < known.least || *number > known.most) {
      report(element, "sensor", findings);
    }
  }
}

/// A pose of the model has six numbers.
void check_pose(const xml::View element, Findings& findings) {
  const std::string_view text = element.text();
  if (element.name() != "pose" || text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return;
  }
  if (numbers_in(text).size() < 6) report(element, "pose", findings);
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    const xml::Attribute* reference = gazebo.attribute("reference");
    const bool is_of_link = reference != nullptr && model.link_names.contains(reference->value());
    for (const xml::View element : gazebo) {
      if (reference == nullptr) {
        check_pose(element, findings);
      } else if (is_of_link && element.name() == "sensor") {
        check_sensor(element, findings);
      } else {
        check_value(element, findings);
      }
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::crashes, "ends the process with an exception", kRun, "#number"},
    {&readers::gazebo, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1447_gazebo_value{
    .id = "SML1447",
    .name = "gazebo-value",
    .severity = Severity::warning,
    .summary = "An element for Gazebo contains a value that Gazebo cannot read.",
    .why = "An empty `mu1`, or a word in `dampingFactor`, ends the simulator.",
    .remedy = "Write a number, and six for a `pose`; `gravity` is `true` or `false`.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
