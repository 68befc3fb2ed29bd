// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo, which has its own URDF reader.
#include "link/mujoco_compiler.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::readers::mujoco_file {
namespace {

using enum Effect;

constexpr FamilyFact kFamilies[] = {
    {"SML18", {&mujoco, refuses, "refuses the number", kRun}},
};

constexpr std::string_view kVisuals = "discards visuals, except for their materials";
constexpr std::string_view kIgnores = "does not look at it";

constexpr Fact kUnread[] = {
    {&mujoco, ignores, kVisuals, "MuJoCo (discardvisual), run",
     at("visual/origin").unless(kVisualsKept)},
    {&mujoco, ignores, kVisuals, "MuJoCo (discardvisual), run",
     at("visual/geometry").unless(kVisualsKept)},
    {&mujoco, ignores, "gives the world no mass", kRun,
     when(kOfWorld).unless(kNotPositiveDefinite)},
    {&mujoco, ignores, kIgnores, kRun, at("joint/limit").when(kInFixed)},
    {&mujoco, ignores, kIgnores, kRun, at("joint/dynamics").when(kInFixed)},
    {&mujoco, ignores, kIgnores, kRun, at("joint/mimic").when(kInFixed)},
    {&mujoco, ignores, kIgnores, kRun, at("joint/mimic").when(kInFloating)},
    {&mujoco, ignores, kIgnores, kRun, at("texture").unless(kVisualsKept)},
    {&mujoco, ignores, kIgnores, kRun, at("calibration")},
    {&mujoco, ignores, kIgnores, kRun, at("safety_controller")},
    {&mujoco, ignores, kIgnores, kRun, at("limit/@velocity")},
    {&mujoco, ignores, kIgnores, kRun, at("robot/@version")},
    {&mujoco, ignores, kIgnores, kRun, at("transmission")},
    {&mujoco, ignores, kIgnores, kRun, at("gazebo")},
};

/// Whether a link moves only together with the body to which it is fixed, or not at all.
bool is_carried(const LinkedModel& model, std::size_t link) {
  const auto above = model.tree.parent_joint[link];
  return !above || model.joint(*above).type == urdf::JointType::fixed;
}

/// What moves the links of findings in inertials.
class Motion {
 public:
  explicit Motion(const LinkedModel& model) : model_(model) {}

  void see(Diagnostic& finding) {
    const urdf::Link* part = part_at(model_.robot->links, finding.span.begin);
    if (part == nullptr) return;
    const std::size_t link = index_in(model_.robot->links, *part);
    if (is_carried(model_, link)) {
      if (still_.empty()) still_ = fixed_to_root(model_);
      finding.when(kCarried);
      if (still_[link]) finding.when(kStill);
      return;
    }
    if (alone_.empty()) alone_ = alone_in_motion(model_);
    if (alone_[link]) finding.when(kAlone);
  }

 private:
  const LinkedModel& model_;
  std::vector<bool> alone_, still_;  ///< by link; computed when they are needed
};

void see(const LinkedModel& model, std::span<Diagnostic* const> found) {
  Motion motion(model);
  const bool are_balanced = balances_inertias(model), has_visuals = keeps_visuals(model),
             looks_elsewhere = is_told_where_meshes_are(model);
  for (Diagnostic* finding : found) {
    const std::vector<PlaceName> place = place_of(*finding);
    const bool is_in_inertial = contains(place, at("robot/link/inertial"));
    if (is_in_inertial) motion.see(*finding);
    if (are_balanced && is_in_inertial) finding->when(kBalanced);
    if (has_visuals && contains(place, at("visual"))) finding->when(kVisualsKept);
    if (looks_elsewhere && contains(place, at("mesh/@filename"))) finding->when(kElsewhere);
  }
}

constexpr ReaderVersion kOld[] = {{&mujoco, {2, 2}}};
constexpr ReaderVersion kNew[] = {{&mujoco, {3, 14}}};
constexpr Reader old_release{.name = "mujoco:2.2",
                             .title = "MuJoCo 2.2",
                             .basis = "2.2, not executed",
                             .like = &mujoco,
                             .parts = kOld};
constexpr Reader new_release{.name = "mujoco:3.14",
                             .title = "MuJoCo 3.14",
                             .basis = "3.14.0 (npm), executed",
                             .like = &mujoco,
                             .parts = kNew};
constexpr const Reader* kReleases[] = {&old_release, &new_release};

}  // namespace

extern constinit const Reader mujoco{.name = "mujoco",
                                     .title = "MuJoCo",
                                     .basis = "3.14.0 (npm), executed; a725507 (about 3.12) read",
                                     .like = &urdf,
                                     .version = "MuJoCo 3.14",
                                     .families = kFamilies,
                                     .unread = kUnread,
                                     .number = {3, 14},
                                     .releases = kReleases,
                                     .see = see};

}  // namespace smurf::readers::mujoco_file
