// SPDX-License-Identifier: BSD-3-Clause
// Definition, references and highlights, from the table of references.
#include <cstdint>
#include <set>
#include <tuple>

#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

/// Calls `visit` once with every place of the name at the place of the request.
template <class Visit>
void for_each_place(Context& context, const Json& params, const Visit& visit) {
  for (const PlaceView& place : places_in(context, params)) {
    const Reference* named = reference_at(context, place);
    if (named == nullptr || !named->is_known()) continue;
    for (const Reference& one : context.workspace.names().names()[place.view.part]) {
      if (is_same_thing(one, *named)) visit(one);
    }
  }
}

/// Removes repeated places: several models may have the same. They are kept as text, since a name
/// may have very many, and those after the first kMostPlaces are left out.
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

Json definition(Context& context, const Json& params) {
  Places places(context);
  for_each_place(context, params, [&](const Reference& one) {
    if (one.is_definition) places.add(one);
  });
  if (!places.empty()) return places.take();
  // The name of a file leads to the file.
  for (const FileLink& link : links_at(context, params)) {
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
void for_each_file_name(Context& context, const Json& params, const Visit& visit) {
  const std::vector<FileLink> wanted = links_at(context, params);
  if (wanted.empty()) return;
  for_each_link(context, [&](const FileView&, const FileLink& link) {
    if (link.path == wanted.front().path) visit(link.span);
  });
}

}  // namespace

Json references(Context& context, const Json& params) {
  const bool with_definition = flag_at(params, {"context", "includeDeclaration"}, true);
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
  Places places(context);
  const auto add = [&](Span span, int kind) {
    if (context.workspace.loaded_sources().path(span.source) != path) return;
    places.add(path, span, {{"range", loaded_positions(context).range(span)}, {"kind", kind}});
  };
  for_each_place(context, params,
                 [&](const Reference& one) { add(one.span, one.is_definition ? kWrite : kRead); });
  if (places.empty()) {
    for_each_file_name(context, params, [&](Span span) { add(span, kRead); });
  }
  return places.take();
}

}  // namespace smurf::lsp
