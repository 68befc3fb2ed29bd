// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "lint/copied_side.hpp"
#include "lint/model_answers.hpp"
#include "lint/odd_siblings.hpp"
#include "lint/queries.hpp"
#include "lint/sides.hpp"

namespace smurf::rules::sml1528_sides_differ_in_mass_file {
namespace {

/// The larger of two numbers divided by the smaller.
double factor_of(double a, double b) { return std::max(a / b, b / a); }

double distance_of(const urdf::Inertial& inertial) {
  const Vector3 center = urdf::to_pose(inertial.origin).position;
  return std::sqrt(center[0] * center[0] + center[1] * center[1] + center[2] * center[2]);
}

bool have_equal_values(const urdf::Inertial& a, const urdf::Inertial& b) {
  return a.mass.value() == b.mass.value() && a.ixx.value() == b.ixx.value() &&
         a.iyy.value() == b.iyy.value() && a.izz.value() == b.izz.value();
}

bool report_copy(const LinkedModel& model, const urdf::Link& left, const urdf::Link& right,
                 Findings& findings) {
  const std::optional<CopiedSide> copied = copied_side(left, right, findings.answers());
  if (!copied) return false;
  const auto place = [&](const urdf::Inertial& inertial) {
    return copied->is_center ? tag_name(model, inertial.element) : inertia_place(model, inertial);
  };
  Diagnostic& finding =
      findings
          .report(place(*right.inertial),
                  "the shapes of " + title(left) + " and " + title(right) +
                      " are mirrored, but their " +
                      (copied->is_center ? "centre of mass is the same"
                                         : "products of inertia have the same signs"))
          .label(place(*left.inertial), "the other side")
          .help("change the sign of " + std::string(1, "xyz"[copied->axis]) +
                " in the centre, and of the two products with it");
  finding.severity = Severity::warning;
  return true;
}

void report(const LinkedModel& model, const urdf::Link& left, const urdf::Link& right,
            Findings& findings) {
  if (report_copy(model, left, right, findings)) return;
  constexpr double kWrong = 2;  // a factor that no cable or sensor explains
  const double same = 1 + findings.tolerance();
  const urdf::Inertial& one = *left.inertial;
  const urdf::Inertial& other = *right.inertial;
  const double mass = factor_of(*one.mass, *other.mass);
  if (mass > same) {
    Diagnostic& diagnostic =
        findings.report(other.mass.span, title(left) + " and " + title(right) +
                                             " differ in mass: " + format_rounded(*one.mass, 4) +
                                             " and " + format_rounded(*other.mass, 4) + " kg");
    diagnostic.label(one.mass.span, "the other side");
    if (mass > kWrong) diagnostic.severity = Severity::warning;
    return;
  }
  // Lengths and moments do not depend on the frames of the two sides.
  const double offset = std::fabs(distance_of(one) - distance_of(other));
  constexpr double kClose = 0.005;  // m
  if (offset > std::max(kClose, findings.tolerance() * distance_of(one))) {
    findings
        .report(
            tag_name(model, other.element),
            "the centres of mass of " + title(left) + " and " + title(right) +
                " are not equally far from their frames: " + format_rounded(distance_of(one), 3) +
                " and " + format_rounded(distance_of(other), 3) + " m")
        .label(tag_name(model, one.element), "the other side");
    return;
  }
  const auto a = principal_moments(one);
  const auto b = principal_moments(other);
  if (!a || !b || !is_positive_definite(*a) || !is_positive_definite(*b)) return;
  double worst = 1;  // the smallest moment of a thin part is little more than noise
  for (std::size_t i = 1; i < 3; ++i) worst = std::max(worst, factor_of((*a)[i], (*b)[i]));
  constexpr double kOfMoments = 4;  // times: they grow with the square of a length
  if (worst <= 1 + kOfMoments * findings.tolerance()) return;
  Diagnostic& diagnostic = findings.report(
      inertia_place(model, other), "the inertias of " + title(left) + " and " + title(right) +
                                       " differ by a factor of " + format_rounded(worst, 3));
  diagnostic.label(inertia_place(model, one), "the other side");
  if (worst > kWrong) diagnostic.severity = Severity::warning;
}

void check(const LinkedModel& model, Findings& findings) {
  std::vector<std::string_view> names;
  std::vector<const urdf::Link*> links;
  std::vector<std::size_t> indices;
  std::size_t next = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const std::size_t index = next++;
    if (!link.name || !link.inertial) return;
    if (!(link.inertial->mass.value_or(0) >= kNegligibleMass)) return;
    names.emplace_back(*link.name);
    links.push_back(&link);
    indices.push_back(index);
  });
  std::optional<std::vector<OddSibling>> odd;        // found only if two sides differ
  const auto is_odd = [&](const urdf::Link* link) {  // SML1530
    if (!odd) odd = odd_siblings(model, kOddFactor);
    return std::any_of(odd->begin(), odd->end(),
                       [&](const OddSibling& one) { return one.link == link; });
  };
  for (const auto& [left, right] : pairs_of_sides(names)) {
    if (has_chain(model, std::array{indices[left], indices[right]})) continue;
    const bool is_equal = have_equal_values(*links[left]->inertial, *links[right]->inertial);
    if (!is_equal && (is_odd(links[left]) || is_odd(links[right]))) continue;
    report(model, *links[left], *links[right], findings);
  }
}

}  // namespace

extern constinit const Rule sml1528_sides_differ_in_mass{
    .id = "SML1528",
    .name = "sides-differ-in-mass",
    .severity = Severity::info,
    .summary = "A left and a right link differ in mass, centre of mass or inertia.",
    .why = "The two sides of a robot are nearly always built from the same parts. If only one side "
           "was updated, the robot pulls to one side and controllers need different gains.",
    .remedy = "Compare the two inertials, and copy the newer one to the other side, mirrored.",
    .sources = "Of 991 public URDFs, 16 differ in mass by more than 5 %, and 18 in inertia.",
    .check_model = check,
    .tolerance = {.value = 0.05, .meaning = "how much the two sides may differ, as a fraction"},
    .about = About::robot};

}  // namespace smurf::rules::sml1528_sides_differ_in_mass_file
