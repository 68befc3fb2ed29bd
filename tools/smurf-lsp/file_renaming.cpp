// SPDX-License-Identifier: BSD-3-Clause
// Updates the references to files that are renamed.
#include <algorithm>
#include <optional>
#include <utility>

#include "base/files/path.hpp"
#include "base/text/edits.hpp"
#include "render/printable.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf-lsp/uri.hpp"

namespace smurf::lsp {
namespace {

std::string_view without_quotes(std::string_view text) {
  const bool is_quoted =
      text.size() > 1 && text.front() == text.back() && (text[0] == '\'' || text[0] == '"');
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

/// The new path after renaming files or folders.
struct Renames {
  std::vector<std::pair<std::string, std::string>> list;  ///< from, to

  std::string moved(const std::string& path) const {
    for (const auto& [from, to] : list) {
      if (path == from) return to;
      if (path.starts_with(from + "/")) return to + path.substr(from.size());
    }
    return path;
  }
};

/// The rest of two paths after their common folders.
std::pair<std::string_view, std::string_view> different_ends(std::string_view a,
                                                             std::string_view b) {
  const auto differ = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  auto same = static_cast<std::size_t>(differ.first - a.begin());
  while (same > 0 && a[same - 1] != '/') --same;
  return {a.substr(same), b.substr(same)};
}

/// The new text for `written` in the file `document`, which names the file `path`. None if the text
/// is still correct, or if no text is possible.
std::optional<std::string> renamed(std::string_view written, const std::string& document,
                                   const std::string& path, const Renames& renames) {
  const std::string to = renames.moved(path);
  const std::string folder(path::parent(renames.moved(document)));
  const std::string_view text = without_quotes(written);
  if (to != path) {
    const auto [old_end, new_end] = different_ends(path, to);
    const bool is_escaped = text.find_first_of("\\&'") != std::string_view::npos;
    if (folder == path::parent(document) && text.ends_with(old_end) && !is_escaped) {
      return std::string(text.substr(0, text.size() - old_end.size())) + std::string(new_end);
    }
  }
  if (text.find("://") != std::string_view::npos || path::is_absolute(text)) return std::nullopt;
  const std::string relative = path::relative(to, folder);
  if (relative == path::relative(path, path::parent(document))) return std::nullopt;
  return relative;
}

/// Escapes the new name for its place, because folders may have any characters.
std::string as_written(std::string_view before, const std::string& name, const FileView& view) {
  return view.yaml != nullptr ? yaml_like(before, name) : escape_xml(name);
}

}  // namespace

Json file_filters() {
  const auto filter = [](const char* kind) -> Json {
    return {{"scheme", "file"}, {"pattern", {{"glob", "**/*"}, {"matches", kind}}}};
  };
  return {{"filters", {filter("file"), filter("folder")}}};
}

namespace {

std::vector<Edit> edits_for(Context& context, const Renames& renames) {
  std::vector<Edit> edits;
  const SourceMap& sources = context.workspace.loaded_sources();
  for_each_link(context, [&](const FileView& view, const FileLink& link) {
    if (is_counted_differently(context, view.source, sources)) return;
    const std::string_view text = sources.text(link.span);
    const auto changed = renamed(text, sources.path(view.source), link.path, renames);
    if (changed) edits.push_back({link.span, as_written(text, *changed, view)});
  });
  return edits;
}

/// The file that is named at the place, if it exists and the client can rename files.
std::optional<FileLink> changeable_file_at(Context& context, const Json& params) {
  if (!context.client.renames_files) return std::nullopt;
  for (FileLink& link : links_at(context, params)) {
    if (context.workspace.is_changeable(link.path)) return std::move(link);
  }
  return std::nullopt;
}

}  // namespace

Json rename_files(Context& context, const Json& params) {
  const Json& files = at(params, {"files"});
  if (!files.is_array()) return nullptr;
  Renames renames;
  for (const Json& one : files) {
    std::string from = path_of_uri(text_at(one, {"oldUri"}));
    std::string to = path_of_uri(text_at(one, {"newUri"}));
    if (from.empty() || render::escape(to) != to) continue;
    renames.list.emplace_back(std::move(from), std::move(to));
  }
  const std::vector<Edit> edits = edits_for(context, renames);
  if (edits.empty()) return nullptr;
  return workspace_edit(context, edits, context.workspace.loaded_sources());
}

Json prepare_file_rename(Context& context, const Json& params) {
  const auto link = changeable_file_at(context, params);
  if (!link) return nullptr;
  const std::string_view text = context.workspace.loaded_sources().text(link->span);
  const std::string name(path::file_name(link->path));
  Span span = link->span;
  // The folders stay.
  const std::size_t begin = text.rfind(name);
  if (begin != text.npos) {
    span.begin += static_cast<std::uint32_t>(begin);
    span.end = span.begin + static_cast<std::uint32_t>(name.size());
  }
  return {{"range", loaded_positions(context).range(span)}, {"placeholder", name}};
}

Json rename_file_at(Context& context, const Json& params) {
  const auto link = changeable_file_at(context, params);
  if (!link) return nullptr;
  const std::string name = text_at(params, {"newName"});
  const bool is_name = !name.empty() && name != "." && name != ".." &&
                       name.find('/') == std::string::npos && render::escape(name) == name;
  if (!is_name) throw RequestError(kRequestFailed, "this cannot be the name of a file");
  const std::string to = path::join(path::parent(link->path), name);
  if (context.workspace.files().is_file(to)) {
    throw RequestError(kRequestFailed, "there already is a file '" + name + "'");
  }
  const std::vector<Edit> edits = edits_for(context, {{{link->path, to}}});
  Json edit = workspace_edit(context, edits, context.workspace.loaded_sources());
  edit["documentChanges"].push_back({{"kind", "rename"},
                                     {"oldUri", context.workspace.uri_of(link->path)},
                                     {"newUri", uri_of_path(to)}});
  return edit;
}

}  // namespace smurf::lsp
