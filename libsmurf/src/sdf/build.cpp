// SPDX-License-Identifier: BSD-3-Clause
// From elements to scopes: models, nested and included models, links, joints and frames.
#include <algorithm>
#include <set>

#include "base/findings/rules.hpp"
#include "base/ranges.hpp"
#include "base/sdf_sensor_types.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "sdf/model.hpp"

namespace smurf::sdformat {
namespace {

constexpr int kDeepestModel = 250;

bool is_reserved(std::string_view name) {
  return name == "world" || (name.size() >= 4 && name.starts_with("__") && name.ends_with("__"));
}

/// What an `<include>` says about the model that it names.
struct Overrides {
  View element;  ///< of the include; empty without one
  std::string name;
  View pose;
  std::optional<bool> is_static;
  std::optional<std::string> placement_frame;
  bool is_merged = false;
};

class Builder {
 public:
  Builder(Files& files, Model& model) : files_(files), reporter_(files.reporter()), model_(model) {}

  bool run() {
    const SdfFile* file = files_.main();
    if (file == nullptr) return false;
    open_.insert(file->path);
    std::vector<View> models, worlds;
    for (const View one : file->root) {
      if (one.name() == "model" || one.name() == "include") models.push_back(one);
      if (one.name() == "world") worlds.push_back(one);
    }
    if (models.size() > 1) {
      reporter_.refuse(models[1].name_span(), "a file has one model, or one world with several",
                       "put the models into a `<world>`");
    }
    if (!models.empty() && models.front().name() == "include") {
      include(models.front(), *file, nullptr);
      return static_cast<bool>(model_.element);
    }
    if (!models.empty()) {
      model_.element = models.front();
      model_.name = attribute_of(models.front(), "name");
      add_model(models.front(), *file, nullptr, {});
      return true;
    }
    for (const View one : file->root) {
      if (!worlds.empty() || (one.name() != "light" && one.name() != "actor")) continue;
      // A file of one of these is sound, but holds no robot.
      Scope& scope = model_.scopes.emplace_back();
      scope.is_world = true;
      scope.element = file->root;
      scope.file = file;
      model_.element = one;
      model_.name = attribute_of(one, "name");
      return true;
    }
    if (worlds.empty()) {
      // libsdformat reads it; but nothing can be made of it.
      Diagnostic& found =
          reporter_.report(rules::sml9314_ignored_by_sdformat, file->root.name_span(),
                           "the file has neither a model nor a world");
      found.severity = Severity::error;
      found.help("name a file with a `<model>`");
      return false;
    }
    model_.element = worlds.front();
    model_.name = attribute_of(worlds.front(), "name");
    for (const View one : worlds) add_world(one, *file, worlds.size() > 1);
    return true;
  }

  /// A model of a world, in a frame of its own.
  void run(const Scope& part) {
    model_.is_entity = true;
    model_.element = part.element;
    model_.name = attribute_of(part.element, "name");
    Overrides overrides;
    const bool is_included = part.vertex->element.name_span() != part.element.name_span();
    if (is_included) overrides.element = part.vertex->element;
    overrides.is_static = part.is_static;
    overrides.placement_frame = "";  // the pose in the world includes it
    add_model(part.element, *part.file, nullptr, overrides);
  }

 private:
  /// A body needs ten times the memory of a part of a URDF.
  std::uint64_t most_parts() const { return reporter_.context().limits.urdf_parts / 10; }

  bool has_room(View element, const Scope* scope) {
    // Names repeat those of all models around them.
    bytes_ += scope != nullptr ? scope->prefix.size() : 0;
    if (bytes_ > reporter_.context().limits.xacro_bytes / 10) {
      if (!is_full_)
        reporter_.exceed(element.name_span(), "the names of nested models are too long",
                         "xacro-bytes");
      is_full_ = true;
    }
    if (++parts_ > most_parts()) {
      if (!is_full_)
        reporter_.exceed(element.name_span(),
                         "the model has more than " + std::to_string(most_parts()) + " parts",
                         "urdf-parts");
      is_full_ = true;
    }
    return !is_full_;
  }

  void add_world(View element, const SdfFile& file, bool is_one_of_many) {
    Scope& scope = model_.scopes.emplace_back();
    scope.is_world = true;
    scope.element = element;
    scope.file = &file;
    scope.name = attribute_of(element, "name");
    if (is_one_of_many) scope.prefix = scope.name + "::";
    add_content(element, scope);
  }

