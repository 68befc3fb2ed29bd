// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "ast/urdf_numbers.hpp"
#include "base/findings/readers.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1421_axis_zero_file {
namespace {

constexpr Circumstance kShort{"not exactly 0"};

/// Whether a reader that stops at the first unreadable character reads 0: in `0;`.
bool begins_with_zero(std::string_view word) {
  const std::size_t end = word.find_first_not_of("0.", word.find_first_not_of("+-"));
  const std::string_view read = word.substr(0, end);
  return read.find('0') != read.npos && (end == word.npos || !is_digit(word[end]));
}

/// Whether all numbers of the axis are 0 or too small for a double, which most readers read as 0.
bool vanishes(const LinkedModel& model, const urdf::Joint& joint) {
  const xml::View element = xml::View(model.robot->document, joint.element).child("axis");
  const xml::Attribute* numbers = element ? element.attribute("xyz") : nullptr;
  if (numbers == nullptr) return false;
  std::size_t place = 0;
  for (std::string_view word = next_word(numbers->value(), place); !word.empty();
       word = next_word(numbers->value(), place)) {
    if (!is_underflow(word) && !begins_with_zero(word)) return false;
  }
  return true;
}

void check(const LinkedModel& model, Findings& findings) {
  constexpr double kShortest = 1e-8;  // sdformat and Drake compare with about this
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.is_movable()) return;
    if (!joint.axis && joint.axis.written && vanishes(model, joint)) {
      return findings.add_consequence(joint.axis.span);
    }
    if (!joint.axis) return;
    const Vector3& axis = *joint.axis;
    const double length = hypotenuse(axis[0], axis[1], axis[2]);
    if (length >= kShortest) return;
    Diagnostic& diagnostic = findings.report(
        joint.axis.span, "the axis of " + title(joint) + " is zero, so it has no direction");
    if (length > 0) diagnostic.when(kShort);
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes, "accepts it: the joint has no direction", kRun},
    {&readers::pybullet, Effect::changes, "accepts it: the joint has no direction",
     "Bullet UrdfParser.cpp, run"},
    {&readers::gazebo, Effect::refuses, "reports error E9, an axis of length 0", kRun},
    {&readers::mujoco, Effect::ignores, "does not look at the axis of a floating joint", kRun,
     when(kInFloating)},
    {&readers::mujoco, Effect::refuses, "refuses an axis of length 0", kRun},
    {&readers::drake, Effect::refuses, "refuses an axis of length 0", kRun},
    {&readers::phobos, Effect::changes, "accepts it: the joint has no direction", kRun},
    {&readers::isaac, Effect::takes, "normalises the axis", kRun, when(kShort)},
    {&readers::isaac, Effect::refuses, "refuses an axis of length 0", kRun},
};

}  // namespace

extern constinit const Rule sml1421_axis_zero{
    .id = "SML1421",
    .name = "axis-zero",
    .severity = Severity::error,
    .summary = "The axis of a joint is the zero vector.",
    .remedy = "Write the direction the joint turns about or moves along.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1421_axis_zero_file
