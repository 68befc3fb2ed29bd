// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "ast/urdf_numbers.hpp"
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "lint/inertia_slips.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"
#include "readers/sdformat_losses.hpp"

namespace smurf::rules::sml1512_not_positive_definite_file {
namespace {

/// MuJoCo before 3.1.3 takes a negative moment for 0, and refuses what is no body even then.
constexpr Circumstance kLopsided{"breaks the triangle inequality also with 0 for what is negative"};

/// The place of an entry that is too small for a double, which most readers read as 0.
std::optional<Span> find_underflow(const LinkedModel& model, const urdf::Inertial& inertial) {
  const xml::View element = xml::View(model.robot->document, inertial.element).child("inertia");
  if (!element) return std::nullopt;
  for (const xml::Attribute& at : element.attributes()) {
    if (is_underflow(at.value())) return at.value_span();
  }
  return std::nullopt;
}

void check(const LinkedModel& model, Findings& findings) {
  InertialsTogether together(model);
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const std::size_t at = index++;
    if (!link.inertial) return;
    const auto moments = principal_moments(*link.inertial);
    if (!moments) {
      const auto place = find_underflow(model, *link.inertial);
      if (!place) return;
      if (!together.is_sound(at)) findings.add_consequence(*place);
      return;
    }
    const auto& [low, middle, high] = *moments;
    if (are_zero(*moments)) return;  // another defect
    if (is_positive_definite(*moments)) return;
    Diagnostic& diagnostic =
        findings.report(inertia_place(model, *link.inertial),
                        "the inertia of " + title(link) + " is not physically possible");
    diagnostic.when(kNotPositiveDefinite);
    const std::array without_negative{std::max(low, 0.0), std::max(middle, 0.0),
                                      std::max(high, 0.0)};
    if (triangle_excess(without_negative) > 0) diagnostic.when(kLopsided);
    together.tell(at, diagnostic);
    diagnostic.caret = "principal moments " + format_rounded(low, 4) + ", " +
                       format_rounded(middle, 4) + ", " + format_rounded(high, 4);
    diagnostic.note("the principal moments of a body must be positive");
    add_likely_slip(model, link, diagnostic);
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "keeps the numbers", kRun},
    {&readers::mars, Effect::breaks, "passes the inertia to ODE, which reports it as wrong",
     "ODE dMassCheck, run"},
    {&readers::phobos, Effect::takes, "keeps the numbers", kRun},
    {&readers::pybullet, Effect::ignores,
     "computes the inertia from the collisions, unless told otherwise", kRun},
    {&readers::gazebo, Effect::takes,
     "merges the link into the body it is fixed to, or drops the link", kRun, when(kSoundTogether)},
    kGazeboLeavesOut,
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun},
    {&readers::dart, Effect::changes, "computes with it anyway", kRun},
    {&readers::mujoco, Effect::refuses, "refuses the inertia", "3.1.2, run",
     when(kLopsided).before({3, 1, 3})},
    {&readers::mujoco, Effect::changes, "computes with it where other bodies move with it",
     "3.1.2, run", before({3, 1, 3}).unless(kAlone)},
    {&readers::mujoco, Effect::refuses, "refuses the inertia", "MuJoCo user_util.cc:862, run"},
    {&readers::drake, Effect::changes, "replaces the body by a sphere of water with that mass",
     kRun},
};

}  // namespace

extern constinit const Rule sml1512_not_positive_definite{
    .id = "SML1512",
    .name = "not-positive-definite",
    .severity = Severity::error,
    .summary = "An inertia tensor has a principal moment that is not positive.",
    .why = "No body has such an inertia.",
    .remedy = "Compute the inertia again, e.g. from the geometry and the mass.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1512_not_positive_definite_file
