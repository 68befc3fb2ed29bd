// SPDX-License-Identifier: BSD-3-Clause
// Files that get another name: what names them follows.
#include <optional>
#include <set>

#include "base/path.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf-lsp/uri.hpp"

namespace smurf::lsp {
namespace {

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

/// How `text`, which names the file `from`, names it when it is `to`. None when that cannot be
/// told.
std::optional<std::string> renamed(std::string_view text, const std::string& from,
                                   const std::string& to, std::string_view folder) {
  const std::string_view old_name = path::file_name(from);
  if (path::parent(from) == path::parent(to) && text.ends_with(old_name)) {
    text.remove_suffix(old_name.size());
    return std::string(text) + std::string(path::file_name(to));
  }
  if (text.find("://") != std::string_view::npos || path::is_absolute(text)) return std::nullopt;
  return path::relative(to, std::string(folder));
}

}  // namespace

Json file_filters() {
  return {
      {"filters", {{{"scheme", "file"}, {"pattern", {{"glob", "**/*"}, {"matches", "file"}}}}}}};
}

Json rename_files(Context& context, const Json& params) {
  const Json& renames = at(params, {"files"});
  std::vector<Edit> edits;
  if (!renames.is_array()) return nullptr;
  for (const std::string& file : files_of(context)) {
    for (const FileView& view : context.workspace.views(file)) {
      for (const FileLink& link : links_in(context, view)) {
        for (const Json& one : renames) {
          const std::string from = path_of_uri(text_at(one, {"oldUri"}));
          const std::string to = path_of_uri(text_at(one, {"newUri"}));
          if (from.empty() || to.empty() || link.path != from) continue;
          const std::string_view text = context.workspace.loaded_sources().text(link.span);
          if (auto changed = renamed(text, from, to, path::parent(file))) {
            edits.push_back({link.span, *std::move(changed)});
          }
        }
      }
    }
  }
  if (edits.empty()) return nullptr;
  return workspace_edit(context, edits, context.workspace.loaded_sources());
}

}  // namespace smurf::lsp
