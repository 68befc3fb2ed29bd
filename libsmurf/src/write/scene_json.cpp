// SPDX-License-Identifier: BSD-3-Clause
// Flat JSON, one line per instance: large scenes stay readable and easy to compare.
#include <vector>

#include "base/numbers/numbers.hpp"
#include "smurf/write.hpp"
#include "smurf/write_scene.hpp"
#include "write/text/json_text.hpp"

namespace smurf::scene_json_file {
namespace {

/// The lights of scenes, then those of old scenes.
std::vector<const Value*> all_lights(const FlatScene& scene) {
  std::vector<const Value*> lights;
  for (const Value& light : scene.lights) lights.push_back(&light);
  for (const FlatOldScene& old : scene.old_scenes) {
    for (const Value& light : old.lights) lights.push_back(&light);
  }
  return lights;
}

class JsonWriter {
 public:
  explicit JsonWriter(bool links) : links_(links) {}

  std::string run(const FlatScene& scene) {
    out_.reserve(1024 + 400 * scene.instances.size());
    out_ += "{\n  \"schema_version\": \"1.0\",\n  \"scene\": ";
    text(scene.scene);
    out_ += ",\n  \"frame\": \"world\",\n  \"physics\": ";
    physics(scene.physics);
    out_ += ",\n  \"environment\": ";
    append_json(out_, scene.environment);
    out_ += ",\n  \"lights\": ";
    rows(all_lights(scene), [&](const Value* light) { append_json(out_, *light); });
    out_ += ",\n  \"models\": ";
    rows(scene.models, [&](const FlatModel& flat) { model(flat); });
    out_ += ",\n  \"instances\": ";
    std::vector<const FlatInstance*> placed;
    for (const FlatInstance& flat : scene.instances) {
      if (flat.X_WE) placed.push_back(&flat);
    }
    rows(placed, [&](const FlatInstance* flat) { instance(*flat, scene); });
    out_ += "\n}\n";
    return std::move(out_);
  }

 private:
  /// A list with one item per line.
  template <class Items, class Write>
  void rows(const Items& items, const Write& write) {
    out_ += '[';
    bool is_first = true;
    for (const auto& item : items) {
      out_ += is_first ? "\n    " : ",\n    ";
      is_first = false;
      write(item);
    }
    out_ += items.empty() ? "]" : "\n  ]";
  }

  void number(double value) { out_ += format_number(value); }

  void text(std::string_view value) { append_json(out_, value); }

  void key(std::string_view name, bool is_first = false) { append_key(out_, name, is_first); }

  void pose(const Pose& pose, bool is_first) {
    key("position", is_first);
    append_json(out_, pose.position);
    key("orientation");
    append_json(out_, pose.orientation);
  }

  void physics(const FlatPhysics& physics) {
    out_ += '{';
    bool is_first = true;
    if (physics.gravity) {
      key("gravity", is_first);
      append_json(out_, *physics.gravity);
      is_first = false;
    }
    for (const auto& [name, given] :
         {std::pair("step_size", physics.step_size), std::pair("cfm", physics.cfm),
          std::pair("erp", physics.erp)}) {
      if (!given) continue;
      key(name, is_first);
      number(*given);
      is_first = false;
    }
    out_ += '}';
  }

  void model(const FlatModel& model) {
    out_ += '{';
    key("id", true);
    text(model.id);
    key("type");
    text(model.type);
    key("file");
    text(model.file);
    if (!model.urdf.empty()) {
      key("urdf");
      text(model.urdf);
    }
    out_ += '}';
  }

  void attachment(const FlatAttachment& attachment, std::string_view none) {
    switch (attachment.kind) {
    case Attachment::Kind::none: return text(none);
    case Attachment::Kind::world: return text("world");
    case Attachment::Kind::link: break;
    }
    out_ += "{\"instance\": ";
    text(attachment.instance);
    key("link");
    text(attachment.link);
    out_ += '}';
  }

  void instance(const FlatInstance& instance, const FlatScene& scene) {
    out_ += '{';
    key("name", true);
    text(instance.name);
    key("path");
    text(instance.path);
    key("type");
    text(instance.type);
    if (instance.model) {
      key("model");
      text(scene.models[*instance.model].id);
    } else if (!instance.file.empty()) {
      key("file");
      text(instance.file);
    }
    out_ += ", \"source\": {\"file\": ";
    text(instance.source_file);
    out_ += ", \"line\": " + std::to_string(instance.source_line) + "}";
    pose(*instance.X_WE, false);
    key("anchor");
    attachment(instance.anchor, "none");
    key("parent");
    attachment(instance.parent, "world");
    key("joint_positions");
    out_ += '{';
    for (std::size_t i = 0; i < instance.joint_positions.size(); ++i) {
      key(instance.joint_positions[i].first, i == 0);
      number(instance.joint_positions[i].second);
    }
    out_ += '}';
    key("properties");
    append_json(out_, instance.properties);
    if (links_ && instance.model) links(instance);
    out_ += '}';
  }

  void links(const FlatInstance& instance) {
    key("links");
    out_ += '{';
    for (std::size_t i = 0; i < instance.links.size(); ++i) {
      key(instance.links[i].first, i == 0);
      out_ += '{';
      pose(instance.links[i].second, true);
      out_ += '}';
    }
    out_ += '}';
  }

  bool links_;
  std::string out_;
};

}  // namespace

extern constinit const SceneFormat scene_json{
    .name = "json",
    .help = "instances in the world frame, for programs",
    .write = [](const SceneExport& scene) { return JsonWriter(scene.links).run(scene.flat); },
    .has_reference_form = true,
    .has_expanded_form = false};

}  // namespace smurf::scene_json_file

namespace smurf {

std::string write_flat_json(const FlatScene& scene, bool links) {
  return scene_json_file::JsonWriter(links).run(scene);
}

}  // namespace smurf
