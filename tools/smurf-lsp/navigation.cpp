// SPDX-License-Identifier: BSD-3-Clause
// Where a name is defined and used, from the table of references.
#include <algorithm>

#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

/// Calls `visit` with every place of what is named at the place of the request, once each.
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

void add_once(Json list_entry, Json& list) {
  if (std::find(list.begin(), list.end(), list_entry) == list.end()) {
    list.push_back(std::move(list_entry));
  }
}

}  // namespace

Json definition(Context& context, const Json& params) {
  Json places = Json::array();
  for_each_place(context, params, [&](const Reference& one) {
    if (one.is_definition) add_once(location(context, one.span), places);
  });
  if (!places.empty()) return places;
  // The name of a file leads to the file.
  for (const FileLink& link : links_at(context, params)) {
    const Json start = {{"line", 0}, {"character", 0}};
    add_once({{"uri", context.workspace.uri_of(link.path)},
              {"range", {{"start", start}, {"end", start}}}},
             places);
  }
  return places;
}

Json references(Context& context, const Json& params) {
  const bool with_definition = flag_at(params, {"context", "includeDeclaration"}, true);
  Json places = Json::array();
  for_each_place(context, params, [&](const Reference& one) {
    if (with_definition || !one.is_definition) add_once(location(context, one.span), places);
  });
  return places;
}

Json highlights(Context& context, const Json& params) {
  constexpr int kRead = 2;  // DocumentHighlightKind
  constexpr int kWrite = 3;
  const std::string path = path_in(params);
  Json places = Json::array();
  for_each_place(context, params, [&](const Reference& one) {
    if (context.workspace.loaded_sources().path(one.span.source) != path) return;
    add_once({{"range", loaded_positions(context).range(one.span)},
              {"kind", one.is_definition ? kWrite : kRead}},
             places);
  });
  return places;
}

}  // namespace smurf::lsp
