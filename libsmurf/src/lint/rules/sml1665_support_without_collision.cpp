// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "link/link_overlaps.hpp"
#include "lint/rigid_shapes.hpp"

namespace smurf::rules::sml1665_support_without_collision_file {
namespace {

/// Parts that a robot stands on.
constexpr std::string_view kSupports[] = {"caster", "castor", "wheel", "foot", "feet", "track"};

/// Whether a name has a word, as `rear_wheels` and `wheelLeft` have "wheel", and `tracker` has no
/// "track".
bool has_word(const std::string& name, const std::string& lower, std::string_view word) {
  for (std::size_t at = lower.find(word); at != std::string::npos; at = lower.find(word, at + 1)) {
    std::size_t end = at + word.size();
    if (end < name.size() && name[end] == 's') ++end;
    const bool goes_on = end < name.size() && name[end] >= 'a' && name[end] <= 'z';
    if (!goes_on) return true;
  }
  return false;
}

bool is_support(const urdf::Link& link) {
  const std::string name = link.name.value_or("");
  const std::string lower = path::to_lower(name);
  return ranges::any_of(kSupports,
                        [&](std::string_view word) { return has_word(name, lower, word); });
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || !ranges::any_of(model.robot->links, is_support)) return;
  const auto poses = forward_kinematics(model, {});
  const std::vector<std::size_t> body = bodies_of(model);
  const std::vector<RigidShape> shapes = rigid_shapes(model, poses, body);
  if (!ranges::any_of(shapes, [](const RigidShape& one) { return one.has_collision; })) return;
  std::vector<bool> has_child(model.robot->links.size());
  for (const auto& parent : model.tree.joint_parent) {
    if (parent) has_child[to_size(*parent)] = true;
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const urdf::Link& link = model.robot->links[i];
    if (!is_support(link) || link.visuals.empty() || !link.collisions.empty() || has_child[i]) {
      continue;
    }
    // A part that is fixed to another one that moves by itself may stand on it.
    const bool is_carried = body[i] != i && model.tree.parent_joint[body[i]];
    if (is_carried && shapes[body[i]].has_collision) continue;
    findings
        .report_habit(name_place(model, link), title(link) + " has a visual, but no collision",
                      "such links")
        .help("add a `collision`, or the part goes through the ground in simulators");
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::changes, "lets the part go through the ground",
     "it makes contacts of collisions only"},
};

}  // namespace

extern constinit const Rule sml1665_support_without_collision{
    .id = "SML1665",
    .name = "support-without-collision",
    .severity = Severity::warning,
    .summary = "A wheel, caster or foot has a visual and no collision.",
    .why = "The other links have collisions, so the robot is meant to touch things; this part goes "
           "through the ground.",
    .remedy = "Add a collision.",
    .sources = "ArloBot issue 155. By the name of the link.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1665_support_without_collision_file
