// SPDX-License-Identifier: BSD-3-Clause
#include "write/usd/usd_layout.hpp"

#include "base/text/unique_names.hpp"
#include "write/parts/scene_parts.hpp"

namespace smurf {
namespace {

bool is_frame(const LinkedModel& model, std::size_t link) {
  const urdf::Joint& joint = model.joint(*model.tree.parent_joint[link]);
  return joint.type == urdf::JointType::fixed && !inertial_of(model.robot->links[link]);
}

/// Frames move with the body of the link to which they are fixed.
void find_bodies(const LinkedModel& model, UsdLayout& layout) {
  std::vector<std::size_t> open{to_size(model.tree.roots.front())};
  layout.links[open.front()] = UsdLink{open.front(), {}, {}};
  while (!open.empty()) {
    const std::size_t parent = open.back();
    open.pop_back();
    for (const JointIndex joint : model.tree.child_joints[parent]) {
      const std::size_t child = to_size(*model.tree.joint_child[to_size(joint)]);
      if (layout.links[child]) continue;
      if (is_frame(model, child)) {
        const UsdLink& on = *layout.links[parent];
        const Pose X_PC = urdf::to_pose(model.joint(joint).origin);
        layout.links[child] = UsdLink{on.body, on.X_BL * X_PC, {}};
      } else {
        layout.links[child] = UsdLink{child, {}, {}};
      }
      open.push_back(child);
    }
  }
}

/// The names of the shapes of a body. Its frames are siblings and need other names.
UniqueNames names_of_shapes(const urdf::Link& link) {
  UniqueNames names;
  const std::size_t shapes = std::max(link.visuals.size(), link.collisions.size());
  for (std::size_t i = 1; i <= shapes; ++i) {
    names.take("shape_" + std::to_string(i));
    names.take("collision_" + std::to_string(i));
  }
  return names;
}

}  // namespace

UsdLayout usd_layout(const LinkedModel& model) {
  const std::size_t count = model.robot->links.size();
  UsdLayout layout{std::vector<std::optional<UsdLink>>(count),
                   std::vector<std::vector<std::size_t>>(count),
                   {},
                   {}};
  find_bodies(model, layout);
  UniqueNames of_entity;
  const auto name_of = [&](std::size_t link) {
    return safe_name(model.robot->links[link].name.value_or({}));
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (!layout.links[i]) continue;
    if (layout.is_body(i)) {
      layout.links[i]->path = of_entity.add(name_of(i));
    } else {
      layout.frames[layout.links[i]->body].push_back(i);
    }
  }
  for (std::size_t body = 0; body < count; ++body) {
    if (layout.frames[body].empty()) continue;
    UniqueNames of_body = names_of_shapes(model.robot->links[body]);
    for (const std::size_t frame : layout.frames[body]) {
      layout.links[frame]->path = layout.links[body]->path + "/" + of_body.add(name_of(frame));
    }
  }
  layout.joints = of_entity.add("joints");
  layout.materials = of_entity.add("materials");
  return layout;
}

}  // namespace smurf
