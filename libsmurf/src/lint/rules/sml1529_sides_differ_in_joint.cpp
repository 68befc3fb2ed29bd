// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"
#include "lint/sides.hpp"

namespace smurf::rules::sml1529_sides_differ_in_joint_file {
namespace {

std::string bounds_of(const urdf::Limit& limit) {
  return format_rounded(*limit.lower, 4) + " to " + format_rounded(*limit.upper, 4);
}

/// Values of both sides that differ, in words, and the places of the first.
struct Differences {
  std::string words;
  Span place, other;

  void add(const Field<double>& a, const Field<double>& b, std::string_view what,
           double tolerance) {
    if (!a || !b || are_near(*a, *b, tolerance)) return;
    if (words.empty()) {
      place = b.span;
      other = a.span;
    }
    words += (words.empty() ? "`" : ", `") + std::string(what) + "` (" + format_rounded(*a, 4) +
             " and " + format_rounded(*b, 4) + ")";
  }
};

void report(const urdf::Joint& left, const urdf::Joint& right, Findings& findings) {
  if (left.type != right.type) {
    Diagnostic& diagnostic =
        findings.report(right.type_name.span, title(left) + " is " + *left.type_name + ", but " +
                                                  title(right) + " is " + *right.type_name);
    diagnostic.label(left.type_name.span, "the other side");
    if (left.is_movable() && right.is_movable()) diagnostic.severity = Severity::warning;
    return;
  }
  if (!left.limit || !right.limit) return;
  const urdf::Limit& a = *left.limit;
  const urdf::Limit& b = *right.limit;
  const bool has_bounds = a.lower && a.upper && b.lower && b.upper;
  const double tolerance = findings.tolerance();
  if (has_bounds && !have_same_bounds(a, b, tolerance) && !have_turned_bounds(a, b, tolerance)) {
    findings
        .report(b.lower.span, title(left) + " moves from " + bounds_of(a) + ", but " +
                                  title(right) + " from " + bounds_of(b))
        .label(a.lower.span, "the other side");
    return;
  }
  Differences differences;
  differences.add(a.effort, b.effort, "effort", findings.tolerance());
  differences.add(a.velocity, b.velocity, "velocity", findings.tolerance());
  if (left.dynamics && right.dynamics) {
    differences.add(left.dynamics->damping, right.dynamics->damping, "damping",
                    findings.tolerance());
  }
  if (differences.words.empty()) return;
  findings
      .report(differences.place,
              title(left) + " and " + title(right) + " differ in " + differences.words)
      .label(differences.other, "the other side");
}

/// Whether neither joint is below the other, so that they can be a left and a right one.
bool are_sides(const LinkedModel& model, std::size_t left, std::size_t right) {
  const auto& child = model.tree.joint_child;
  if (!child[left] || !child[right]) return true;
  return !has_chain(model, std::array{to_size(*child[left]), to_size(*child[right])});
}

void check(const LinkedModel& model, Findings& findings) {
  std::vector<std::string_view> names;
  std::vector<const urdf::Joint*> joints;
  std::vector<std::size_t> indices;
  std::size_t next = 0;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const std::size_t index = next++;
    if (!joint.name || !joint.type_name || joint.type == urdf::JointType::unknown) return;
    names.emplace_back(*joint.name);
    joints.push_back(&joint);
    indices.push_back(index);
  });
  for (const auto& [left, right] : pairs_of_sides(names)) {
    if (!are_sides(model, indices[left], indices[right])) continue;
    report(*joints[left], *joints[right], findings);
  }
}

}  // namespace

extern constinit const Rule sml1529_sides_differ_in_joint{
    .id = "SML1529",
    .name = "sides-differ-in-joint",
    .severity = Severity::info,
    .summary = "A left and a right joint differ in type, limits or damping.",
    .why = "The two sides of a robot nearly always move alike. Bounds may have the opposite sign, "
           "because the axis of one side is mirrored, but they span the same range.",
    .remedy = "Compare the two joints, and correct the one that was not updated.",
    .sources = "Of 991 public URDFs, 23 differ in their bounds, and 5 in a joint type.",
    .check_model = check,
    .tolerance = {.value = 0.05, .meaning = "how much the two sides may differ, as a fraction"},
    .about = About::robot};

}  // namespace smurf::rules::sml1529_sides_differ_in_joint_file
