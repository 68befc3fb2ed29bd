// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/numbers/numbers.hpp"
#include "base/numbers/vectors.hpp"
#include "link/shape_solids.hpp"
#include "lint/body.hpp"
#include "lint/likely_cause.hpp"
#include "lint/model_answers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1521_center_of_mass_outside_geometry_file {
namespace {

/// The mistake that explains a centre outside of the box; empty if there is none.
std::string question_of(const Vector3& center, const Extent& extent) {
  constexpr std::pair<double, std::string_view> kUnits[] = {{1e-3, "millimetres"},
                                                            {1e-2, "centimetres"}};
  double distance = 0;
  for (const double x : center) distance = std::max(distance, std::fabs(x));
  for (const auto& [factor, unit] : kUnits) {
    const Vector3 inside{center[0] * factor, center[1] * factor, center[2] * factor};
    constexpr double kLeast = 0.02;  // of the longest edge; any unit explains a centre at 0
    const bool is_there = distance * factor > kLeast * extent.longest_edge();
    if (is_there && extent.contains(inside)) return "is it in " + std::string(unit) + "?";
  }
  for (std::size_t i = 0; i < 3; ++i) {
    Vector3 turned = center;
    turned[i] = -turned[i];
    if (extent.contains(turned)) return "is the sign of " + std::string(1, "xyz"[i]) + " wrong?";
  }
  return {};
}

/// The centre of the shapes, or of the box around them.
std::string center_of_shapes(const LinkedModel& model, const urdf::Link& link,
                             const Extent& extent) {
  const auto solid = solid_of(model, link);
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = solid ? solid->center[i] : (extent.low[i] + extent.high[i]) / 2;
    constexpr double kSmall = 1e-3;  // of the longest edge; rounding of the mesh
    const bool is_zero = std::fabs(x) < kSmall * extent.longest_edge();
    text += (i == 0 ? "" : " ") + format_rounded(is_zero ? 0 : x, 3);
  }
  return text;
}

/// Whether the shapes are too small or too large by a factor that also explains the centre.
bool is_about_size(const LinkedModel& model, const urdf::Link& link, const Extent& extent) {
  const auto body = body_of(*link.inertial);
  if (!body) return false;
  const double density = body->mass / extent.volume();
  if (density <= kHeaviestMaterial && density >= kLightestMaterial) return false;
  return likely_cause(model, link, *body, extent).culprit == Culprit::shape;
}

/// The centre in the frame of the link, if the written one fits the shapes in that of the parent.
std::optional<Vector3> center_from_parent(const LinkedModel& model, const urdf::Link& link,
                                          std::size_t index, const Extent& extent) {
  constexpr double kSame = 0.01;  // of the longest edge
  constexpr double kOther = 0.15;
  const auto joint = model.tree.parent_joint[index];
  if (!joint || !link.inertial->origin.xyz) return std::nullopt;
  const std::optional<Solid> solid = solid_of(model, link);
  if (!solid) return std::nullopt;
  const Vector3 written = urdf::to_pose(link.inertial->origin).position;
  const Pose X_LP = inverse(urdf::to_pose(model.joint(*joint).origin));
  const Vector3 turned = rotate(X_LP.orientation, written);
  const Vector3 meant{X_LP.position[0] + turned[0], X_LP.position[1] + turned[1],
                      X_LP.position[2] + turned[2]};
  const auto distance = [&](const Vector3& point) {
    const Vector3 d = difference(point, solid->center);
    return std::sqrt(dot(d, d)) / extent.longest_edge();
  };
  if (distance(meant) > kSame || distance(written) < kOther) return std::nullopt;
  return meant;
}

/// Reports it; false if the centre is where it is written.
bool report_from_parent(const LinkedModel& model, const urdf::Link& link, std::size_t index,
                        const Extent& extent, Findings& findings) {
  const auto meant = center_from_parent(model, link, index, extent);
  if (!meant) return false;
  findings
      .report(link.inertial->origin.xyz.span, "the centre of mass of " + title(link) +
                                                  " is that of its shapes, but in the frame of the "
                                                  "parent")
      .help("in the frame of the link, it is `" + format_rounded((*meant)[0], 4) + " " +
            format_rounded((*meant)[1], 4) + " " + format_rounded((*meant)[2], 4) + "`");
  return true;
}

void check(const LinkedModel& model, Findings& findings) {
  std::size_t next = 0;
  constexpr double kOfCollisions = 5;  // times; they need not hold the whole part
  for_each_link(model, [&](const urdf::Link& link) {
    const std::size_t index = next++;
    const std::optional<Extent>& extent = findings.answers().extent(link);
    if (!extent || !link.inertial || link.inertial->mass.value_or(0) < kNegligibleMass) return;
    const urdf::Inertial& inertial = *link.inertial;
    const double margin = findings.tolerance() * (link.visuals.empty() ? kOfCollisions : 1);
    const Vector3 center = urdf::to_pose(inertial.origin).position;
    if (std::any_of(center.begin(), center.end(),
                    [](double x) { return std::fabs(x) > kFarthestOrigin; })) {
      return;  // SML1442
    }
    if (report_from_parent(model, link, index, *extent, findings)) return;
    if (extent->grown(margin * extent->longest_edge()).contains(center)) return;
    const auto parts = extent_of_rigid_parts(model, link);
    if (!parts || parts->grown(margin * parts->longest_edge()).contains(center)) return;
    if (is_about_size(model, link, *extent)) return;  // SML1520
    const bool has_origin = !inertial.origin.xyz.span.empty();
    if (has_origin && !inertial.origin.xyz) return;  // unreadable
    Diagnostic& diagnostic =
        findings.report(has_origin ? inertial.origin.xyz.span : tag_name(model, inertial.element),
                        "the centre of mass of " + title(link) + " lies outside its shapes");
    std::string box;
    for (std::size_t i = 0; i < 3; ++i) {
      box += (i == 0 ? "" : ", ") + std::string(1, "xyz"[i]) + " " +
             format_rounded(extent->low[i], 3) + " to " + format_rounded(extent->high[i], 3);
    }
    diagnostic.note("they reach from " + box + " in the frame of the link");
    if (std::string question = question_of(center, *extent); has_origin && !question.empty()) {
      diagnostic.help(std::move(question));
    } else {
      diagnostic.help(std::string(has_origin ? "write" : "add an `origin` with") +
                      " the measured centre, or that of the shapes, `" +
                      center_of_shapes(model, link, *extent) + "`");
    }
  });
}

}  // namespace

extern constinit const Rule sml1521_center_of_mass_outside_geometry{
    .id = "SML1521",
    .name = "center-of-mass-outside-geometry",
    .severity = Severity::warning,
    .summary = "The centre of mass of a link lies outside its shapes.",
    .why =
        "The centre of mass of a part is always inside the box around it. Here, the origin of the "
        "inertial is in another unit or frame, or was forgotten. The simulated robot then falls "
        "over, or swings differently from the real one.",
    .remedy = "Write the origin of the inertial in metres, in the frame of the link.",
    .sources = "24 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .tolerance =
        {.value = 0.1,
         .meaning =
             "how far outside the centre of mass may lie, as a fraction of the longest edge"},
    .about = About::robot};

}  // namespace smurf::rules::sml1521_center_of_mass_outside_geometry_file
