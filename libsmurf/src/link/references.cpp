// SPDX-License-Identifier: BSD-3-Clause
// The table of all references to names, of models and of scenes.
#include "smurf/references.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "ast/scene_keys.hpp"
#include "link/reference_finder.hpp"

namespace smurf {
namespace {

constexpr std::string_view kSeparator = "::";

/// References in the files of a scene, but not in its models.
class SceneFinder {
 public:
  explicit SceneFinder(const LinkedScene& scene) : scene_(scene) {
    std::uint32_t first = 0;
    for (const SceneFile& file : scene.scenes) {
      first_entities_.push_back(first);
      first += static_cast<std::uint32_t>(file.scene.entities.size());
    }
    instances_.resize(first);
    uses_.resize(first);
    for (const Instance& instance : scene.instances) {
      const Instance*& known = instances_[number_of(scene.use(instance).scene, instance.entity)];
      if (known == nullptr) known = &instance;
    }
    for (const SceneUse& use : scene.uses) {
      if (!use.outer) continue;
      const SceneUse*& known =
          uses_[number_of(scene.uses[to_size(*use.outer)].scene, use.including_entity)];
      if (known == nullptr) known = &use;
    }
  }

  std::vector<Reference> run() {
    for (std::size_t i = 0; i < scene_.scenes.size(); ++i) {
      const SceneFile& file = scene_.scenes[i];
      if (!file.document || file.drawing) continue;
      for (std::size_t e = 0; e < file.scene.entities.size(); ++e) {
        read_entity(*file.document, file.scene.entities[e], number_of(SceneIndex(i), e));
      }
    }
    for (const LinkedModel& model : scene_.models) {
      take(references_of(model), model_index(&model));
    }
    return std::move(found_);
  }

 private:
  std::uint32_t number_of(SceneIndex scene, std::size_t entity) const {
    return first_entities_[to_size(scene)] + static_cast<std::uint32_t>(entity);
  }

  ModelIndex model_index(const LinkedModel* model) const {
    return ModelIndex(static_cast<std::uint32_t>(model - scene_.models.data()));
  }

  void take(std::vector<Reference>&& references, ModelIndex model) {
    for (Reference& one : references) {
      one.model = model;
      found_.push_back(one);
    }
  }

  void read_entity(const yaml::Document& document, const Entity& entity, std::uint32_t number) {
    const Instance* instance = instances_[number];
    const LinkedModel* model = instance != nullptr ? scene_.model(*instance) : nullptr;
    const Placement* placement = instance != nullptr ? &instance->placement : nullptr;
    if (placement == nullptr && uses_[number] != nullptr) placement = &uses_[number]->placement;
    for (const yaml::View value : yaml::View(document, entity.node)) {
      const KeySpec* row = find_key({all_entity_keys()}, value.key());
      if (row == nullptr || value.is_repeated()) continue;
      if (row->names.kinds.contains(NameKind::entity) && value.is_scalar()) {
        if (row->names.defines) {
          add(NameKind::entity, value.text(), place_of_name(value), number).is_definition = true;
        } else if (placement != nullptr) {
          read_frame(value, row->name == "parent" ? placement->parent : placement->anchor);
        }
      } else if (model != nullptr) {
        read_of_model(*row, value, *model, entity);
      }
    }
  }

  Reference& add(NameKind kind, std::string_view name, const NamePlace& place, std::uint32_t item) {
    return found_.emplace_back(Reference{.kind = kind,
                                         .notation = place.notation,
                                         .kinds = kind,
                                         .place = place.place,
                                         .name = name,
                                         .span = place.span,
                                         .text = place.text,
                                         .item = item});
  }

  /// `ENTITY::LINK`; other texts are not names.
  void read_frame(yaml::View value, const Attachment& attachment) {
    const std::string_view text = value.text();
    const NamePlace place = place_of_name(value);
    const std::size_t separator = text.find(kSeparator);
    // Escaped characters would shift the parts.
    if (separator == std::string_view::npos || text.size() != place.span.end - place.span.begin) {
      return;
    }
    const std::string_view name = text.substr(0, separator);
    const std::string_view link = text.substr(separator + kSeparator.size());
    if (attachment.kind != Attachment::Kind::link) {
      add(NameKind::entity, name, part_of(place, 0, name.size()), Reference::kNothing);
      return;
    }
    const Instance& carrier = scene_.instance(attachment.instance);
    const std::uint32_t item = number_of(scene_.use(carrier).scene, carrier.entity);
    add(NameKind::entity, name, part_of(place, 0, name.size()), item);
    const LinkedModel* model = scene_.model(carrier);
    if (model == nullptr) return;
    const auto index = model->link_names.find(link);
    add(NameKind::link, link, part_of(place, separator + kSeparator.size(), link.size()),
        index.value_or(Reference::kNothing))
        .model = model_index(model);
  }

  /// Poses, links and joints of the entity's own model.
  void read_of_model(const KeySpec& row, yaml::View value, const LinkedModel& model,
                     const Entity& entity) {
    // Made once for each model, because it contains tables of names.
    ReferenceFinder& finder =
        finders_.try_emplace(&model, model, ReferenceFinder::Keep::all).first->second;
    if (row.name == "poses") {
      finder.read_section(sections::poses, value);
    } else if (!row.names.kinds.empty()) {
      // A pose set of the entity takes precedence over those of its model.
      const bool is_own =
          row.name == "pose" &&
          std::any_of(entity.poses.begin(), entity.poses.end(), [&](const JointPoseSet& one) {
            return one.name && *one.name == value.text();
          });
      if (!is_own) finder.read_key(row, value, value);
    }
    std::vector<Reference> found = finder.take();
    // Nothing else has a name of this kind.
    std::erase_if(found, [](const Reference& one) {
      return one.is_definition && one.kind == NameKind::pose;
    });
    take(std::move(found), model_index(&model));
  }

  const LinkedScene& scene_;
  std::vector<std::uint32_t> first_entities_;  ///< by scene file
  std::vector<const Instance*> instances_;     ///< by entity; its first instance
  std::vector<const SceneUse*> uses_;          ///< by including entity; its first use
  std::map<const LinkedModel*, ReferenceFinder> finders_;
  std::vector<Reference> found_;
};

}  // namespace

std::vector<Reference> references_of(const LinkedModel& model) {
  ReferenceFinder finder(model, ReferenceFinder::Keep::all);
  finder.read_annotations();
  finder.read_urdf();
  return finder.take();
}

std::vector<Reference> references_of(const LinkedScene& scene) { return SceneFinder(scene).run(); }

std::vector<Reference> doubtful_references(const LinkedModel& model) {
  ReferenceFinder finder(model, ReferenceFinder::Keep::doubtful);
  finder.read_annotations();
  finder.read_urdf();
  return finder.take();
}

}  // namespace smurf
