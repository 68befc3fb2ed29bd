// SPDX-License-Identifier: BSD-3-Clause
// The flat scene as a scene again: no nested scenes, no parents, world poses. Entities are called
// by their paths, so that no two share a name.
#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "smurf/write_scene.hpp"
#include "write/text/json_text.hpp"

namespace smurf::scene_smurfs_file {
namespace {

class FlatSceneWriter {
 public:
  explicit FlatSceneWriter(const FlatScene& flat) : flat_(flat) {}

  std::string run() {
    add_physics();
    if (!flat_.environment.empty()) {
      out_ += "environment: ";
      append_json(out_, flat_.environment);
      out_ += '\n';
    }
    if (!flat_.lights.empty()) out_ += "lights:\n";
    for (const Value& light : flat_.lights) {
      out_ += "- ";
      append_json(out_, light);
      out_ += '\n';
    }
    out_ += flat_.instances.empty() ? "entities: []\n" : "entities:\n";
    for (const FlatInstance& instance : flat_.instances) {
      if (instance.X_WE) add_entity(instance);
    }
    return std::move(out_);
  }

 private:
  void add_numbers(std::string_view names, std::initializer_list<double> values, bool as_mapping) {
    out_ += as_mapping ? '{' : '[';
    std::size_t i = 0;
    for (const double value : values) {
      if (i > 0) out_ += ", ";
      if (as_mapping) out_ += std::string(1, names[i]) + ": ";
      out_ += format_number(value);
      ++i;
    }
    out_ += as_mapping ? '}' : ']';
  }

  void add_physics() {
    const FlatPhysics& physics = flat_.physics;
    const bool has_ode = physics.step_size || physics.cfm || physics.erp;
    if (!physics.gravity && !has_ode) return;
    out_ += "physics:\n";
    if (physics.gravity) {
      const Vector3& g = *physics.gravity;
      out_ += "  gravity: ";
      add_numbers("xyz", {g[0], g[1], g[2]}, true);
      out_ += '\n';
    }
    if (has_ode) out_ += "  ode:\n";
    if (physics.step_size) {
      out_ += "    stepsize: " + format_number(*physics.step_size * 1000) + "\n";
    }
    if (physics.cfm) out_ += "    cfm: " + format_number(*physics.cfm) + "\n";
    if (physics.erp) out_ += "    erp: " + format_number(*physics.erp) + "\n";
  }

  void add_entity(const FlatInstance& instance) {
    out_ += "- name: ";
    append_json(out_, instance.path);
    add_key("type");
    append_json(out_, instance.type);
    const std::string& file = instance.model ? flat_.models[*instance.model].file : instance.file;
    if (!file.empty()) {
      add_key("file");
      append_json(out_, file);
    }
    // MARS reads the pose of a primitive from mappings, and that of others from lists.
    const bool is_primitive = path::to_lower(instance.type) == "primitive";
    const auto& [x, y, z] = instance.X_WE->position;
    const Quaternion& q = instance.X_WE->orientation;
    add_key("position");
    add_numbers("xyz", {x, y, z}, is_primitive);
    add_key("rotation");
    add_numbers("wxyz", {q.w, q.x, q.y, q.z}, is_primitive);
    add_anchor(instance.anchor);
    add_joints(instance);
    for (const ValueMember& member : instance.properties) {
      out_ += "\n  ";
      append_json(out_, member.key);
      out_ += ": ";
      append_json(out_, member.value);
    }
    out_ += '\n';
  }

  void add_key(std::string_view name) { out_ += "\n  " + std::string(name) + ": "; }

  void add_anchor(const FlatAttachment& anchor) {
    if (anchor.kind == Attachment::Kind::none) return;
    add_key("anchor");
    if (anchor.kind == Attachment::Kind::world) {
      out_ += "world";
    } else {
      append_json(out_, anchor.instance + "::" + anchor.link);
    }
  }

  void add_joints(const FlatInstance& instance) {
    if (instance.joint_positions.empty()) return;
    add_key("poses");
    out_ += "[{name: start, joints: {";
    bool is_first = true;
    for (const auto& [joint, position] : instance.joint_positions) {
      append_key(out_, joint, is_first);
      out_ += format_number(position);
      is_first = false;
    }
    out_ += "}}]";
    add_key("pose");
    out_ += "start";
  }

  const FlatScene& flat_;
  std::string out_;
};

}  // namespace

extern constinit const SceneFormat scene_smurfs{
    .name = "smurfs",
    .help = "a SMURF scene without nested scenes",
    .write = [](const SceneExport& scene) { return FlatSceneWriter(scene.flat).run(); },
    .has_reference_form = true,
    .has_expanded_form = false};

}  // namespace smurf::scene_smurfs_file