  /// The name that an element has among others of its scope; none if it cannot be there.
  std::optional<std::string> name_for(View element, const Scope& scope, std::string name,
                                      std::string_view suffix, Span place) {
    if (is_reserved(name)) {
      reporter_.refuse(place, quoted(name) + " is a name that SDF reserves", "choose another name");
      return std::nullopt;
    }
    const auto known = scope.names.find(name);
    if (known == scope.names.end()) return name;
    if (known->second->element.name() == element.name() || scope.file->version >= 7) {
      Diagnostic& found =
          reporter_.refuse(place, "there is a second " + quoted(name) + " in " + quoted(scope.name),
                           "give links, joints, frames and models different names");
      found.label(known->second->element.name_span(), "the first one");
      return std::nullopt;
    }
    // Until SDF 1.6, a joint could have the name of a link.
    std::string other = name + std::string(suffix);
    for (int i = 0; scope.names.contains(other); ++i)
      other = name + std::string(suffix) + std::to_string(i);
    return other;
  }

  static Span name_place(View element) {
    const Attribute* name = element.attribute("name");
    return name != nullptr ? name->value_span() : element.name_span();
  }

  Vertex* add_vertex(Vertex::Kind kind, View element, Scope& scope, std::string name, View pose) {
    Vertex& vertex = model_.vertices.emplace_back();
    vertex.kind = kind;
    vertex.name = name;
    vertex.element = element;
    vertex.scope = &scope;
    vertex.pose = pose;
    if (pose) {
      vertex.raw = pose_in(pose).value_or(Pose{});
      vertex.relative_to = attribute_of(pose, "relative_to");
      // libsdformat turns `frame` into `relative_to`, also an empty one.
      if (scope.file->version <= 6 && pose.attribute("frame") != nullptr)
        vertex.relative_to = attribute_of(pose, "frame");
    }
    scope.names.emplace(name, &vertex);
    scope.order.push_back(&vertex);
    // What is merged has a name in the model around it, too.
    for (Scope* at = &scope; at->is_merged && at->outer != nullptr; at = at->outer) {
      at->outer->names.emplace(name, &vertex);
      at->outer->order.push_back(&vertex);
    }
    return &vertex;
  }

  /// Adds what is in a model or a world. Names are taken in the order of libsdformat, which decides
  /// which one of two is renamed.
  void add_content(View element, Scope& scope) {
    for (const View one : element) {
      if (is_full_) return;
      if (one.name() == "model") add_model(one, *scope.file, &scope, {});
      if (one.name() == "include") include(one, *scope.file, &scope);
      if (one.name() == "light" && scope.is_world) {
        refuse_reserved(one);
        model_.lights.push_back({one, {}, &scope});
      }
    }
    for (const View one : element) {
      if (one.name() == "link" && !scope.is_world) add_link(one, scope);
    }
    for (const View one : element) {
      if (one.name() != "joint") continue;
      if (!scope.is_world || scope.file->version >= 10) {
        add_joint(one, scope);
      } else {
        reporter_
            .report(rules::sml9314_ignored_by_sdformat, one.name_span(),
                    "before SDF 1.10, a world has no joints, so this one is ignored")
            .help("write `version=\"1.10\"`, or put the joint into a model");
      }
    }
    for (const View one : element) {
      if (one.name() == "frame") add_frame(one, scope);
    }
  }

  void add_link(View element, Scope& scope) {
    if (!has_room(element, &scope)) return;
    const auto name = name_for(element, scope, std::string(attribute_of(element, "name")), "_link",
                               name_place(element));
    if (!name) return;
    Link& link = model_.links.emplace_back();
    link.vertex = add_vertex(Vertex::Kind::link, element, scope, *name, element.child("pose"));
    link.name = scope.prefix + *name;
    check_names_in(element);
    for (const Scope* at = &scope; at != nullptr; at = at->outer)
      link.is_static = link.is_static || at->is_static;
  }

  void refuse_reserved(View element) {
    const std::string_view name = attribute_of(element, "name");
    if (is_reserved(name))
      reporter_.refuse(name_place(element), quoted(name) + " is a name that SDF reserves",
                       "choose another name");
  }

