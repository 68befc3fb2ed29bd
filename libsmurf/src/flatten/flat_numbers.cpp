// SPDX-License-Identifier: BSD-3-Clause
// Checks the numbers of a flat scene. No earlier stage reads the keys of primitives and old
// scenes.
#include "base/findings/rules.hpp"
#include "base/numbers/quantity.hpp"
#include "base/text/quoted.hpp"
#include "flatten/scene_shapes.hpp"
#include "smurf/flatten.hpp"

namespace smurf {
namespace {

bool are_quantities(std::initializer_list<double> values) {
  return std::all_of(values.begin(), values.end(), is_quantity);
}

struct HasUsableSize {
  bool operator()(const FlatPlane& plane) const {
    return are_quantities({plane.length, plane.width});
  }
  bool operator()(const FlatBox& box) const {
    return are_quantities({box.size[0], box.size[1], box.size[2]});
  }
  bool operator()(const FlatSphere& sphere) const { return is_quantity(sphere.radius); }
  bool operator()(const FlatCylinder& cylinder) const {
    return are_quantities({cylinder.radius, cylinder.length});
  }
  bool operator()(const FlatCapsule& capsule) const {
    return are_quantities({capsule.radius, capsule.length});
  }
  bool operator()(const FlatMesh& mesh) const {
    return are_quantities({mesh.scale[0], mesh.scale[1], mesh.scale[2]});
  }
  bool operator()(const FlatHeightmap& map) const {
    return are_quantities({map.length, map.width, map.height});
  }
};

bool is_usable(const FlatInstance& instance) {
  if (instance.model) return true;
  const auto mass = number_of(find(instance.properties, "mass"));
  if (mass && !is_quantity(*mass)) return false;
  return std::all_of(instance.shapes.begin(), instance.shapes.end(), [](const FlatShape& shape) {
    return is_usable(shape.X_ES) && std::visit(HasUsableSize(), shape.geometry);
  });
}

bool is_usable(const Field<Vector3>& vector) {
  return !vector || are_quantities({(*vector)[0], (*vector)[1], (*vector)[2]});
}

bool is_usable(const Light& light) { return is_usable(light.position) && is_usable(light.look_at); }

}  // namespace

bool check_flat_numbers(const FlatScene& flat, const LinkedScene& scene, DiagnosticSink& sink) {
  bool is_sound = true;
  const auto report = [&](std::size_t index) {
    is_sound = false;
    sink.report(rules::sml4003_out_of_range, place_of(*flat.instances[index].entity),
                "a size, a place or the mass of " + quoted(flat.instances[index].path) +
                    " is too large for computations");
  };
  for (std::size_t i = 0; i < flat.instances.size(); ++i) {
    if (!is_usable(flat.instances[i])) report(i);
  }
  for (const FlatOldScene& old : flat.old_scenes) {
    const bool is_lit = std::all_of(old.lamps.begin(), old.lamps.end(),
                                    [](const Light& lamp) { return is_usable(lamp); });
    if (!is_lit) report(old.instance);
  }
  for (const SceneFile& file : scene.scenes) {
    const std::optional<Physics>& physics = file.scene.physics;
    if (physics && !is_usable(physics->gravity)) {
      is_sound = false;
      sink.report(rules::sml4003_out_of_range, physics->gravity.span,
                  "gravity is too strong for computations");
    }
    for (const Light& light : file.scene.lights) {
      if (is_usable(light)) continue;
      is_sound = false;
      sink.report(rules::sml4003_out_of_range, light.position ? light.position.span : light.span,
                  "the light is so far away that its direction cannot be computed");
    }
  }
  return is_sound;
}

}  // namespace smurf
