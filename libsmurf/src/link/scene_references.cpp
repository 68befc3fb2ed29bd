// SPDX-License-Identifier: BSD-3-Clause
// Resolves the names of parents and anchors to frames. Another step composes the frames.
#include <unordered_map>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/edits.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "link/scene_link.hpp"

namespace smurf {
namespace {

/// The kind of thing that has the name instead of a link, and the index of its link.
std::optional<std::pair<std::string_view, std::uint32_t>> other_kind(const LinkedModel& model,
                                                                     std::string_view name) {
  if (const auto link = model.collision_names.find(name)) return std::pair("collision", *link);
  if (const auto link = model.visual_names.find(name)) return std::pair("visual", *link);
  return std::nullopt;
}

/// A key that names a frame, and the rule that reports its faults.
struct SceneReference {
  const Field<std::string>& field;
  std::string_view key;
  const Rule& unknown;
  std::optional<InstanceIndex> self;
};

class ReferenceResolver {
 public:
  ReferenceResolver(LoadContext& context, SceneNames& names, LinkedScene& scene)
      : sink_(context.sink), sources_(context.sources), names_(names), scene_(scene) {}

  void run() {
    // Outer uses come first, so inherited values are known before the entities.
    for (SceneUse& use : scene_.uses) {
      if (const Entity* including = scene_.entity(use)) {
        use.placement = place(*including, *use.outer, std::nullopt);
      }
    }
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
      Instance& instance = scene_.instances[i];
      const InstanceIndex index{static_cast<std::uint32_t>(i)};
      instance.placement = place(scene_.entity(instance), instance.use, index);
      const bool is_silent = !scene_.entity(instance).anchor.written &&
                             instance.placement.anchor.kind == Attachment::Kind::none;
      if (is_silent && instance.model) instance.placement.anchor = root_anchor(*instance.model);
    }
  }

 private:
  Placement place(const Entity& entity, UseIndex use, std::optional<InstanceIndex> self) {
    const Placement& around = scene_.uses[to_size(use)].placement;
    const Pose own{entity.position.value_or({0, 0, 0}), to_quaternion(entity.rotation)};
    Placement placement;
    placement.is_known = (entity.position || !entity.position.written) &&
                         entity.rotation.form != RotationForm::invalid &&
                         (entity.parent || !entity.parent.written);
    const SceneReference parent{entity.parent, "parent", rules::sml5101_unknown_parent, self};
    if (names_no_frame(parent)) {
      placement.parent = around.parent;
      placement.X_PE = is_loaded_scene(use) ? own : around.X_PE * own;
      placement.is_known = placement.is_known && around.is_known;
      placement.anchor = anchor(entity, use, self, placement, true);
    } else {
      const std::optional<Attachment> link = frame(parent, use);
      if (link) placement.parent = *link;
      placement.is_known = placement.is_known && link;
      placement.X_PE = own;
      placement.anchor = anchor(entity, use, self, placement, false);
    }
    return placement;
  }

  Attachment root_anchor(ModelIndex model) {
    const auto [known, is_new] = root_anchors_.try_emplace(to_size(model));
    if (is_new) known->second = anchor_of_root(scene_.models[to_size(model)]);
    return known->second;
  }

  bool is_loaded_scene(UseIndex use) const { return !scene_.uses[to_size(use)].outer; }

  /// Absent, empty, `none` and `world`. Phobos 2 writes WORLD.
  bool names_no_frame(const SceneReference& parent) {
    if (!parent.field || parent.field->empty()) return true;
    const std::string lower = path::to_lower(*parent.field);
    if (lower != "world" && lower != "none") return false;
    report_case(parent, lower);
    return true;
  }

  void report_case(const SceneReference& reference, const std::string& lower) {
    if (*reference.field == lower) return;
    Diagnostic& diagnostic = sink_.report(
        rules::sml5106_world_case, reference.field.span,
        quoted(reference.key) + " is " + quoted(*reference.field) + ", which these tools read as " +
            quoted(lower) + "; MARS looks for an entity of that name");
    diagnostic.help("write " + quoted(lower));
    diagnostic.fixes.push_back({Applicability::unsafe, {edit(reference, lower)}});
  }

  Attachment anchor(const Entity& entity, UseIndex use, std::optional<InstanceIndex> self,
                    const Placement& placement, bool inherits) {
    const SceneReference reference{entity.anchor, "anchor", rules::sml5102_unknown_anchor, self};
    if (entity.anchor.written && !entity.anchor) return {};
    if (!entity.anchor || entity.anchor->empty()) {
      // In a list `smurfa`, only the root gets the anchor of the assembly.
      const bool is_member = entity.list == EntityList::smurfa && !entity.root.value_or(false);
      return inherits && !is_member ? scene_.uses[to_size(use)].placement.anchor : Attachment{};
    }
    const std::string& text = *entity.anchor;
    if (text == "none") return {};
    if (path::to_lower(text) == "world") {
      report_case(reference, "world");
      return {Attachment::Kind::world, {}, {}};
    }
    if (text == "parent") {
      if (placement.parent.kind == Attachment::Kind::link) return placement.parent;
      // Without a parent the entity is relative to the world, and MARS fixes it there.
      return placement.is_known ? Attachment{Attachment::Kind::world, {}, {}} : Attachment{};
    }
    return frame(reference, use).value_or(Attachment{});
  }

