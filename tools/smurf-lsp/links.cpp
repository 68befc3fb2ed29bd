// SPDX-License-Identifier: BSD-3-Clause
// Document links: the file names in a document and their targets.
#include <set>

#include "base/files/path.hpp"
#include "config/key_help.hpp"
#include "link/surroundings/wanted_names.hpp"
#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

void add_scalars(yaml::View value, const std::string& folder, std::vector<FileLink>& links) {
  if (value.is_sequence()) {
    for (const yaml::View item : value) add_scalars(item, folder, links);
  } else if (value.is_scalar() && !value.span().empty()) {
    links.push_back({value.span(), path::join(folder, value.text())});
  }
}

/// Keys whose values are files, by the tables. Textures are looked up by the linker, see below.
void add_keys(yaml::View value, KeyLanguage language, const std::string& folder,
              std::vector<FileLink>& links, int depth = 0) {
  constexpr int kDeepest = 12;  // the tables have fewer levels
  if ((!value.is_mapping() && !value.is_sequence()) || depth == kDeepest) return;
  for (const yaml::View member : value) {
    const bool is_item = value.is_sequence();  // without a key; there may be hundreds of thousands
    const auto help =
        is_item ? std::nullopt : key_help(language, key_path(member.document(), member.id()));
    if (help && help->is_path) {
      add_scalars(member, folder, links);
    } else {
      add_keys(member, language, folder, links, depth + 1);
    }
  }
}

/// All files of the models and scenes of the open documents.
std::set<std::string> files_of(Context& context) {
  std::set<std::string> files;
  const SourceMap& sources = context.workspace.loaded_sources();
  const auto add = [&](const LinkedModel& model) {
    for (const ModelFile& file : model.files) files.insert(sources.path(file.source));
  };
  for (const tools::LoadedNames::Part& part : context.workspace.names().parts()) {
    if (part.model != nullptr) add(part.model->model);
    if (part.scene == nullptr) continue;
    for (const SceneFile& file : part.scene->scene.scenes) files.insert(sources.path(file.source));
    for (const LinkedModel& model : part.scene->scene.models) add(model);
  }
  return files;
}

bool is_of_model(KeyLanguage language) { return language == KeyLanguage::annotation; }

}  // namespace

std::vector<FileLink> links_in(const Context& context, const FileView& view) {
  std::vector<FileLink> links;
  const std::string& path = context.workspace.loaded_sources().path(view.source);
  const auto language = key_language(path);
  if (view.yaml != nullptr && language && !is_of_model(*language) && view.yaml->view()) {
    add_keys(view.yaml->view(), *language, std::string(path::parent(path)), links);
  }
  if (view.model == nullptr) return links;
  for (const MeshReference& mesh : view.model->meshes) {
    if (mesh.span.source == view.source && !mesh.path.empty()) {
      links.push_back({mesh.span, mesh.path});
    }
  }
  for (const TextureReference& texture : view.model->annotation_textures) {
    if (texture.span.source == view.source) links.push_back({texture.span, texture.path});
  }
  return links;
}

std::vector<FileLink> links_at(Context& context, const Json& params, Looks looks) {
  std::vector<FileLink> found;
  for (const PlaceView& place : places_in(context, params, looks)) {
    for (FileLink& link : links_in(context, place.view)) {
      if (link.span.begin <= place.offset && place.offset <= link.span.end) {
        found.push_back(std::move(link));
      }
    }
  }
  return found;
}

std::vector<FileLink> launch_links_in(Context& context, const FileView& view) {
  std::vector<FileLink> links;
  if (view.launch == nullptr) return links;
  for (LaunchLink& one : launch_links(*view.launch, context.workspace.surroundings_of(view)))
    links.push_back({one.span, std::move(one.path)});
  return links;
}

std::optional<ArgumentAt> launch_argument_at(Context& context, const PlaceView& place) {
  if (place.view.launch == nullptr) return std::nullopt;
  for (const LaunchArgument& one : launch_arguments(*place.view.launch)) {
    if (place.offset < one.span.begin || place.offset > one.span.end) continue;
    for (const XacroArgument& known : context.workspace.surroundings_of(place.view).arguments) {
      if (known.name == one.name && !known.span.empty())
        return ArgumentAt{one.span, known.name, known.span, known.has_default};
    }
  }
  return std::nullopt;
}

void for_each_link(Context& context,
                   const std::function<void(const FileView&, const FileLink&)>& visit) {
  for (const std::string& file : files_of(context)) {
    for (const FileView& view : context.workspace.views(file)) {
      for (const FileLink& link : links_in(context, view)) visit(view, link);
    }
  }
}

Json document_links(Context& context, const Json& params) {
  Json links = Json::array();
  std::set<Json> seen;  // several models may read the file
  for (const FileView& view : context.workspace.views(path_in(params))) {
    for (const FileLink& link : links_in(context, view)) {
      if (!context.workspace.files().is_file(link.path)) continue;
      Json one = {{"range", loaded_positions(context).range(link.span)},
                  {"target", context.workspace.uri_of(link.path)}};
      if (seen.insert(one).second) links.push_back(std::move(one));
    }
  }
  return links;
}

}  // namespace smurf::lsp
