// SPDX-License-Identifier: BSD-3-Clause
// A scene as it was read: its files with their entities, the instances in the world, the models.
#include <array>
#include <cmath>
#include <vector>

#include "ast/scene_keys.hpp"
#include "ast/sections.hpp"
#include "smurf/write.hpp"
#include "write/json/model_json.hpp"
#include "write/json/yaml_json.hpp"

namespace smurf {
namespace {

using Layout = JsonPrinter::Layout;

bool is_finite(const Pose& pose) {
  const auto& [x, y, z] = pose.position;
  const Quaternion& q = pose.orientation;
  return std::isfinite(x + y + z) && std::isfinite(q.w + q.x + q.y + q.z);
}

std::vector<const KeySpec*> pointers_to(std::span<const KeySpec> keys) {
  std::vector<const KeySpec*> pointers;
  for (const KeySpec& key : keys) pointers.push_back(&key);
  return pointers;
}

class ScenePrinter {
 public:
  ScenePrinter(JsonPrinter& json, const LinkedScene& scene, const SourceMap& sources)
      : json_(json), scene_(scene), sources_(sources) {}

  void print() {
    json_.begin_object(Layout::block);
    json_.member("path", scene_.path);
    json_.key("is_complete");
    json_.boolean(scene_.is_complete);
    list("files", scene_.scenes, [&](const SceneFile& one) { file(one); });
    list("instances", scene_.instances, [&](const Instance& one) { instance(one); });
    list("models", scene_.models,
         [&](const LinkedModel& one) { print_model(json_, one, sources_); });
    json_.end();
  }

 private:
  template <class Items, class Print>
  void list(std::string_view key, const Items& items, const Print& print) {
    json_.key(key);
    json_.begin_list(Layout::block);
    for (const auto& item : items) {
      if (json_.is_full()) break;
      print(item);
    }
    json_.end();
  }

  void source(Span span) {
    json_.key("source");
    json_.place(span, sources_);
  }

  void values(const SceneFile& file, yaml::NodeId node, std::span<const KeySpec* const> keys) {
    if (!file.document || node == yaml::kNoNode) return;
    json_.key("values");
    print_typed(json_, {*file.document, node}, keys);
  }

  void file(const SceneFile& file) {
    json_.begin_object(Layout::block);
    json_.member("path", file.path);
    list("entities", file.scene.entities, [&](const Entity& one) { entity(file, one); });
    if (file.scene.physics) {
      json_.key("physics");
      json_.begin_object();
      source(file.scene.physics->span);
      values(file, file.scene.physics->node, physics_keys_);
      json_.end();
    }
    if (file.document && file.scene.environment != yaml::kNoNode) {
      const yaml::View environment(*file.document, file.scene.environment);
      json_.key("environment");
      json_.begin_object();
      source(environment.span());
      values(file, file.scene.environment, environment_keys_);
      json_.end();
    }
    list("lights", file.scene.lights, [&](const Light& light) {
      json_.begin_object();
      source(light.span);
      values(file, light.node, light_keys_);
      json_.end();
    });
    list("custom", file.scene.extra, [&](const CustomSection& extra) {
      json_.begin_object();
      json_.member("name", extra.name.value);
      source(extra.name.span);
      json_.key("value");
      if (file.document) {
        print_untyped(json_, {*file.document, extra.node});
      } else {
        json_.null();
      }
      json_.end();
    });
    json_.end();
  }

  void entity(const SceneFile& file, const Entity& entity) {
    static constexpr std::array<std::string_view, 3> kLists = {"smurfs", "entities", "smurfa"};
    json_.begin_object();
    json_.member("list", kLists[static_cast<std::size_t>(entity.list)]);
    source(entity.span);
    values(file, entity.node, entity_keys_);
    json_.end();
  }

  void attachment(std::string_view key, const Attachment& attachment, std::string_view none) {
    json_.key(key);
    if (attachment.kind != Attachment::Kind::link) {
      return json_.text(attachment.kind == Attachment::Kind::world ? "world" : none);
    }
    json_.begin_object();
    json_.member("instance", scene_.instance(attachment.instance).path);
    json_.member("link", attachment.link);
    json_.end();
  }

  void instance(const Instance& instance) {
    json_.begin_object();
    json_.member("name", instance.name);
    json_.member("path", instance.path);
    json_.member("type", instance.type);
    if (!instance.file.empty()) {
      json_.member("file", instance.file);
    }
    if (instance.model) {
      json_.key("model");
      json_.integer(static_cast<std::int64_t>(to_size(*instance.model)));
    }
    source(scene_.entity(instance).span);
    if (instance.X_WE && is_finite(*instance.X_WE)) {
      json_.key("X_WE");
      json_.pose(*instance.X_WE);
    }
    attachment("anchor", instance.placement.anchor, "none");
    attachment("parent", instance.placement.parent, "world");
    json_.key("joint_positions");
    json_.begin_object();
    for (const auto& [joint, position] : scene_.joint_positions(instance)) {
      json_.key(joint);
      json_.number(position);
    }
    json_.end();
    json_.end();
  }

  JsonPrinter& json_;
  const LinkedScene& scene_;
  const SourceMap& sources_;
  const std::vector<const KeySpec*> entity_keys_ = pointers_to(all_entity_keys());
  const std::vector<const KeySpec*> physics_keys_ = pointers_to(all_physics_keys());
  const std::vector<const KeySpec*> environment_keys_ = pointers_to(environment_keys());
  const std::vector<const KeySpec*> light_keys_ = sections::lights.keys();
};

}  // namespace

std::optional<std::string> write_scene_json(const LinkedScene& scene, const SourceMap& sources,
                                            std::uint64_t most) {
  JsonPrinter json(most);
  json.begin_object(Layout::block);
  json.member("schema_version", "1.0");
  json.key("scene");
  ScenePrinter(json, scene, sources).print();
  json.end();
  return json.take();
}

}  // namespace smurf