  /// Visuals, collisions and sensors of a link or a joint have names of their own.
  void check_names_in(View element) {
    std::map<std::pair<std::string_view, std::string_view>, Span> names;
    for (const View one : element) {
      if (!is_one_of(one.name(), {"visual", "collision", "sensor"})) continue;
      if (!has_room(one, nullptr)) return;
      const auto [first, is_new] =
          names.emplace(std::pair{one.name(), attribute_of(one, "name")}, one.name_span());
      if (!is_new) {
        reporter_
            .refuse(name_place(one),
                    "there is a second " + quoted(one.name()) + " " +
                        quoted(attribute_of(one, "name")),
                    "choose another name")
            .label(first->second, "the first one");
      }
      refuse_reserved(one);
      if (one.name() == "sensor") check_sensor(one);
    }
  }

  void check_sensor(View sensor) {
    const Attribute* type = sensor.attribute("type");
    if (type == nullptr || type->value().empty()) return;  // reported with the attributes
    if (ranges::contains(kSdfSensorTypes, type->value())) return;
    const auto near = reporter_.context().sink.suggest(type->value(), kSdfSensorTypes);
    reporter_.refuse(type->value_span(), quoted(type->value()) + " is no type of a sensor",
                     near ? "did you mean " + quoted(*near) + "?"
                          : "write `camera`, `imu`, `lidar` or another known type");
  }

  void add_joint(View element, Scope& scope) {
    if (!has_room(element, &scope)) return;
    const auto name = name_for(element, scope, std::string(attribute_of(element, "name")), "_joint",
                               name_place(element));
    if (!name) return;
    Joint& joint = model_.joints.emplace_back();
    joint.vertex = add_vertex(Vertex::Kind::joint, element, scope, *name, element.child("pose"));
    joint.name = scope.prefix + *name;
    check_names_in(element);
    joint.parent_name = text_in(element, "parent");
    joint.child_name = text_in(element, "child");
    joint.vertex->attached_to = joint.child_name;
    joint.is_at_child = joint.vertex->relative_to.empty() && joint.vertex->raw == Pose{};
  }

  void add_frame(View element, Scope& scope) {
    if (!has_room(element, &scope)) return;
    const auto name = name_for(element, scope, std::string(attribute_of(element, "name")), "_frame",
                               name_place(element));
    if (!name) return;
    Vertex* vertex = add_vertex(Vertex::Kind::frame, element, scope, *name, element.child("pose"));
    vertex->attached_to = attribute_of(element, "attached_to");
  }

  void add_model(View element, const SdfFile& file, Scope* outer, const Overrides& overrides) {
    if (!has_room(element, outer)) return;
    if (outer != nullptr && outer->depth >= kDeepestModel) {
      reporter_.exceed(element.name_span(),
                       "models are nested in more than " + std::to_string(kDeepestModel) +
                           " levels",
                       "include-depth");
      is_full_ = true;
      return;
    }
    std::string name(overrides.name.empty() ? attribute_of(element, "name")
                                            : std::string_view(overrides.name));
    const View pose = overrides.pose ? overrides.pose : element.child("pose");
    Vertex* vertex = nullptr;
    const View place = overrides.element ? overrides.element : element;
    if (overrides.is_merged) name = "_merged__" + name + "__model__";
    if (outer == nullptr && !model_.is_entity) refuse_reserved(element);
    if (outer != nullptr) {
      const auto own = overrides.is_merged && !outer->names.contains(name)
                           ? std::optional(name)
                           : name_for(place, *outer, name, "_model",
                                      overrides.element ? place.name_span() : name_place(element));
      if (!own) return;
      name = *own;
      vertex = add_vertex(Vertex::Kind::model, place, *outer, name, pose);
    }
    Scope& scope = model_.scopes.emplace_back();
    scope.name = name;
    scope.element = element;
    scope.file = &file;
    scope.outer = outer;
    scope.depth = outer != nullptr ? outer->depth + 1 : 0;
    scope.vertex = vertex;
    scope.is_merged = overrides.is_merged;
    if (vertex != nullptr) vertex->inner = &scope;
    if (outer != nullptr) {
      scope.prefix = outer->prefix;
      if (!overrides.is_merged) scope.prefix += name + "::";
    }
    scope.frame = outer != nullptr ? outer->frame : xacro::kNoFrame;
    if (overrides.element) scope.frame = add_frame_of(overrides.element, file, scope.frame);
    scope.is_static = overrides.is_static.value_or(truth_in(element, "static", false));
    scope.canonical_link = attribute_of(element, "canonical_link");
    scope.placement_frame = overrides.placement_frame
                                ? *overrides.placement_frame
                                : std::string(attribute_of(element, "placement_frame"));
    scope.placement_place = place.name_span();
    if (outer == nullptr && pose && !model_.is_entity) {
      model_.X_W = pose_in(pose).value_or(Pose{});
      if (!attribute_of(pose, "relative_to").empty()) {
        reporter_.refuse(pose.attribute("relative_to")->value_span(),
                         "the pose of the model of a file is relative to nothing",
                         "delete `relative_to`");
      }
    }
    const std::size_t links = model_.links.size();
    add_content(element, scope);
    // What an include names has links: without its file, only the file is reported.
    if (model_.links.size() == links && !scope.is_static && !is_full_ &&
        !element.child("include") &&
        !std::any_of(scope.order.begin(), scope.order.end(),
                     [](const Vertex* one) { return one->kind == Vertex::Kind::model; })) {
      reporter_.refuse_name(element.name_span(), "the model " + quoted(name) + " has no link",
                            "add a `<link>`");
    }
  }

