// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

void check_extent(const Field<double>& extent, std::string_view what, Findings& findings) {
  if (!extent || *extent > 0) return;
  findings.report(extent.span, "the " + std::string(what) + " is " + format_number(*extent) +
                                   ", but must be positive");
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

}  // namespace

extern constinit const Rule sml1601_size_not_positive{
    .id = "SML1601",
    .name = "size-not-positive",
    .severity = Severity::error,
    .summary = "A size, radius or length of a shape is zero or negative.",
    .why = "MuJoCo and Drake refuse the file, DART aborts the process; urdfdom accepts it.",
    .remedy = "Write the full extent, in metres.",
    .sources = "MuJoCo 3.14 and DART 6.12, executed.",
    .check_model = check};

}  // namespace smurf::rules
