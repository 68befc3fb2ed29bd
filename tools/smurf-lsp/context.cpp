// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/context.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "render/printable.hpp"
#include "smurf-lsp/uri.hpp"

namespace smurf::lsp {

void Context::send(const Json& message) {
  const std::string text = dump(message);
  write(lists.insert_into(text));
  // Messages about progress come from other threads, and never have lists.
  if (!lists.empty()) lists.clear();
}

void Context::ask(const char* method, Json params) {
  send({{"jsonrpc", "2.0"},
        {"id", name + "-" + std::to_string(++last_id)},
        {"method", method},
        {"params", std::move(params)}});
}

std::string path_in(const Json& params) {
  return path_of_uri(text_at(params, {"textDocument", "uri"}));
}

std::vector<PlaceView> places_in(Context& context, const Json& params, Looks looks) {
  const std::string path = path_in(params);
  if (context.workspace.document(path) == nullptr) return {};
  if (looks == Looks::around) context.workspace.look_around(path);
  std::vector<PlaceView> places;
  for (const auto& views : {context.workspace.views_around(path), context.workspace.views(path)}) {
    for (const FileView& view : views) {
      const std::uint32_t offset =
          loaded_positions(context).offset(view.source, at(params, {"position"}));
      places.push_back({view, offset});
    }
  }
  return places;
}

Positions loaded_positions(const Context& context) {
  return {context.workspace.loaded_sources(), context.client.encoding};
}

const Reference* reference_at(Context& context, const PlaceView& place) {
  const Reference* found = nullptr;
  for (const Reference& one : context.workspace.names().names()[place.view.part]) {
    const bool is_here = one.span.source == place.view.source && one.span.begin <= place.offset &&
                         place.offset <= one.span.end;
    // An unresolved reference may share its place with a resolved one.
    if (is_here && (found == nullptr || (!found->is_known() && one.is_known()))) found = &one;
  }
  return found;
}

Json location(const Context& context, Span span) {
  const std::string& path = context.workspace.loaded_sources().path(span.source);
  return {{"uri", context.workspace.uri_of(path)},
          {"range", loaded_positions(context).range(span)}};
}

Json workspace_edit(Context& context, std::span<const Edit> edits, const SourceMap& sources) {
  const Positions positions(sources, context.client.encoding);
  std::map<std::string, std::string> files;  // JSON as text, because trees use more memory
  // Two models that share a file have read it twice.
  std::set<std::tuple<std::string_view, std::uint32_t, std::uint32_t, std::string_view>> seen;
  for (const Edit& edit : edits) {
    const std::string& path = sources.path(edit.span.source);
    if (!seen.emplace(path, edit.span.begin, edit.span.end, edit.text).second) continue;
    std::string& list = files[path];
    list += (list.empty() ? "[" : ",") +
            dump({{"range", positions.range(edit.span)}, {"newText", edit.text}});
  }
  Json changes = Json::object();
  Json documents = Json::array();
  for (auto& [path, list] : files) {
    const OpenDocument* open = context.workspace.document(path);
    const std::string uri = context.workspace.uri_of(path);
    Json whole = context.lists.add(std::move(list += ']'));
    if (!context.client.takes_document_changes) {
      changes[uri] = std::move(whole);
      continue;
    }
    const Json version = open != nullptr ? Json(open->version) : Json(nullptr);
    documents.push_back(
        {{"textDocument", {{"uri", uri}, {"version", version}}}, {"edits", std::move(whole)}});
  }
  if (context.client.takes_document_changes) return {{"documentChanges", std::move(documents)}};
  return {{"changes", std::move(changes)}};
}

bool is_counted_differently(const Context& context, SourceId source, const SourceMap& sources) {
  if (context.workspace.document(sources.path(source)) != nullptr) return false;
  const std::string_view text = sources.text(source);
  for (std::size_t at = text.find('\r'); at != text.npos; at = text.find('\r', at + 1)) {
    if (!text.substr(at + 1).starts_with('\n')) return true;
  }
  return false;
}

namespace {

/// Escapes markup, so that a name cannot become a link, a picture or an element.
std::string unmarked(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    constexpr std::string_view kMarks = "\\`*[]<&!|@";
    const bool is_address = text.substr(i).starts_with("://") || text.substr(i).starts_with("www.");
    if (kMarks.find(text[i]) != std::string_view::npos || is_address) {
      result += text[i] == 'w' ? "www\\." : std::string{'\\', text[i]};
      if (text[i] == 'w') i += 3;
    } else {
      result += text[i];
    }
  }
  return result;
}

/// The next backquote without a neighbouring backquote, from `at` on. npos: there is none.
std::size_t find_mark(std::string_view line, std::size_t at) {
  while ((at = line.find('`', at)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_not_of('`', at), line.size());
    if (end - at == 1) break;
    at = end;
  }
  return at;
}

/// Escapes Markdown except between backquotes. Several backquotes in a row come from a name in a
/// model: Markdown does not end our text, which began with one, at several.
std::string marked_line(std::string_view line) {
  std::string result;
  while (!line.empty()) {
    const std::size_t begin = find_mark(line, 0);
    const std::size_t end = begin == std::string_view::npos ? begin : find_mark(line, begin + 1);
    if (end == std::string_view::npos) break;
    result += unmarked(line.substr(0, begin));
    result += line.substr(begin, end + 1 - begin);
    line.remove_prefix(end + 1);
  }
  return result + unmarked(line);
}

}  // namespace

Json markdown(std::span<const std::string> lines) {
  std::string text;
  for (const std::string& line : lines) {
    if (line.empty()) continue;
    text += (text.empty() ? "" : "\n\n") + marked_line(render::escape(line));
  }
  return {{"kind", "markdown"}, {"value", text}};
}

Json markdown(std::string_view line) { return markdown(std::array{std::string(line)}); }

}  // namespace smurf::lsp
