// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo, which has its own URDF reader.
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"
#include "link/mujoco_compiler.hpp"
#include "link/shape_solids.hpp"
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
constexpr std::string_view kUnbounded = "does not read the bounds of such a joint";

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
    {&mujoco, ignores, "does not read `mimic`", "3.12.0, run", at("joint/mimic").before({3, 13})},
    {&mujoco, ignores, kUnbounded, "4.0.0, run",
     at("joint/limit/@lower").when(kInContinuous).since({4, 0})},
    {&mujoco, ignores, kUnbounded, "4.0.0, run",
     at("joint/limit/@upper").when(kInContinuous).since({4, 0})},
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

bool has_no_moments(const urdf::Link& link) {
  if (!link.inertial) return false;
  const auto& inertial = *link.inertial;
  return inertial.ixx.value_or(1) == 0 && inertial.iyy.value_or(1) == 0 &&
         inertial.izz.value_or(1) == 0;
}

/// What moves the links of findings in inertials.
class Motion {
 public:
  explicit Motion(const LinkedModel& model) : model_(model) {}

  void see(Diagnostic& finding) {
    const urdf::Link* part = part_at(model_.robot->links, finding.span.begin);
    if (part == nullptr) return;
    const std::size_t link = index_in(model_.robot->links, *part);
    if (finding.rule == &rules::sml1114_tag_case) {
      if (massless_.empty()) massless_ = massless_bodies(model_, Case::heeded);
      if (massless_[link]) finding.when(kMasslessBody);
      return;
    }
    if (has_no_moments(*part)) finding.when(kWithoutMoments);
    if (alone_.empty()) alone_ = alone_in_motion(model_);
    if (alone_[link]) finding.when(kAlone);
    if (!is_carried(model_, link)) {
      // What becomes of a sum with infinity depends on its place.
      if (!alone_[link] && finding.rule == &rules::sml1804_number_infinite) {
        finding.when(kUncertain);
      }
      return;
    }
    if (still_.empty()) still_ = fixed_to_root(model_);
    finding.when(kCarried);
    if (still_[link]) finding.when(kStill);
  }

 private:
  const LinkedModel& model_;
  std::vector<bool> alone_, still_, massless_;  ///< by link; computed when they are needed
};

void see(const LinkedModel& model, std::span<Diagnostic* const> found) {
  Motion motion(model);
  const bool are_balanced = balances_inertias(model), has_visuals = keeps_visuals(model),
             looks_elsewhere = is_told_where_meshes_are(model);
  for (Diagnostic* finding : found) {
    const std::vector<PlaceName> place = place_of(*finding);
    const bool is_in_inertial = contains(place, at("robot/link/inertial"));
    if (is_in_inertial || finding->rule == &rules::sml1114_tag_case) motion.see(*finding);
    if (are_balanced && is_in_inertial) finding->when(kBalanced);
    if (has_visuals && contains(place, at("visual"))) finding->when(kVisualsKept);
    if (!contains(place, at("mesh/@filename"))) continue;
    if (looks_elsewhere) finding->when(kElsewhere);
    const MeshReference* mesh = find_reference(model, finding->span.begin);
    if (mesh != nullptr && mesh->lies_beside) finding->when(kBeside);
  }
}

constexpr ReaderVersion kIn23[] = {{&mujoco, {2, 3, 7}}};
constexpr Reader kMujoco23{.name = "mujoco:2.3",
                           .title = "MuJoCo 2.3",
                           .basis = "2.3.7, executed",
                           .like = &mujoco,
                           .parts = kIn23};
constexpr ReaderVersion kIn31[] = {{&mujoco, {3, 1, 6}}};
constexpr Reader kMujoco31{.name = "mujoco:3.1",
                           .title = "MuJoCo 3.1",
                           .basis = "3.1.6, executed",
                           .like = &mujoco,
                           .parts = kIn31};
constexpr ReaderVersion kIn33[] = {{&mujoco, {3, 3, 7}}};
constexpr Reader kMujoco33{.name = "mujoco:3.3",
                           .title = "MuJoCo 3.3",
                           .basis = "3.3.7, executed",
                           .like = &mujoco,
                           .parts = kIn33};
constexpr ReaderVersion kIn314[] = {{&mujoco, {3, 14}}};
constexpr Reader kMujoco314{.name = "mujoco:3.14",
                            .title = "MuJoCo 3.14",
                            .basis = "3.14.0, executed",
                            .like = &mujoco,
                            .parts = kIn314};
constexpr ReaderVersion kIn40[] = {{&mujoco, {4, 0}}};
constexpr Reader kMujoco40{.name = "mujoco:4.0",
                           .title = "MuJoCo 4.0",
                           .basis = "4.0.0, executed",
                           .like = &mujoco,
                           .parts = kIn40};
// MuJoCo fixes errors in its newest releases only. Most facts come from runs of 3.14.
constexpr const Reader* kEarlier[] = {&kMujoco23, &kMujoco31, &kMujoco33};
constexpr const Reader* kReleases[] = {&kMujoco314, &kMujoco40};

}  // namespace

extern constinit const Reader mujoco{.name = "mujoco",
                                     .title = "MuJoCo",
                                     .basis = "3.14.0 (npm), executed; a725507 (about 3.12) read; "
                                              "changes between releases from 17 of them, executed",
                                     .like = &urdf,
                                     .version = "MuJoCo 3.14",
                                     .families = kFamilies,
                                     .unread = kUnread,
                                     .number = {3, 14},
                                     .releases = kReleases,
                                     .earlier = kEarlier,
                                     .see = see};

}  // namespace smurf::readers::mujoco_file
