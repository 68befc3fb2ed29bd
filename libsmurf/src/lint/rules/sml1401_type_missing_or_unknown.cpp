// SPDX-License-Identifier: BSD-3-Clause
#include "base/path.hpp"
#include "base/suggest.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

constexpr std::string_view kTypes[] = {"revolute", "continuous", "prismatic",
                                       "fixed",    "floating",   "planar"};

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.type != urdf::JointType::unknown) return;
    if (!joint.type_name || joint.type_name->empty()) {
      findings.report(name_place(model, joint), title(joint) + " has no type");
      return;
    }
    Diagnostic& diagnostic =
        findings.report(joint.type_name.span, quoted(*joint.type_name) + " is not a joint type");
    diagnostic.construct = *joint.type_name;
    diagnostic.help = "use revolute, continuous, prismatic, fixed, floating or planar";
    if (*joint.type_name == "spherical") {
      diagnostic.notes.push_back("only Bullet and MuJoCo know this type");
    }
    if (const auto near = nearest(*joint.type_name, kTypes)) {
      diagnostic.help = "did you mean " + quoted(*near) + "?";
      const bool is_case = path::to_lower(*joint.type_name) == *near;
      diagnostic.fixes.push_back({is_case ? Applicability::safe : Applicability::unsafe,
                                  {{joint.type_name.span, std::string(*near)}}});
    }
  });
}

}  // namespace

extern constinit const Rule sml1401_type_missing_or_unknown{
    .id = "SML1401",
    .name = "type-missing-or-unknown",
    .severity = Severity::error,
    .summary = "A joint has no type, or one that URDF does not define.",
    .why = "Every reader refuses the file; types are case-sensitive. Only Bullet and MuJoCo know a "
           "seventh type, spherical.",
    .remedy = "Use revolute, continuous, prismatic, fixed, floating or planar.",
    .sources = "urdfdom 3.0.1, sdformat 12.3, MuJoCo 3.14 and Bullet, executed.",
    .check_model = check};

}  // namespace smurf::rules
