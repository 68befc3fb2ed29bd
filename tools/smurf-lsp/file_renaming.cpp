// SPDX-License-Identifier: BSD-3-Clause
// Updates the references to files that are renamed.
#include <optional>
#include <set>

#include "base/edits.hpp"
#include "base/path.hpp"
#include "render/printable.hpp"
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

std::string_view without_quotes(std::string_view text) {
  const bool is_quoted =
      text.size() > 1 && text.front() == text.back() && (text[0] == '\'' || text[0] == '"');
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

/// The new text for `written`, which names the file `from`, when that becomes `to`. None when there
/// is no such text.
std::optional<std::string> renamed(std::string_view written, const std::string& from,
                                   const std::string& to, std::string_view folder) {
  const std::string_view old_name = path::file_name(from);
  std::string_view text = without_quotes(written);
  const bool is_escaped = text.find_first_of("\\&'") != std::string_view::npos;
  if (path::parent(from) == path::parent(to) && text.ends_with(old_name) && !is_escaped) {
    text.remove_suffix(old_name.size());
    return std::string(text) + std::string(path::file_name(to));
  }
  if (text.find("://") != std::string_view::npos || path::is_absolute(text)) return std::nullopt;
  return path::relative(to, std::string(folder));
}

/// Escapes the new name for its place; folders may have any characters.
std::string as_written(std::string_view before, const std::string& name, const FileView& view) {
  return view.yaml != nullptr ? yaml_like(before, name) : escape_xml(name);
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
      if (is_counted_differently(context, view.source, context.workspace.loaded_sources()))
        continue;
      for (const FileLink& link : links_in(context, view)) {
        for (const Json& one : renames) {
          const std::string from = path_of_uri(text_at(one, {"oldUri"}));
          const std::string to = path_of_uri(text_at(one, {"newUri"}));
          if (from.empty() || link.path != from || render::escape(to) != to) continue;
          const std::string_view text = context.workspace.loaded_sources().text(link.span);
          if (auto changed = renamed(text, from, to, path::parent(file))) {
            edits.push_back({link.span, as_written(text, *changed, view)});
          }
        }
      }
    }
  }
  if (edits.empty()) return nullptr;
  return workspace_edit(context, edits, context.workspace.loaded_sources());
}

}  // namespace smurf::lsp
