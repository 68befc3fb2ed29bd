// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/findings/readers.hpp"
#include "base/findings/uncertain.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"
#include "lint/body.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1442_origin_large_file {
namespace {

/// The number of a text that is farthest from 0.
double farthest_in(std::string_view text) {
  double farthest = 0;
  std::size_t at = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    const double value = parse_number(word).value_or(0);
    if (std::fabs(value) > std::fabs(farthest)) farthest = value;
  }
  return farthest;
}

/// Whether a text is sure to have no number as far from 0 as `far`: each word is plain and has at
/// most so many digits before its point. Most origins are told apart without reading numbers.
bool is_near(std::string_view text, double far) {
  int most = 0;
  for (double power = 10; power <= far && most < 9; power *= 10) ++most;
  int digits = 0;
  bool is_behind_point = false;
  for (const char c : text) {
    if (is_digit(c)) {
      if (!is_behind_point && ++digits > most) return false;
    } else if (c == '.') {
      is_behind_point = true;
    } else if (is_blank(c)) {
      digits = 0;
      is_behind_point = false;
    } else if (c != '-') {
      return false;
    }
  }
  return true;
}

/// From here, rounding can make the inertia impossible that links have together about one point.
constexpr double kRounded = 1e5;  // m

/// Whether the origin moves a mass within the links that sdformat makes one.
bool moves_mass(xml::View origin) {
  const xml::View owner = origin.parent();
  if (is_same(owner.name(), "inertial")) return true;
  const xml::Attribute* type = owner.attribute("type");
  return is_same(owner.name(), "joint") && type != nullptr && type->value() == "fixed";
}

/// One finding per file, because the unit is one decision.
void check(const LinkedModel& model, Findings& findings) {
  const double far = findings.tolerance();
  if (!model.robot) return;
  const xml::Document& document = model.robot->document;
  for (std::size_t i = 0; i < document.elements.size(); ++i) {
    if (!is_same(document.elements[i].name(), "origin")) continue;
    const xml::View origin(document, xml::ElementId{static_cast<std::uint32_t>(i)});
    const xml::Attribute* xyz = origin.attribute("xyz");
    if (xyz == nullptr || is_near(xyz->value(), far)) continue;
    const double farthest = farthest_in(xyz->value());
    if (std::fabs(farthest) <= far) continue;
    Diagnostic& finding =
        findings.report_habit(xyz->value_span(),
                              "this origin lies " + format_rounded(std::fabs(farthest)) +
                                  " m away; are millimetres meant?",
                              "such origins");
    if (std::fabs(farthest) > kRounded && moves_mass(origin)) finding.when(kUncertain);
    finding.help(format_rounded(farthest) + " mm are " + format_rounded(farthest / 1000) + " m");
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::refuses,
     "reports error E18 if rounding makes the inertia of merged links impossible", kRun,
     when(kUncertain)},
};

}  // namespace

extern constinit const Rule sml1442_origin_large{
    .id = "SML1442",
    .name = "origin-large",
    .severity = Severity::warning,
    .summary = "An origin lies more than 10 m away.",
    .why =
        "URDF lengths are metres: values in millimetres put a part hundreds of metres off, out of "
        "sight in every viewer.",
    .remedy = "Divide by 1000, if it is in millimetres.",
    .sources = "URDF specification; urdfdom pose.h.",
    .check_model = check,
    .tolerance = {.value = kFarthestOrigin,
                  .unit = "m",
                  .meaning = "how far a part may lie from the frame it is placed in"},
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1442_origin_large_file
