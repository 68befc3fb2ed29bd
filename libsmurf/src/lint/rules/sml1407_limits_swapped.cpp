// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <string_view>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1407_limits_swapped_file {
namespace {

/// A limit as a reader sees it that stops at the first unreadable character: 1 of `1_000`.
std::optional<double> leading_number(const LinkedModel& model, const urdf::Joint& joint,
                                     std::string_view name, const Field<double>& limit) {
  if (limit) return *limit;
  const xml::View element = xml::View(model.robot->document, joint.element).child("limit");
  const xml::Attribute* written = element ? element.attribute(name) : nullptr;
  if (written == nullptr) return std::nullopt;
  const std::vector<double> numbers = read_leading_numbers(written->value());
  return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

/// Limits of which a part cannot be read have another finding.
void check_unread(const LinkedModel& model, const urdf::Joint& joint, Findings& findings) {
  const Field<double>& lower = joint.limit->lower;
  const Field<double>& upper = joint.limit->upper;
  if (!lower.written || !upper.written) return;
  const auto low = leading_number(model, joint, "lower", lower);
  const auto high = leading_number(model, joint, "upper", upper);
  if (low && high && *low > *high) findings.add_consequence(lower ? upper.span : lower.span);
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit || !joint.has_one_axis()) return;
    const Field<double>& lower = joint.limit->lower;
    const Field<double>& upper = joint.limit->upper;
    // With one of them absent readers disagree about more than the order; SML1406 reports it.
    if (joint.type == urdf::JointType::continuous) return;  // SML1409 reports its limits
    if (!lower || !upper) return check_unread(model, joint, findings);
    if (*lower <= *upper) return;
    Diagnostic& diagnostic = findings.report(
        lower.span, "the lower limit " + format_number(*lower) + " of " + title(joint) +
                        " is above its upper limit " + format_number(*upper));
    diagnostic.label(upper.span, "the upper limit");
    diagnostic.help("swap the two values");
    // Bullet's notation for "no limit".
    if (*lower == 1 && (*upper == 0 || *upper == -1)) {
      diagnostic.help("swap the two values, or make the joint continuous if it has no limit");
    }
    diagnostic.fixes.push_back(
        {Applicability::unsafe,
         {{lower.span, format_number(*upper)}, {upper.span, format_number(*lower)}}});
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes, "keeps limits that no position satisfies", kRun},
    {&readers::mars, Effect::ignores, "reads no limits from the URDF", "MARS smurf.cpp:902-910"},
    {&readers::pybullet, Effect::changes, "lets the joint move without limit", kRun},
    {&readers::gazebo, Effect::changes, "swaps the two limits",
     "sdformat parser_urdf.cc:3127-3140, run"},
    {&readers::mujoco, Effect::changes, "lets the joint move without limit", kRun},
    {&readers::drake, Effect::crashes, "ends the process", kRun},
};

}  // namespace

extern constinit const Rule sml1407_limits_swapped{
    .id = "SML1407",
    .name = "limits-swapped",
    .severity = Severity::error,
    .summary = "The lower limit of a joint is above its upper limit.",
    .remedy = "Swap the values, or correct the one that is wrong.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1407_limits_swapped_file