  /// `ENTITY::LINK`. None if it cannot be resolved; the reason is reported once.
  std::optional<Attachment> frame(const SceneReference& reference, UseIndex use) {
    const std::string& text = *reference.field;
    const std::size_t separator = text.find("::");
    if (separator == std::string::npos) {
      report_word(reference, use);
      return std::nullopt;
    }
    const std::string_view name = std::string_view(text).substr(0, separator);
    const std::string_view link = std::string_view(text).substr(separator + 2);
    const std::optional<EntityIndex> found = names_.find(use, name, scene_);
    if (!found) {
      report_entity(reference, name);
      return std::nullopt;
    }
    if (const UseIndex* include = std::get_if<UseIndex>(&*found)) {
      report_include(reference, *include, name);
      return std::nullopt;
    }
    return frame_of(reference, std::get<InstanceIndex>(*found), name, link);
  }

  std::optional<Attachment> frame_of(const SceneReference& reference, InstanceIndex index,
                                     std::string_view name, std::string_view link) {
    const Instance& instance = scene_.instance(index);
    const Attachment attachment{Attachment::Kind::link, index, std::string(link)};
    if (kind_of(instance.type) == EntityKind::other) {
      // The files of other types are not read, which does not matter for an anchor.
      if (reference.key == "anchor") return attachment;
      if (is_type_reported(instance.type)) return std::nullopt;
      Diagnostic& diagnostic =
          sink_.report(reference.unknown, reference.field.span,
                       "the parent " + quoted(name) + " is of type " + quoted(instance.type) +
                           ", whose frames are not known");
      label(diagnostic, instance, "only models have links");
      return std::nullopt;
    }
    const LinkedModel* model = scene_.model(instance);
    if (model == nullptr || !model->robot) return std::nullopt;
    if (!model->link_names.contains(link)) {
      report_link(reference, *model, instance, link);
      return std::nullopt;
    }
    if (reference.self == index && reference.key == "anchor") {
      sink_.report(rules::sml5107_anchor_to_itself, reference.field.span,
                   quoted(name) + " is anchored to itself");
      return std::nullopt;
    }
    return attachment;
  }

  /// Whether another finding already reports that the type should be that of a model.
  static bool is_type_reported(std::string_view type) {
    constexpr std::string_view kModels[] = {"smurf", "urdf"};
    return type.empty() || nearest(type, kModels).has_value();
  }

  void label(Diagnostic& diagnostic, const Instance& instance, std::string text) {
    const Span place = place_of(scene_.entity(instance));
    if (!place.empty()) diagnostic.label(place, std::move(text));
  }

  /// A word that is neither a frame nor reserved: an entity's name, or a
  /// misspelling.
  void report_word(const SceneReference& reference, UseIndex use) {
    const std::string& text = *reference.field;
    Diagnostic& diagnostic =
        sink_.report(reference.unknown, reference.field.span,
                     quoted(reference.key) + " is " + quoted(text) + ", which names no link");
    diagnostic.help("write `ENTITY::LINK`");
    const std::optional<EntityIndex> found = names_.find(use, text, scene_);
    if (found) {
      if (const auto root = root_link(*found)) {
        suggest(diagnostic, reference, text + "::" + *root, "write ", "");
        return;
      }
    }
    static constexpr std::string_view kParents[] = {"world", "none"};
    static constexpr std::string_view kAnchors[] = {"none", "world", "parent"};
    const auto near = reference.key == "parent" ? nearest(text, kParents) : nearest(text, kAnchors);
    const std::string lower = path::to_lower(text);
    if (near) {
      suggest(diagnostic, reference, std::string(*near), "did you mean ", "?");
    } else if (const auto meant = root_of_similar(reference, use)) {
      suggest(diagnostic, reference, *meant, "did you mean ", "?");
    } else if (reference.key == "anchor" && (lower == "false" || lower == "no")) {
      diagnostic.help("write `none`; MARS fixes the entity to the world");
    }
  }

  /// The name of the root link of an entity that is a model.
  std::optional<std::string> root_link(const EntityIndex& entity) const {
    const InstanceIndex* index = std::get_if<InstanceIndex>(&entity);
    const LinkedModel* model = index ? scene_.model(scene_.instance(*index)) : nullptr;
    if (model == nullptr || model->tree.roots.empty()) return std::nullopt;
    const Field<std::string>& name = model->link(model->tree.roots.front()).name;
    return name ? std::optional(*name) : std::nullopt;
  }

