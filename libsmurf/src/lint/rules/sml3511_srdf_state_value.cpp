// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "base/text/words.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3511_srdf_state_value_file {
namespace {

constexpr Circumstance kEmpty{"empty"};
constexpr Circumstance kNotANumber{"not a number"};

std::optional<std::size_t> variables_of(const LinkedModel& model, const srdf::Description& srdf,
                                        std::string_view joint) {
  if (const urdf::Joint* one = model.find_joint(joint)) {
    if (one->type == urdf::JointType::unknown) return std::nullopt;
    return smurf::variables_of(*one);
  }
  const srdf::VirtualJoint* one = srdf.find_virtual_joint(joint);
  return one != nullptr ? std::optional(smurf::variables_of(*one)) : std::nullopt;
}

void check_value(const LinkedModel& model, const srdf::Description& srdf,
                 const srdf::StateJoint& joint, Findings& findings) {
  if (!joint.value) return;
  const Span place = place_of(srdf, joint.value, joint.element);
  std::size_t count = 0;
  for (std::size_t at = 0;; ++count) {
    const std::string_view word = next_word(*joint.value, at);
    if (word.empty()) break;
    if (parse_number(word)) continue;
    Diagnostic& found =
        findings.report(place, "the value " + quoted(word) + " of " +
                                   title_of("joint", joint.name) + " is not a number");
    found.when(kNotANumber);
    if (word.find(',') != std::string_view::npos) found.help("write a point, not a comma");
    if (word.find(',') == std::string_view::npos) found.help("write a number in rad or m");
    return;
  }
  if (count == 0) {
    findings.report(place, title_of("joint", joint.name) + " has an empty value")
        .help("write a number in rad or m")
        .when(kEmpty);
    return;
  }
  const auto wanted = joint.name ? variables_of(model, srdf, *joint.name) : std::nullopt;
  if (!wanted || *wanted == 0 || *wanted == count) return;
  findings
      .report(place, title_of("joint", joint.name) + " has " + counted(count, "value") +
                         ", but it needs " + std::to_string(*wanted))
      .help("write " + counted(*wanted, "number") +
            (*wanted > 1 ? ", with blanks between them" : ""));
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    for (const srdf::GroupState& state : srdf.states) {
      for (const srdf::StateJoint& joint : state.joints) {
        check_value(model, srdf, joint, findings);
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::changes, "reads it as 0 without a message",
     "srdfdom model.cpp loadGroupStates", when(kNotANumber)},
    {&readers::moveit, Effect::changes, "uses an uninitialised number",
     "srdfdom model.cpp loadGroupStates", when(kEmpty)},
    {&readers::moveit, Effect::breaks, "reports an error and ignores the joint in the state",
     "moveit2 robot_model.cpp addJointModelGroup"},
};

}  // namespace

extern constinit const Rule sml3511_srdf_state_value{
    .id = "SML3511",
    .name = "srdf-state-value",
    .severity = Severity::error,
    .summary =
        "The value of a joint in a group state is not a number, or not one for each variable.",
    .why = "The robot moves to another pose than the one that was meant.",
    .remedy = "Write numbers in rad or m: one, or as many as the joint has variables.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3511_srdf_state_value_file
