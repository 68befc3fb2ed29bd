// SPDX-License-Identifier: BSD-3-Clause
// Definition, references and highlights, from the table of references.
#include <algorithm>
#include <cstdint>
#include <set>
#include <tuple>

#include "base/files/path.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf-lsp/xacro.hpp"

namespace smurf::lsp {
namespace {

/// Calls `visit` once with every place of the name at the place of the request.
template <class Visit>
void for_each_place(Context& context, const Json& params, const Visit& visit,
                    Looks looks = Looks::around) {
  for (const PlaceView& place : places_in(context, params, looks)) {
    const Reference* named = reference_at(context, place);
    if (named == nullptr || !named->is_known()) continue;
    for (const Reference& one : context.workspace.names().names()[place.view.part]) {
      if (is_same_thing(one, *named)) visit(one);
    }
  }
}

/// Collects places without repetitions, because several models may share a file. Keeps them as text
/// to save memory, and ignores all after the first kMostPlaces.
class Places {
 public:
  explicit Places(Context& context) : context_(context) {}
  /// `path` outlives this.
  void add(const std::string& path, Span span, const Json& place) {
    if (seen_.size() == kMostPlaces) return;
    const bool is_new = seen_.emplace(path, span.begin, span.end).second;
    if (is_new) text_ += (empty() ? "" : ",") + dump(place);
  }
  void add(Span span) {
    add(context_.workspace.loaded_sources().path(span.source), span, location(context_, span));
  }
  void add(const Reference& one) { add(one.span); }
  bool empty() const { return text_ == "["; }
  Json take() { return context_.lists.add(std::move(text_) + "]"); }

 private:
  Context& context_;
  std::set<std::tuple<std::string_view, std::uint32_t, std::uint32_t>> seen_;
  std::string text_ = "[";
};

}  // namespace

namespace {

/// Locations of a name of xacro; empty if the place of the request has none.
std::vector<Json> xacro_locations(Context& context, const Json& params, bool definitions,
                                  bool others) {
  std::vector<Json> found;
  std::set<std::tuple<SourceId, std::size_t, std::size_t>> seen;  // a file may be included twice
  const auto request = xacro_request(context, params);
  const auto meaning = request ? xacro_meaning(*request->family, request->offset) : std::nullopt;
  if (!meaning) return found;
  const auto is_definition = [&](const XacroPlace& place) {
    return std::any_of(meaning->definitions.begin(), meaning->definitions.end(),
                       [&](const XacroMeaning::Definition& one) {
                         return one.file == place.file &&
                                one.name->place.begin == place.range.begin;
                       });
  };
  for (const XacroPlace& place : xacro_places(*request->family, *meaning)) {
    if (!(is_definition(place) ? definitions : others) || found.size() >= kMostPlaces) continue;
    const bool is_new = seen.emplace(place.file->source, place.range.begin, place.range.end).second;
    if (is_new) found.push_back(to_json(*request->family, place, context));
  }
  return found;
}

/// The files that an include means, or the package that `$(find ...)` names.
std::vector<std::string> xacro_files_at(Context& context, const Json& params) {
  const auto request = xacro_request(context, params);
  if (!request) return {};
  const std::string_view text = request->text();
  const XacroExpression around = xacro_expression_at(text, request->offset);
  constexpr std::string_view kFind = "find ";
  if (around.kind == '(' && around.inner.of(text).starts_with(kFind)) {
    const std::string name(around.inner.of(text).substr(kFind.size()));
    const auto folder = context.workspace.package_folder(name, request->path);
    if (folder) return {path::join(*folder, "package.xml")};
  }
  for (const TextRange include : request->own().read.includes) {
    if (!include.holds(request->offset)) continue;
    return context.workspace.xacro_files_meant(std::string(include.of(text)), request->path);
  }
  return {};
}

}  // namespace

Json definition(Context& context, const Json& params) {
  if (const auto found = xacro_locations(context, params, true, false); !found.empty()) {
    return found;
  }
  Places places(context);
  for (const std::string& file : xacro_files_at(context, params)) {
    const Json start = {{"line", 0}, {"character", 0}};
    places.add(
        file, {},
        {{"uri", context.workspace.uri_of(file)}, {"range", {{"start", start}, {"end", start}}}});
  }
  if (!places.empty()) return places.take();
  for_each_place(context, params, [&](const Reference& one) {
    if (one.is_definition) places.add(one);
  });
  for (const PlaceView& place : places_in(context, params)) {
    if (const auto argument = launch_argument_at(context, place)) places.add(argument->declared);
  }
  if (!places.empty()) return places.take();
  // The name of a file leads to the file.
  std::vector<FileLink> links = links_at(context, params);
  for (const PlaceView& place : places_in(context, params)) {
    for (FileLink& link : launch_links_in(context, place.view)) {
      const bool is_here = link.span.begin <= place.offset && place.offset <= link.span.end;
      if (is_here) links.push_back(std::move(link));
    }
  }
  for (const FileLink& link : links) {
    const Json start = {{"line", 0}, {"character", 0}};
    places.add(link.path, {},
               {{"uri", context.workspace.uri_of(link.path)},
                {"range", {{"start", start}, {"end", start}}}});
  }
  return places.take();
}

namespace {

/// The places that name the same file as the place of the request.
template <class Visit>
void for_each_file_name(Context& context, const Json& params, const Visit& visit,
                        Looks looks = Looks::around) {
  const std::vector<FileLink> wanted = links_at(context, params, looks);
  if (wanted.empty()) return;
  for_each_link(context, [&](const FileView&, const FileLink& link) {
    if (link.path == wanted.front().path) visit(link.span);
  });
}

}  // namespace

Json references(Context& context, const Json& params) {
  context.workspace.look_around();
  const bool with_definition = flag_at(params, {"context", "includeDeclaration"}, true);
  const auto found = xacro_locations(context, params, with_definition, true);
  if (!found.empty()) return found;
  Places places(context);
  for_each_place(context, params, [&](const Reference& one) {
    if (with_definition || !one.is_definition) places.add(one);
  });
  if (places.empty()) {
    for_each_file_name(context, params, [&](Span span) { places.add(span); });
  }
  return places.take();
}

Json highlights(Context& context, const Json& params) {
  constexpr int kRead = 2;  // DocumentHighlightKind
  constexpr int kWrite = 3;
  const std::string path = path_in(params);
  Json found = Json::array();
  const std::string own = context.workspace.uri_of(path);
  for (const bool is_definition : {true, false}) {
    for (const Json& one : xacro_locations(context, params, is_definition, !is_definition)) {
      if (at(one, {"uri"}) != own) continue;
      found.push_back({{"range", at(one, {"range"})}, {"kind", is_definition ? kWrite : kRead}});
    }
  }
  if (!found.empty()) return found;
  Places places(context);
  const auto add = [&](Span span, int kind) {
    if (context.workspace.loaded_sources().path(span.source) != path) return;
    places.add(path, span, {{"range", loaded_positions(context).range(span)}, {"kind", kind}});
  };
  for_each_place(
      context, params,
      [&](const Reference& one) { add(one.span, one.is_definition ? kWrite : kRead); },
      Looks::at_what_is_loaded);
  if (places.empty()) {
    for_each_file_name(
        context, params, [&](Span span) { add(span, kRead); }, Looks::at_what_is_loaded);
  }
  return places.take();
}

}  // namespace smurf::lsp