  /// "table::top" for "tabel", which resembles the name of an entity.
  std::optional<std::string> root_of_similar(const SceneReference& reference, UseIndex use) {
    const auto name = similar(reference, *reference.field);
    const auto entity = name ? names_.find(use, std::string(*name), scene_) : std::nullopt;
    const auto root = entity ? root_link(*entity) : std::nullopt;
    return root ? std::optional(std::string(*name) + "::" + *root) : std::nullopt;
  }

  /// The name that is meant, which is not that of the entity itself.
  std::optional<std::string_view> similar(const SceneReference& reference, std::string_view name) {
    const std::string_view own =
        reference.self ? std::string_view(scene_.instance(*reference.self).name) : "";
    const auto others = without_own(name, own, names_.names());
    return sink_.suggest(name, others ? std::span(*others) : std::span(names_.names()));
  }

  void suggest(Diagnostic& diagnostic, const SceneReference& reference, const std::string& text,
               std::string_view before, std::string_view after) {
    diagnostic.help(std::string(before) + quoted(text) + std::string(after));
    diagnostic.fixes.push_back({Applicability::unsafe, {edit(reference, text)}});
  }

  Edit edit(const SceneReference& reference, const std::string& text) {
    const Span span = reference.field.span;
    return {span, yaml_like(sources_.text(span), text)};
  }

  void report_entity(const SceneReference& reference, std::string_view name) {
    if (!names_.is_complete()) return;
    Diagnostic& diagnostic = sink_.report(reference.unknown, reference.field.span,
                                          quoted(reference.key) + " names the entity " +
                                              quoted(name) + ", which the scene does not have");
    if (const auto near = similar(reference, name)) {
      const std::string rest = reference.field->substr(name.size());
      suggest(diagnostic, reference, std::string(*near) + rest, "did you mean ", "?");
    }
  }

  void report_include(const SceneReference& reference, UseIndex include, std::string_view name) {
    const SceneUse& use = scene_.uses[to_size(include)];
    if (!scene_.file(use).document) return;  // a broken include is already reported
    Diagnostic& diagnostic = sink_.report(rules::sml5103_parent_of_scene, reference.field.span,
                                          quoted(reference.key) + " names " + quoted(name) +
                                              ", which is an included scene and has no links");
    if (const Entity* entity = scene_.entity(use)) {
      diagnostic.label(place_of(*entity), "the scene is included here");
    }
    std::string inside;
    for (const Entity& entity : scene_.file(use).scene.entities) {
      if (!entity.name || entity.name->empty() || inside.size() > 60) continue;
      inside += (inside.empty() ? " " : ", ") + quoted(*entity.name);
    }
    if (!inside.empty()) diagnostic.help("name an entity inside it:" + inside);
  }

  void report_link(const SceneReference& reference, const LinkedModel& model,
                   const Instance& instance, std::string_view link) {
    Diagnostic& diagnostic =
        sink_.report(reference.unknown, reference.field.span,
                     quoted(reference.key) + " names the link " + quoted(link) +
                         ", which the model of " + quoted(instance.name) + " does not have");
    const std::string prefix = reference.field->substr(0, reference.field->size() - link.size());
    if (const auto other = other_kind(model, link)) {
      diagnostic.message = quoted(reference.key) + " needs a link of " + quoted(instance.name) +
                           ", but " + quoted(link) + " is a " + std::string(other->first);
      const Field<std::string>& owner = model.robot->links[other->second].name;
      if (owner) suggest(diagnostic, reference, prefix + *owner, "name its link: ", "");
    } else if (const auto near = sink_.suggest(link, model.link_names.names())) {
      suggest(diagnostic, reference, prefix + std::string(*near), "did you mean ", "?");
    }
    if (!model.urdf_path.empty()) diagnostic.caret = "no such link in " + quoted(model.urdf_path);
    label(diagnostic, instance, quoted(instance.name) + " is defined here");
  }

  DiagnosticSink& sink_;
  const SourceMap& sources_;
  SceneNames& names_;
  LinkedScene& scene_;
  std::unordered_map<std::size_t, Attachment> root_anchors_;  ///< by model
};

}  // namespace

Attachment anchor_of_root(const LinkedModel& model) {
  if (!model.robot || model.tree.roots.empty()) return {};
  const Field<std::string>& root = model.link(model.tree.roots.front()).name;
  for (const LinkAnnotation& annotation : model.annotations.links) {
    const Field<std::string>& link = annotation.name ? annotation.name : annotation.link;
    const yaml::Document* document = model.document(annotation.span.source);
    if (!root || !link || *link != *root || document == nullptr) continue;
    const yaml::View anchor = yaml::View(*document, annotation.node).find("anchor");
    if (anchor && anchor.is_scalar() && path::to_lower(anchor.text()) == "world") {
      return {Attachment::Kind::world, {}, {}};
    }
  }
  return {};
}

void resolve_references(LoadContext& context, SceneNames& names, LinkedScene& scene) {
  ReferenceResolver(context, names, scene).run();
}

}  // namespace smurf
