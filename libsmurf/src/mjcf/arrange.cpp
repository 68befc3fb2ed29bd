// SPDX-License-Identifier: BSD-3-Clause
// What the compiler of MuJoCo changes in the tree at its end.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "mjcf/model.hpp"
#include "mjcf/moved_inertia.hpp"

namespace smurf::mjcf {
namespace {

/// The names that elements outside of the tree refer to, whatever they name.
std::set<std::string> names_in_sections(const Model& model) {
  std::set<std::string> names;
  for (const Reference& one : model.sections) {
    for (const Attribute& attribute : one.element.attributes()) {
      if (attribute.name() != "name") names.insert(full_name(attribute.value(), one.around));
    }
  }
  for (const Camera& one : model.cameras) names.emplace(one.settings.text("target"));
  return names;
}

void place_in(Body& parent, Body& body) {
  for (Geom& geom : body.geoms) {
    geom.pose = body.pose * geom.pose;
    geom.mesh_pose = body.pose * geom.mesh_pose;
    if (geom.mass) geom.mass = geom.mass->in(body.pose);
    parent.geoms.push_back(std::move(geom));
  }
  if (!parent.mass || !body.mass) {
    parent.mass.reset();
  } else {
    parent.mass->add(body.mass->in(body.pose));
  }
}

void fuse(Model& model) {
  const std::set<std::string> named = names_in_sections(model);
  std::vector<bool> is_gone(model.bodies.size());
  // From the leaves, so that a parent takes what its children took.
  for (std::size_t i = model.bodies.size(); i-- > 1;) {
    Body& body = model.bodies[i];
    const bool is_fixed = body.joints.empty() && !body.is_mocap && body.file->compiler().fusestatic;
    if (!is_fixed || (body.has_name && named.contains(body.name))) continue;
    is_gone[i] = true;
    place_in(model.bodies[body.parent], body);
    for (Body& child : model.bodies) {
      if (child.parent != i || &child == &body) continue;
      child.parent = body.parent;
      child.pose = body.pose * child.pose;
    }
    for (Site& site : model.sites) {
      if (site.body != i) continue;
      site.body = body.parent;
      site.pose = body.pose * site.pose;
    }
    for (Camera& camera : model.cameras) {
      if (camera.body != i) continue;
      camera.body = body.parent;
      camera.pose = body.pose * camera.pose;
    }
  }
  model.bodies[0].mass = MassProperties{};
  std::vector<std::uint32_t> index(model.bodies.size());
  std::deque<Body> kept;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    index[i] = static_cast<std::uint32_t>(kept.size());
    if (!is_gone[i]) kept.push_back(std::move(model.bodies[i]));
  }
  for (Body& body : kept) body.parent = index[body.parent];
  for (Site& site : model.sites) site.body = index[site.body];
  for (Camera& camera : model.cameras) camera.body = index[camera.body];
  model.bodies = std::move(kept);
}

/// The frame of the centre of mass, as MuJoCo turns it.
Pose inertial_frame(const Body& body) {
  Pose frame{body.mass->center, imports::principal_of(body.mass->inertia).axes};
  if (!body.inertial && body.geoms.size() == 1)
    frame.orientation = body.geoms.front().pose.orientation;
  return frame;
}

void align(Body& body) {
  const Pose frame = inertial_frame(body);
  const Pose back = inverse(frame);
  body.pose = body.pose * frame;
  body.mass = body.mass->in(back);
  for (Geom& geom : body.geoms) {
    geom.pose = back * geom.pose;
    geom.mesh_pose = back * geom.mesh_pose;
  }
}

}  // namespace

std::string full_name(std::string_view name, const Surroundings& around) {
  return around.prefix + std::string(name) + around.suffix;
}

void arrange(Model& model) {
  const bool fuses = std::any_of(model.files.begin(), model.files.end(),
                                 [](const ModelFile& one) { return one.compiler().fusestatic; });
  if (fuses) fuse(model);
  for (std::uint32_t i = 1; i < model.bodies.size(); ++i) {
    Body& body = model.bodies[i];
    if (body.joints.size() != 1 || !body.joints.front().is_aligned || !body.mass ||
        body.mass->mass <= 0)
      continue;
    const bool is_leaf = std::none_of(model.bodies.begin(), model.bodies.end(),
                                      [&](const Body& one) { return one.parent == i; });
    if (!is_leaf) continue;
    for (Site& site : model.sites) {
      if (site.body == i) site.pose = inverse(inertial_frame(body)) * site.pose;
    }
    for (Camera& camera : model.cameras) {
      if (camera.body == i) camera.pose = inverse(inertial_frame(body)) * camera.pose;
    }
    align(body);
  }
}

bool needs_world(const Model& model) {
  if (!model.bodies.front().geoms.empty() || model.bodies.size() < 2) return true;
  const auto tops = std::count_if(model.bodies.begin() + 1, model.bodies.end(),
                                  [](const Body& one) { return one.parent == 0; });
  const Body& first = model.bodies[1];
  return tops != 1 || first.joints.size() != 1 || first.joints.front().type != Joint::Type::free;
}

bool touches(const Geom& geom) { return geom.contype != 0 || geom.conaffinity != 0; }

bool has_one_mask(const Geom& geom) {
  constexpr std::int64_t kMost = 0xffff;
  return geom.contype == geom.conaffinity && geom.contype <= kMost;
}

bool has_masks(const Model& model) {
  std::set<std::int64_t> masks;
  for (const Body& body : model.bodies) {
    for (const Geom& geom : body.geoms) {
      if (!touches(geom)) continue;
      if (!has_one_mask(geom)) return false;
      masks.insert(geom.contype);
    }
  }
  return masks.size() > 1;
}

void name_all(Model& model) {
  std::size_t joints = 0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    Body& body = model.bodies[i];
    if (!body.has_name) body.name = "body_" + std::to_string(i);
    std::size_t shapes = 0;
    for (Geom& geom : body.geoms) {
      if (touches(geom) && geom.name.empty())
        geom.name = body.name + "_collision_" + std::to_string(++shapes);
    }
    for (Joint& joint : body.joints) {
      if (!joint.has_name) joint.name = "joint_" + std::to_string(joints);
      ++joints;
    }
  }
}

void tune_springs(Model& model, Reporter& reporter) {
  std::optional<MovedInertia> inertias;
  for (std::size_t i = 1; i < model.bodies.size(); ++i) {
    for (Joint& joint : model.bodies[i].joints) {
      std::array<double, 2> wanted{};
      joint.settings.numbers("springdamper", wanted, 2, reporter);
      if (!(wanted[0] > 0) || !(wanted[1] > 0) || joint.type == Joint::Type::free) continue;
      if (!inertias) inertias.emplace(model);
      const double inertia = inertias->locked(joint, i).value_or(joint.armature);
      constexpr double kLeast = 1e-15;
      joint.stiffness = inertia / std::max(kLeast, wanted[0] * wanted[0] * wanted[1] * wanted[1]);
      joint.damping = 2 * inertia / std::max(kLeast, wanted[0]);
    }
  }
}

}  // namespace smurf::mjcf
