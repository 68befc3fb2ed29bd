// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/readers.hpp"
#include "base/text/words.hpp"
#include "lint/geometry_queries.hpp"
#include "lint/imported_robot.hpp"

namespace smurf::rules::sml1602_shape_nonstandard_file {
namespace {

// Authors declare the version of URDF that has capsules for urdfdom.
constexpr Circumstance kDeclared{"the version has it", &readers::urdfdom};

constexpr std::string_view kStandard[] = {"box", "sphere", "cylinder", "mesh"};

void check_geometry(const LinkedModel& model, const urdf::Link& link,
                    const urdf::Geometry& geometry, Findings& findings) {
  if (geometry.shape_element == xml::kNoElement) return;
  const xml::View shape(model.robot->document, geometry.shape_element);
  const auto is_name = [&](std::string_view name) { return is_same(shape.name(), name); };
  if (std::any_of(std::begin(kStandard), std::end(kStandard), is_name)) return;
  // A shape that no reader knows is reported as an unknown element.
  const std::string_view known[] = {"capsule", "plane", "cdf", "ellipsoid"};
  if (std::none_of(std::begin(known), std::end(known), is_name)) return;
  Diagnostic& diagnostic =
      findings.report(shape.name_span(), quoted(shape.name()) + " is not a shape of URDF 1.0");
  // The file has it in its own language; targets judge the URDF that is made of it.
  if (is_of_other_language(model)) diagnostic.severity = Severity::info;
  diagnostic.note("urdfdom before 5.1 drops it and everything after it from " + title(link));
  if (is_name("capsule") && is_one_of(model.robot->version.value_or(""), {"1.1", "1.2"})) {
    diagnostic.when(kDeclared);
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    check_geometry(model, use.link, use.geometry, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "knows capsules", "urdfdom 5.1.0, read",
     when(kDeclared).since({5, 1})},
    urdfdom_drops_shapes({}, "urdfdom link.cpp:224, run"),
    {&readers::pybullet, Effect::takes, "knows it", "Bullet UrdfParser.cpp, run", at("capsule")},
    {&readers::pybullet, Effect::takes, "knows it", "Bullet UrdfParser.cpp, run", at("plane")},
    {&readers::pybullet, Effect::takes, "knows it", "Bullet UrdfParser.cpp, run", at("cdf")},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", "Bullet UrdfParser.cpp, run"},
    {&readers::mujoco, Effect::takes, "supports capsules", kRun, at("capsule")},
    {&readers::mujoco, Effect::refuses, "refuses the shape", kRun},
    {&readers::drake, Effect::takes, "supports capsules", kRun, at("capsule")},
    {&readers::drake, Effect::refuses, "refuses the shape", kRun},
};

}  // namespace

extern constinit const Rule sml1602_shape_nonstandard{
    .id = "SML1602",
    .name = "shape-nonstandard",
    .severity = Severity::error,
    .summary = "A geometry is a shape that URDF 1.0 does not define.",
    .remedy = "Use box, sphere, cylinder or mesh; a capsule can be a cylinder and two spheres.",
    .sources = "capsule since urdfdom 5.1 (pull request 238).",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1602_shape_nonstandard_file
