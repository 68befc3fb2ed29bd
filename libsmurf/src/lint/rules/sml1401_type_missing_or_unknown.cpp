// SPDX-License-Identifier: BSD-3-Clause
#include "ast/urdf_attributes.hpp"
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/text/suggest.hpp"
#include "lint/mimic_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1401_type_missing_or_unknown_file {
namespace {

constexpr Circumstance kLimited{"limited"};
constexpr Circumstance kEmpty{"empty"};
constexpr Circumstance kSpherical{"spherical"};

/// True for a range that does not begin at 0, where that of a ball joint must.
bool is_limited(const urdf::Joint& joint) {
  if (!joint.limit || !joint.limit->lower || !joint.limit->upper) return false;
  return *joint.limit->lower != 0 && *joint.limit->lower < *joint.limit->upper;
}

void check(const LinkedModel& model, Findings& findings) {
  const std::set<std::string_view> followed = followed_joints(model);
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.type != urdf::JointType::unknown) return;
    if (!joint.type_name || joint.type_name->empty()) {
      Diagnostic& diagnostic =
          findings.report(name_place(model, joint), title(joint) + " has no type");
      if (joint.type_name.written) diagnostic.when(kEmpty);
      if (joint.name && followed.contains(*joint.name)) diagnostic.when(kFollowed);
      return;
    }
    Diagnostic& diagnostic =
        findings.report(joint.type_name.span, quoted(*joint.type_name) + " is not a joint type");
    if (is_limited(joint)) diagnostic.when(kLimited);
    diagnostic.help("use revolute, continuous, prismatic, fixed, floating or planar");
    if (*joint.type_name == "spherical") {
      diagnostic.when(kSpherical);
      diagnostic.note("only Bullet and MuJoCo know this type");
    }
    if (const auto near = only_nearest(*joint.type_name, urdf::kJointTypes)) {
      diagnostic.help("did you mean " + quoted(*near) + "?");
      const bool is_case = path::to_lower(*joint.type_name) == *near;
      diagnostic.fixes.push_back({is_case ? Applicability::safe : Applicability::unsafe,
                                  {{joint.type_name.span, std::string(*near)}}});
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses the joint type, and the file",
     "urdfdom, MuJoCo, run"},
    drake_misses_leader(when(kEmpty, kFollowed)),
    {&readers::drake, Effect::loses, "leaves out a joint whose type is empty", kRun, when(kEmpty)},
    {&readers::mars, Effect::crashes,
     "dereferences a null pointer, because urdfdom refuses the file",
     "MARS smurf.cpp:988-998, run"},
    {&readers::phobos, Effect::takes, "loads it and keeps the type as text", "Phobos a613e31, run"},
    {&readers::pybullet, Effect::takes, "supports spherical joints", "Bullet UrdfParser.cpp, run",
     when(kSpherical)},
    {&readers::mujoco, Effect::refuses, "refuses a ball joint whose range does not begin at 0",
     kRun, when(kSpherical, kLimited).since({3, 2})},
    {&readers::mujoco, Effect::takes, "makes it a ball joint", "MuJoCo xml_urdf.cc, run",
     when(kSpherical).since({3, 2})},
};

}  // namespace

extern constinit const Rule sml1401_type_missing_or_unknown{
    .id = "SML1401",
    .name = "type-missing-or-unknown",
    .severity = Severity::error,
    .summary = "A joint has no type, or one that URDF does not define.",
    .why = "Types are case-sensitive.",
    .remedy = "Use revolute, continuous, prismatic, fixed, floating or planar.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1401_type_missing_or_unknown_file
