// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "base/findings/readers.hpp"
#include "base/text/counted.hpp"
#include "lint/queries.hpp"
#include "readers/sdformat_losses.hpp"

namespace smurf::rules::sml1453_massless_mount_file {
namespace {

/// The joint to the link is fixed, and a Gazebo element keeps it.
constexpr Circumstance kKept{"kept joint"};

std::string reason(const LostLimb& limb) {
  if (limb.is_unread) return " that Gazebo can read";
  if (!limb.is_merged) return ", and it is kept apart";
  return ", and " + counted(limb.links, "link hangs", "links hang") + " on it";
}

void check(const LinkedModel& model, Findings& findings) {
  for (const LostLimb& limb : limbs_lost_by_sdformat(model)) {
    const urdf::Link& mount = model.link(limb.mount);
    Diagnostic& diagnostic =
        findings.report(name_place(model, mount), title(mount) + " has no mass" + reason(limb));
    diagnostic.note(limb.is_merged || limb.is_unread
                        ? "Gazebo then has " + counted(limb.links, "link") + " and " +
                              counted(limb.links, "joint") + " less"
                        : "Gazebo then has " + counted(limb.links, "link") + " less");
    diagnostic.help(limb.is_unread
                        ? "write its mass as a number without anything beside it"
                        : "give " + title(mount) + " a small mass and inertia, such as 0.001 kg");
    if (!limb.is_merged) diagnostic.when(kKept);
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "drops the link with everything below it", kRun, when(kKept)},
    {&readers::gazebo, Effect::loses,
     "drops everything below the link (sdformat before 9.10.1, 12.7.2 and 13.5)", kRun,
     before({12, 7, 2})},
    {&readers::gazebo, Effect::takes, "merges the link, and keeps what is below it",
     "sdformat 12.7.2 parser_urdf.cc:2570-2690"},
};

}  // namespace

extern constinit const Rule sml1453_massless_mount{
    .id = "SML1453",
    .name = "massless-mount",
    .severity = Severity::warning,
    .summary = "Joints lead on from a link that has no mass, alone or with what is fixed to it.",
    .why =
        "The conversion to SDF merges the link into its parent. It first looks at the mass of the link and of what is fixed to it, and drops the rest of the limb if that mass is 0.",
    .remedy =
        "Give the link a small mass and inertia, or attach the joints to the link that it is fixed to.",
    .sources = "urdf2webots issue 212; the legs of Cassie and iCub.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1453_massless_mount_file
