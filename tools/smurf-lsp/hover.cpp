// SPDX-License-Identifier: BSD-3-Clause
// Hover: the meaning of the name, mesh, pose or key under the cursor.
#include <optional>
#include <string>
#include <vector>

#include "base/files/path.hpp"
#include "base/text/quoted.hpp"
#include "config/companion_help.hpp"
#include "config/key_help.hpp"
#include "link/describe.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf/companions.hpp"
#include "smurf/dialect.hpp"
#include "smurf/flatten.hpp"

namespace smurf::lsp {
namespace {

using Lines = std::vector<std::string>;

/// The text, and the span that it is about.
struct Said {
  Span span;
  Lines lines;
};

std::optional<Said> name_at(Context& context, const PlaceView& place) {
  const Reference* named = reference_at(context, place);
  if (named == nullptr || !named->is_known()) return std::nullopt;
  Lines lines = place.view.model != nullptr ? describe(*place.view.model, *named)
                                            : describe(*place.view.scene, *named);
  if (lines.empty()) return std::nullopt;
  for (const Reference& one : context.workspace.names().names()[place.view.part]) {
    if (!one.is_definition || !is_same_thing(one, *named)) continue;
    const SourceMap& sources = context.workspace.loaded_sources();
    const Position at = sources.position(one.span.source, one.span.begin);
    const std::string_view file = path::file_name(sources.path(one.span.source));
    lines.push_back("defined in " + std::string(file) + ":" + std::to_string(at.line));
    break;
  }
  return Said{named->span, std::move(lines)};
}

/// The scale of the shape that names the mesh there.
Vector3 scale_of(const LinkedModel& model, Span filename) {
  Vector3 scale{1, 1, 1};
  const auto look_at = [&](const auto& shapes) {
    for (const auto& one : shapes) {
      const auto* mesh = std::get_if<urdf::Mesh>(&one.geometry.shape);
      if (mesh != nullptr && mesh->filename.span == filename && mesh->scale) scale = *mesh->scale;
    }
  };
  for (const urdf::Link& link : model.robot->links) {
    look_at(link.visuals);
    look_at(link.collisions);
  }
  return scale;
}

std::optional<Said> mesh_at(Context& context, const PlaceView& place) {
  if (place.view.model == nullptr) return std::nullopt;
  for (const MeshReference& mesh : place.view.model->meshes) {
    const bool is_here = mesh.span.source == place.view.source && mesh.span.begin <= place.offset &&
                         place.offset <= mesh.span.end;
    if (!is_here || mesh.is_texture) continue;
    if (!mesh.exists) return Said{mesh.span, {"there is no such file"}};
    MeshLibrary library;
    const MeshFile& file =
        library.read(mesh.path, context.workspace.files(), context.workspace.limits());
    if (file.status != ReadStatus::ok) return Said{mesh.span, {file.reason}};
    Lines lines = describe(file.facts, scale_of(*place.view.model, mesh.span));
    lines.push_back(mesh.path);
    return Said{mesh.span, std::move(lines)};
  }
  return std::nullopt;
}

std::optional<KeyHelp> help_of_key(const Context& context, const std::string& path,
                                   const FileView& view, yaml::NodeId id) {
  const KeyPath keys = key_path(*view.yaml, id);
  const std::string_view text = context.workspace.loaded_sources().text(view.source);
  const CompanionSpec* kind = find_companion_kind(path, text);
  if (kind != nullptr && !kind->is_xml) return companion_key_help({kind->title, text}, keys);
  const auto language = key_language(path);
  return language ? key_help(*language, keys) : std::nullopt;
}

std::optional<Said> yaml_key_at(const Context& context, const PlaceView& place) {
  const std::string& path = context.workspace.loaded_sources().path(place.view.source);
  const yaml::NodeId id = yaml::node_at(*place.view.yaml, place.offset);
  if (id == yaml::kNoNode) return std::nullopt;
  const auto help = help_of_key(context, path, place.view, id);
  if (!help) return std::nullopt;
  const yaml::Node& node = place.view.yaml->nodes[static_cast<std::size_t>(id)];
  const bool is_key = node.key_span().begin <= place.offset && place.offset <= node.key_span().end;
  return Said{is_key ? node.key_span() : node.span, describe(*help)};
}

bool holds(Span span, std::uint32_t offset) { return span.begin <= offset && offset <= span.end; }

/// The link whose frame contains an <origin>, or to which it leads.
std::optional<LinkIndex> link_around(const LinkedModel& model, xml::View element) {
  for (; element; element = element.parent()) {
    for (std::uint32_t i = 0; i < model.robot->links.size(); ++i) {
      if (model.robot->links[i].element == element.id()) return LinkIndex{i};
    }
    for (std::uint32_t i = 0; i < model.robot->joints.size(); ++i) {
      if (model.robot->joints[i].element == element.id()) return model.tree.joint_child[i];
    }
  }
  return std::nullopt;
}

/// The pose of a shape or an inertia, in the frame of its link, from its <origin>. None if the
/// element is the <origin> of a joint.
std::optional<Pose> pose_in(const urdf::Link& link, xml::View element) {
  std::optional<Pose> pose;
  const auto look_at = [&](const urdf::Origin& origin) {
    if (origin.element == element.id()) pose = urdf::to_pose(origin);
  };
  if (link.inertial) look_at(link.inertial->origin);
  for (const urdf::Visual& one : link.visuals) look_at(one.origin);
  for (const urdf::Collision& one : link.collisions) look_at(one.origin);
  return pose;
}

/// An element of URDF, SRDF or ros2_control.
std::optional<ElementHelp> help_of_element(const Context& context, const FileView& view,
                                           xml::View element) {
  if (!element) return std::nullopt;
  const xml::View parent = element.parent();
  const std::string& path = context.workspace.loaded_sources().path(view.source);
  bool is_of_companion = is_companion_path(path);
  for (xml::View at = element; at && !is_of_companion; at = at.parent()) {
    is_of_companion = at.name() == "ros2_control";
  }
  return is_of_companion
             ? companion_element_help(parent ? parent.name() : std::string_view(), element.name())
             : element_help(element.name());
}

std::optional<Said> xml_key_at(const Context& context, const PlaceView& place) {
  const xml::View element(*place.view.xml, xml::element_at(*place.view.xml, place.offset));
  const auto help = help_of_element(context, place.view, element);
  if (!help) return std::nullopt;
  Lines pose;
  const LinkedModel* model = place.view.model;
  const bool is_of_model =
      model != nullptr && model->robot && place.view.xml == &model->robot->document;
  if (element.name() == "origin" && is_of_model) {
    if (const auto link = link_around(*model, element)) {
      pose = describe_place(*model, *link, pose_in(model->link(*link), element));
    }
  }
  if (holds(element.name_span(), place.offset)) {
    Lines lines{"`" + std::string(help->name) + "`", std::string(help->doc)};
    lines.insert(lines.end(), pose.begin(), pose.end());
    return Said{element.name_span(), std::move(lines)};
  }
  for (const xml::Attribute& one : element.attributes()) {
    if (!holds(one.span(), place.offset)) continue;
    for (const KeyHelp& key : help->attributes) {
      if (key.name != one.name()) continue;
      Lines lines = describe(key);
      lines.insert(lines.end(), pose.begin(), pose.end());
      return Said{one.span(), std::move(lines)};
    }
  }
  return std::nullopt;
}

/// The world pose of an entity and the transforms on the way there.
Lines entity_pose(const PlaceView& place) {
  const LinkedScene* scene = place.view.scene;
  if (scene == nullptr || place.view.yaml == nullptr || place.view.model != nullptr) return {};
  for (std::uint32_t i = 0; i < scene->instances.size(); ++i) {
    const Instance& instance = scene->instances[i];
    if (scene->file(scene->use(instance)).source != place.view.source || !instance.X_WE) continue;
    const yaml::View entity(*place.view.yaml, scene->entity(instance).node);
    if (!entity || !holds(entity.span(), place.offset)) continue;
    Lines lines{"in the world: " + describe(*instance.X_WE)};
    const auto steps = explain(*scene, InstanceIndex{i}, *dialects().front());
    constexpr std::size_t kMost = 12;
    for (std::size_t step = 0; step < steps.size() && step < kMost; ++step) {
      lines.push_back("- " + steps[step].what + ": " + describe(steps[step].X_step));
    }
    return lines;
  }
  return {};
}

/// A file name: its file, and the key that expects it.
std::optional<Said> file_at(Context& context, const PlaceView& place) {
  std::vector<FileLink> links = links_in(context, place.view);
  for (FileLink& link : launch_links_in(context, place.view)) links.push_back(std::move(link));
  for (const FileLink& link : links) {
    if (!holds(link.span, place.offset)) continue;
    const bool exists = context.workspace.files().is_file(link.path);
    return Said{link.span, {exists ? link.path : "there is no file " + link.path}};
  }
  return std::nullopt;
}

std::optional<Said> said_at(Context& context, const PlaceView& place) {
  if (auto name = name_at(context, place)) return name;
  if (auto mesh = mesh_at(context, place)) return mesh;
  if (const auto argument = launch_argument_at(context, place)) {
    const SourceMap& sources = context.workspace.loaded_sources();
    const Position at = sources.position(argument->declared.source, argument->declared.begin);
    const std::string_view file = path::file_name(sources.path(argument->declared.source));
    return Said{argument->span,
                {"argument " + quoted(argument->name) + " of the xacro" +
                     (argument->has_default ? ", which has a default" : ", without a default"),
                 "declared in " + std::string(file) + ":" + std::to_string(at.line)}};
  }
  auto file = file_at(context, place);
  if (place.view.xml != nullptr) return file ? file : xml_key_at(context, place);
  if (place.view.yaml == nullptr) return file;
  auto key = yaml_key_at(context, place);
  if (!key) return file;
  if (file) key->lines.insert(key->lines.end(), file->lines.begin(), file->lines.end());
  const bool is_pose =
      key->lines[0].starts_with("`position`") || key->lines[0].starts_with("`rotation`");
  if (is_pose) {
    const Lines pose = entity_pose(place);
    key->lines.insert(key->lines.end(), pose.begin(), pose.end());
  }
  return key;
}

}  // namespace

Json hover(Context& context, const Json& params) {
  if (Json xacro = xacro_hover(context, params); !xacro.is_null()) return xacro;
  for (const PlaceView& place : places_in(context, params)) {
    const auto said = said_at(context, place);
    if (!said) continue;
    return {{"contents", markdown(said->lines)},
            {"range", loaded_positions(context).range(said->span)}};
  }
  return nullptr;
}

}  // namespace smurf::lsp
