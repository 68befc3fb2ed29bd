// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>

#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "lint/body.hpp"
#include "lint/model_answers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1523_radius_of_gyration_file {
namespace {

constexpr double kShortest = 1e-3;  // m
constexpr double kLongest = 2;      // m

/// Without an exponent, which only large numbers have.
std::string shown(double value) {
  constexpr double kLarge = 100, kLargest = 1e12;
  return value >= kLarge && value < kLargest ? std::to_string(std::llround(value))
                                             : format_rounded(value, 2);
}

/// A question about the unit with which the body would have a likely size; "" if there is none.
std::string likely_unit(double mass, double radius) {
  constexpr double kHeavy = 1000;        // kg: no link weighs more
  constexpr double kMillimetres = 1e-3;  // m
  const auto is_likely = [](double length) { return length >= kShortest && length <= kLongest; };
  if (radius > kLongest && is_likely(radius * kMillimetres)) {
    return mass > kHeavy ? "are these g and g mm2? write kg and kg m2"
                         : "is this kg mm2? write kg m2";
  }
  // The root of the mass in g that is written as kg.
  const bool is_mass = radius < kShortest && is_likely(radius * std::sqrt(1000.0));
  return is_mass ? "is the mass in g? write kg" : "";
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || is_unit_tensor(*link.inertial)) return;
    const auto moments = principal_moments(*link.inertial);
    const double mass = link.inertial->mass.value_or(0);
    if (!moments || mass < kNegligibleMass) return;
    const double radius = std::sqrt((*moments)[2] / mass);
    if (radius >= kShortest && radius <= kLongest) return;
    // When the size of the link is known, another rule compares the inertia with it.
    if (findings.answers().extent(link) || !findings.answers().body(link)) return;
    Diagnostic& diagnostic =
        findings.report(inertia_place(model, *link.inertial),
                        "the inertia of " + title(link) + " does not fit its mass");
    diagnostic.caret = shown((*moments)[2]) + " kg m2 needs all " + shown(mass) + " kg to be " +
                       shown(radius) + " m from the axis";
    if (const std::string unit = likely_unit(mass, radius); !unit.empty()) diagnostic.help(unit);
  });
}

}  // namespace

extern constinit const Rule sml1523_radius_of_gyration{
    .id = "SML1523",
    .name = "radius-of-gyration",
    .severity = Severity::warning,
    .summary = "An inertia belongs to a body of unlikely size.",
    .why = "The square root of inertia divided by mass is the distance of the mass from the axis: "
           "less than a millimetre or more than two metres usually means a wrong unit (kg mm2, g "
           "mm2). Joints then jitter or hardly move.",
    .remedy = "Write the inertia in kg m2.",
    .sources = "38 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1523_radius_of_gyration_file
