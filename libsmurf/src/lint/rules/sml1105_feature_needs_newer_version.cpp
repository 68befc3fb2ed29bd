// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "base/findings/readers.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1105_feature_needs_newer_version_file {
namespace {

// Authors declare the version of URDF that has the attribute for urdfdom.
constexpr Circumstance kDeclared{"the version has it", &readers::urdfdom};

constexpr std::string_view kRotation = "quat_xyzw";
constexpr std::string_view kLimits[] = {"acceleration", "deceleration", "jerk"};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (const xml::Attribute& attribute : model.robot->document.attributes) {
    const std::string_view name = attribute.name();
    const bool is_limit = std::any_of(std::begin(kLimits), std::end(kLimits),
                                      [&](std::string_view one) { return is_same(name, one); });
    if (!is_limit && !is_same(name, kRotation)) continue;
    Diagnostic& diagnostic =
        findings.report(attribute.name_span(), quoted(name) + " is ignored by readers of URDF 1.0");
    const std::string version = model.robot->version.value_or("");
    if (version == "1.2" || (version == "1.1" && !is_limit)) diagnostic.when(kDeclared);
    // The robot without such a limit is the same; without the rotation it is another one.
    if (is_limit) diagnostic.severity = Severity::info;
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "reads the rotation", "urdfdom 5.1.0, read",
     at("@quat_xyzw").when(kDeclared).since({5, 1})},
    {&readers::urdfdom, Effect::takes, "reads the attribute", "urdfdom 6.0.0, read",
     when(kDeclared).since({6, 0})},
    {&readers::urdf, Effect::changes, "ignores the rotation, so the frame is not turned",
     "urdfdom, sdformat, MuJoCo, Bullet, run", at("@quat_xyzw")},
    {&readers::urdf, Effect::ignores, "ignores the attribute", "urdfdom, MuJoCo, run"},
};

}  // namespace

extern constinit const Rule sml1105_feature_needs_newer_version{
    .id = "SML1105",
    .name = "feature-needs-newer-version",
    .severity = Severity::error,
    .summary = "An attribute belongs to a newer version of URDF than most readers support.",
    .remedy =
        "Write the rotation as rpy; leave the limits out, or set them where your controller reads "
        "them.",
    .sources = "urdfdom pull requests 212 and 235.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1105_feature_needs_newer_version_file
