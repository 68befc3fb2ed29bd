// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <optional>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "base/text/words.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3607_hardware_limit_file {
namespace {

constexpr Circumstance kInitial{"initial"};
constexpr Circumstance kNotANumber{"not a number"};
constexpr Circumstance kWider{"wider"};
constexpr Circumstance kAbove{"above"};
constexpr Circumstance kZero{"zero"};
constexpr Circumstance kOther{"other interface"};
constexpr Circumstance kContinuous{"continuous"};

constexpr double kSlack = 1e-6;  // rad or m: rounding errors

bool is_limited_interface(std::string_view name) {
  return is_one_of(name, {"position", "velocity", "effort", "acceleration", "jerk"});
}

struct Limit {
  xml::View element;
  std::optional<double> value;
};

/// Limits of one kind in an element ros2_control: the first is a finding, the others are counted.
class Repeated {
 public:
  /// Whether a finding is the first.
  bool is_first() {
    ++count_;
    return count_ == 1;
  }
  void set(Diagnostic& first) { first_ = &first; }
  void finish() {
    if (count_ < 2) return;
    first_->note("this also applies to " + counted(count_ - 1, "more limit") +
                 " of this ros2_control");
  }

 private:
  Diagnostic* first_ = nullptr;
  std::size_t count_ = 0;
};

/// Reads `min` or `max`; reports a text that is not a number.
Limit read_limit(const HardwareInterface& one, std::string_view name, const std::string& title,
                 bool is_xacro, Repeated& wrong, Findings& findings) {
  const xml::View element = one.parameter_element(name);
  if (!element) return {};
  const std::string_view text = trimmed(element.text());
  const auto value = parse_number(text);
  // An interface of other names has no limits.
  const bool is_infinite = is_one_of(text, {"inf", "-inf", "nan", ".inf", "-.inf"});
  if (value || is_infinite || !is_limited_interface(one.name)) {
    return {element, value};
  }
  // SML3408 reports braces without `$` in xacro.
  const bool is_sum = text.starts_with('{') && text.find_first_of("+-*/") != text.npos;
  if ((is_xacro && is_sum) || !wrong.is_first()) return {};
  const Span place = element.text_span().empty() ? element.name_span() : element.text_span();
  Diagnostic& found = findings.report(
      place, quoted(name) + " of the " + quoted(one.name) + " interface of " + title +
                 (text.empty() ? " is empty" : " is " + quoted(text) + ", not a number"));
  wrong.set(found);
  found.when(kNotANumber);
  const bool is_expression = text.find("pi") != std::string_view::npos;
  found.help(text.starts_with('{') ? "write `$" + std::string(text) + "`, which xacro computes"
             : is_expression       ? "write a number; xacro computes it from `${...}`"
                                   : "write a number");
  return {};
}

/// Whether a joint or an interface does not switch its limits off.
bool has_limits(xml::View element) {
  for (const xml::View child : element) {
    if (child.name() == "limits" && path::to_lower(attribute_text(child, "enable")) == "false") {
      return false;
    }
  }
  return true;
}

/// Of velocities and efforts, the smaller limit counts.
void check_most(const HardwareInterface& one, const std::string& title, const urdf::Joint& joint,
                const Limit& max, const Field<double>& most, Repeated& wider, Findings& findings) {
  if (!max.value) return;
  if (*max.value == 0.0) {
    Diagnostic& found =
        findings.report(max.element.text_span(),
                        "`max` of the " + quoted(one.name) + " interface of " + title + " is 0");
    found.when(kZero);
    found.help("write the highest " + std::string(one.name) + ", or delete the limit");
    return;
  }
  if (!most || *max.value <= *most + kSlack || !wider.is_first()) return;
  Diagnostic& found = findings.report(max.element.text_span(),
                                      title + " allows the " + std::string(one.name) + " " +
                                          format_rounded(*max.value) + ", above the limit " +
                                          format_rounded(*most) + " of the joint");
  wider.set(found);
  found.when(kWider);
  found.severity = Severity::info;
  found.label(joint.name.span, "the joint is defined here")
      .help("write a limit within that of the joint; the smaller one counts");
}

/// A continuous joint with limits of its position turns no further than these.
void check_continuous(const HardwareInterface& one, const std::string& title,
                      const urdf::Joint& joint, const Limit& min, const Limit& max,
                      Repeated& continuous, Findings& findings) {
  const bool is_meant = joint.type == urdf::JointType::continuous && one.name == "position";
  const Limit& limit = min.value ? min : max;
  const bool has_both = min.value && max.value;
  const bool is_empty_range = has_both && *min.value > *max.value;
  if (!is_meant || !limit.value || is_empty_range || !continuous.is_first()) return;
  Diagnostic& found =
      findings.report(limit.element.text_span(),
                      title +
                          (has_both ? " limits positions to " + format_rounded(*min.value) +
                                          " to " + format_rounded(*max.value)
                                    : std::string(" limits positions")) +
                          ", but the joint is continuous");
  continuous.set(found);
  found.when(kContinuous);
  found.severity = Severity::info;
  found.label(joint.type_name.span, "turns without end")
      .help("delete the limits, or make the joint revolute");
}

void check_range(const HardwareInterface& one, const std::string& title, const urdf::Joint* joint,
                 const Limit& min, const Limit& max, Repeated& wider, Findings& findings) {
  if (min.value && max.value && *min.value > *max.value) {
    findings
        .report(min.element.text_span(), "`min` of the " + quoted(one.name) + " interface of " +
                                             title + " is above its `max`")
        .label(max.element.text_span(), "its `max`")
        .help("swap them");
    return;
  }
  if (joint == nullptr || !joint->limit) return;
  if (is_one_of(one.name, {"velocity", "effort"})) {
    const Field<double>& most =
        one.name == "effort" ? joint->limit->effort : joint->limit->velocity;
    check_most(one, title, *joint, max, most, wider, findings);
    return;
  }
  if (one.name != "position") return;
  const bool has_range =
      joint->type == urdf::JointType::revolute || joint->type == urdf::JointType::prismatic;
  if (!has_range || !joint->limit->lower || !joint->limit->upper) return;
  const double lower = *joint->limit->lower, upper = *joint->limit->upper;
  const bool is_low = min.value && *min.value < lower - kSlack;
  const bool is_high = max.value && *max.value > upper + kSlack;
  if ((!is_low && !is_high) || !wider.is_first()) return;
  const xml::View element = is_low ? min.element : max.element;
  Diagnostic& found = findings.report(element.text_span(),
                                      title + " allows positions beyond the limits of the joint, " +
                                          format_rounded(lower) + " to " + format_rounded(upper));
  wider.set(found);
  found.when(kWider);
  found.severity = Severity::info;
  found.label(joint->name.span, "the joint is defined here")
      .help("write limits within those of the joint; the narrower ones count");
}

/// A limit that is no finite number makes ros2_control skip the other one, too.
void check_finite(const HardwareInterface& one, const std::string& title, const Limit& bad,
                  const Limit& other, Findings& findings) {
  const auto is_finite = [](const Limit& limit) {
    return limit.value && std::isfinite(*limit.value);
  };
  if (!bad.element || is_finite(bad) || !is_finite(other)) return;
  const std::string_view name = attribute_text(bad.element, "name");
  Diagnostic& found = findings.report(
      bad.element.text_span(), quoted(name) + " of the " + quoted(one.name) + " interface of " +
                                   title + " is not finite, so the other limit is lost, too");
  found.when(kNotANumber);
  found.help("write a number, or delete both limits");
}

/// ros2_control knows no limits of other quantities.
void check_other(const HardwareInterface& one, const std::string& title, const Limit& min,
                 const Limit& max, Repeated& other, Findings& findings) {
  const xml::View element = min.element ? min.element : max.element;
  if (one.name == "jerk" && min.element) {
    if (!other.is_first()) return;
    Diagnostic& found = findings.report(
        min.element.name_span(), "the `jerk` interface of " + title +
                                     " has a `min`, but ros2_control only applies its `max`");
    other.set(found);
    found.when(kOther);
    found.help("delete it");
    return;
  }
  if (!element || is_limited_interface(one.name) || !other.is_first()) return;
  Diagnostic& found =
      findings.report(element.name_span(), "the " + quoted(one.name) + " interface of " + title +
                                               " has a limit, which ros2_control does not apply");
  other.set(found);
  found.when(kOther);
  found.help("delete it, or write position, velocity, effort, acceleration or jerk");
}

void check_initial(const HardwareInterface& one, const std::string& title, const Limit& min,
                   const Limit& max, Findings& findings) {
  const xml::View element = one.parameter_element("initial_value");
  if (!element) return;
  const std::string_view text = trimmed(element.text());
  const auto value = parse_number(text);
  const bool is_beyond =
      value && ((min.value && *value < *min.value) || (max.value && *value > *max.value));
  const bool has_type = one.element.attribute("data_type") != nullptr;
  const bool is_empty_range = min.value && max.value && *min.value > *max.value;
  if ((value && (!is_beyond || is_empty_range)) || text.empty() || has_type) return;
  const Span place = element.text_span().empty() ? element.name_span() : element.text_span();
  Diagnostic& found =
      findings.report(place, "the initial value " + quoted(text) + " of the " + quoted(one.name) +
                                 " interface of " + title +
                                 (value ? " is beyond its `min` and `max`" : " is not a number"));
  found.when(kInitial);
  found.help(value ? "write a value between them" : "write a number");
}

/// `min` of a joint instead of one of its interfaces.
void check_above(const HardwarePart& part, const std::string& title, Repeated& above,
                 Findings& findings) {
  for (const xml::View child : part.element) {
    const std::string_view name = attribute_text(child, "name");
    if (child.name() != "param" || !is_one_of(name, {"min", "max", "initial_value"})) continue;
    if (!above.is_first()) continue;
    Diagnostic& found = findings.report(child.name_span(), quoted(name) + " of " + title +
                                                               " is in none of its interfaces");
    above.set(found);
    found.when(kAbove);
    found.help("move it into a `command_interface` or `state_interface`");
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  const bool is_xacro = model.language == Language::xacro;
  for (const Hardware& hardware : hardware_of(model)) {
    Repeated wrong, wider, continuous, other, above;
    for (const HardwarePart& part : hardware.parts) {
      if (!part.is_joint()) continue;
      const urdf::Joint* joint = model.find_joint(part.name);
      const std::string title = title_of(part, hardware);
      check_above(part, title, above, findings);
      for (const HardwareInterface& one : part.interfaces) {
        const Limit min = read_limit(one, "min", title, is_xacro, wrong, findings);
        const Limit max = read_limit(one, "max", title, is_xacro, wrong, findings);
        if (one.is_command) {
          check_finite(one, title, min, max, findings);
          check_finite(one, title, max, min, findings);
          const bool is_limited = has_limits(one.element) && has_limits(part.element);
          if (is_limited) check_range(one, title, joint, min, max, wider, findings);
          if (is_limited && joint != nullptr) {
            check_continuous(one, title, *joint, min, max, continuous, findings);
          }
          check_other(one, title, min, max, other, findings);
        }
        check_initial(one, title, min, max, findings);
      }
    }
    wrong.finish();
    wider.finish();
    continuous.finish();
    other.finish();
    above.finish();
  }
}

constexpr std::string_view kParser = "ros2_control hardware_interface/src/component_parser.cpp";
constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::loses,
     "reports it and has no limit there (from Jazzy on; Humble leaves limits to the hardware)",
     kParser, when(kNotANumber)},
    {&readers::ros2_control, Effect::loses, "reports it and does not apply it", kParser,
     when(kOther).since(kParserOfJazzy)},
    {&readers::ros2_control, Effect::ignores, "leaves limits to the hardware", kParser,
     when(kOther)},
    {&readers::ros2_control, Effect::loses, "passes it to the hardware and limits nothing", kParser,
     when(kAbove)},
    {&readers::ros2_control, Effect::changes, "does not let the joint move (from Jazzy on)",
     kParser, when(kZero)},
    {&readers::ros2_control, Effect::ignores, "uses the narrower limits", kParser, when(kWider)},
    {&readers::ros2_control, Effect::changes,
     "limits the joint, which then does not turn without end (from Jazzy on)", kParser,
     when(kContinuous).since(kParserOfJazzy)},
    {&readers::ros2_control, Effect::ignores, "leaves limits to the hardware", kParser,
     when(kContinuous)},
    {&readers::ros2_control, Effect::changes, "leaves the value to the hardware or the simulator",
     kParser, when(kInitial)},
    {&readers::ros2_control, Effect::changes,
     "clamps commands to a range that contains nothing (from Jazzy on)", kParser},
    {&readers::ros, Effect::loses, "ros2_control has no limit there", kParser, when(kNotANumber)},
};

}  // namespace

extern constinit const Rule sml3607_hardware_limit{
    .id = "SML3607",
    .name = "hardware-limit",
    .severity = Severity::warning,
    .summary = "A limit or an initial value of an interface is not a number, or does not fit.",
    .why = "Commands are not limited as the file says.",
    .remedy = "Write numbers: `min` below `max`, the initial value between them.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3607_hardware_limit_file
