// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

constexpr std::string_view kStandard[] = {"box", "sphere", "cylinder", "mesh"};

void check_geometry(const LinkedModel& model, const urdf::Link& link,
                    const urdf::Geometry& geometry, Findings& findings) {
  if (geometry.shape_element == xml::kNoElement) return;
  const xml::View shape(model.robot->document, geometry.shape_element);
  if (std::find(std::begin(kStandard), std::end(kStandard), shape.name()) != std::end(kStandard)) {
    return;
  }
  // What is no shape of any reader is an unknown element and reported as such.
  const std::string_view known[] = {"capsule", "plane", "cdf", "ellipsoid"};
  if (std::find(std::begin(known), std::end(known), shape.name()) == std::end(known)) return;
  findings.report(shape.name_span(), quoted(shape.name()) + " is no shape of URDF 1.0")
      .notes.push_back("urdfdom before 5.1 drops it and everything after it from " + title(link));
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    check_geometry(model, use.link, use.geometry, findings);
  });
}

}  // namespace

extern constinit const Rule sml1602_shape_nonstandard{
    .id = "SML1602",
    .name = "shape-nonstandard",
    .severity = Severity::error,
    .summary = "A geometry is a shape that URDF 1.0 does not define.",
    .why = "urdfdom up to 5.0 drops the rest of the link silently: RViz, Gazebo, DART and "
           "Pinocchio see a link without this and all later shapes.",
    .remedy = "Use box, sphere, cylinder or mesh; a capsule can be a cylinder and two spheres.",
    .sources = "urdfdom 3.0.1 link.cpp:224, executed; capsule since urdfdom 5.1 (pull request "
               "238).",
    .check_model = check};

}  // namespace smurf::rules