  xacro::FrameId add_frame_of(View include, const SdfFile& file, xacro::FrameId around) {
    xacro::Frame frame;
    frame.kind = xacro::Frame::Kind::include;
    frame.parent = around;
    frame.call = include.tag_span();
    frame.name = file.path;
    model_.frames.push_back(std::move(frame));
    return xacro::FrameId{static_cast<std::uint32_t>(model_.frames.size() - 1)};
  }

  /// `around`: null for that of a file, which is its model.
  void include(View element, const SdfFile& including, Scope* around) {
    if (!has_room(element, around)) return;
    const bool is_in_world = around != nullptr && around->is_world;
    const View address = element.child("uri");
    const std::string uri(text_of(address));
    if (uri.empty()) {
      reporter_.refuse(element.name_span(), "`include` needs a `<uri>`",
                       "write the address of the model");
      return;
    }
    const Span place = address.text_span();
    const auto path = files_.find_model(uri, including, place);
    if (!path) return;
    if (open_.contains(*path)) {
      reporter_.refuse(place, quoted(uri) + " includes itself",
                       "delete one of the includes, which have no end");
      return;
    }
    if (open_.size() >= reporter_.context().limits.include_depth) {
      reporter_.exceed(place,
                       "models include each other in more than " +
                           std::to_string(reporter_.context().limits.include_depth) + " levels",
                       "include-depth");
      return;
    }
    const SdfFile* file = files_.open(*path, place);
    if (file == nullptr) return;
    const View model = file->root.child("model");
    if (!model) {
      const View light = file->root.child("light");
      if (light && is_in_world) model_.lights.push_back({light, element, around});
      if (!light && !file->root.child("actor"))
        reporter_.refuse(place, quoted(uri) + " has no model", "name a file with a `<model>`");
      return;
    }
    Overrides overrides;
    overrides.element = element;
    overrides.name = text_in(element, "name");
    overrides.pose = element.child("pose");
    if (const View one = element.child("static"))
      overrides.is_static = sdf::read_flag(text_of(one));
    if (const View one = element.child("placement_frame")) {
      overrides.placement_frame = std::string(text_of(one));
      if (!overrides.pose) {
        reporter_.refuse(one.name_span(), "`placement_frame` of an include needs a `<pose>`",
                         "write the pose of this frame");
      }
    }
    overrides.is_merged = sdf::read_flag(attribute_of(element, "merge")).value_or(false);
    for (const View one : element) {
      if (one.name() == "experimental:params") {
        reporter_
            .report(rules::sml9304_lost_in_urdf, one.name_span(),
                    "changes of an included model by `experimental:params` are not read, so they "
                    "are lost")
            .help("change a copy of the model");
      }
    }
    if (overrides.is_merged && is_in_world) {
      reporter_.refuse(element.name_span(), "a world cannot merge a model",
                       "delete `merge=\"true\"`");
      return;
    }
    if (around == nullptr) {
      model_.element = model;
      model_.name = overrides.name.empty() ? attribute_of(model, "name") : overrides.name;
    }
    open_.insert(*path);
    add_model(model, *file, around, overrides);
    open_.erase(*path);
  }

  Files& files_;
  Reporter& reporter_;
  Model& model_;
  std::set<std::string> open_;
  std::uint64_t parts_ = 0, bytes_ = 0;
  bool is_full_ = false;
};

}  // namespace

bool build(Files& files, Model& model) { return Builder(files, model).run(); }

void build_part(Files& files, const Scope& part, Model& model) { Builder(files, model).run(part); }

}  // namespace smurf::sdformat
