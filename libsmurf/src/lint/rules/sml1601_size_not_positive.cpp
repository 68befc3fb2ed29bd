// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1601_size_not_positive_file {
namespace {

constexpr Circumstance kZero{"zero"};

void check_extent(const Field<double>& extent, std::string_view what, Findings& findings) {
  if (!extent || *extent > 0) return;
  Diagnostic& diagnostic =
      findings.report(extent.span, "the " + std::string(what) + " is " + format_number(*extent) +
                                       ", but must be positive");
  if (*extent == 0) diagnostic.when(kZero);
}

void check_shape(const urdf::Shape& shape, Findings& findings) {
  if (const auto* box = std::get_if<urdf::Box>(&shape)) {
    if (!box->size) return;
    for (const double edge : *box->size) {
      if (edge > 0) continue;
      findings.report(box->size.span, "a box has an edge of " + format_number(edge) +
                                          ", but edges must be positive");
      return;
    }
  } else if (const auto* sphere = std::get_if<urdf::Sphere>(&shape)) {
    check_extent(sphere->radius, "radius", findings);
  } else if (const auto* cylinder = std::get_if<urdf::Cylinder>(&shape)) {
    check_extent(cylinder->radius, "radius", findings);
    check_extent(cylinder->length, "length", findings);
  } else if (const auto* capsule = std::get_if<urdf::Capsule>(&shape)) {
    check_extent(capsule->radius, "radius", findings);
    check_extent(capsule->length, "length", findings);
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model,
                    [&](const GeometryUse& use) { check_shape(use.geometry.shape, findings); });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "keeps the number", kRun},
    {&readers::dart, Effect::takes, "knows no such shape", kRun, at("capsule")},
    {&readers::urdfdom, Effect::takes, "keeps the number", kRun},
    {&readers::mars, Effect::breaks,
     "stops loading here, so all later objects, the pose and the anchor are missing",
     "MARS smurf.cpp:1014-1058, NodePhysics.cpp:626-634"},
    {&readers::dart, Effect::crashes, "ends the process with an assertion", kRun, before({6, 20})},
    {&readers::mujoco, Effect::refuses, "refuses a size that is not positive", kRun},
    {&readers::drake, Effect::takes, "accepts a sphere of radius 0", kRun,
     at("sphere/@radius").when(kZero)},
    {&readers::drake, Effect::refuses, "refuses a size that is not positive", kRun},
    {&readers::phobos, Effect::takes, "keeps the number", kRun},
};

}  // namespace

extern constinit const Rule sml1601_size_not_positive{
    .id = "SML1601",
    .name = "size-not-positive",
    .severity = Severity::error,
    .summary = "A size, radius or length of a shape is zero or negative.",
    .remedy =
        "Write a length above 0, in metres: the radius of a round shape, the whole sides of a box.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1601_size_not_positive_file
