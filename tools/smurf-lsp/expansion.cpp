// SPDX-License-Identifier: BSD-3-Clause
// The robot that a xacro makes, and the way between its text and the xacro files.
#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

/// The expansion of a document, or, for a part of robots, of the first robot that includes it.
const xacro::Expansion* expansion_of(Context& context, const std::string& path) {
  const auto all = context.workspace.expansions_of(path);
  const SourceMap& sources = context.workspace.loaded_sources();
  for (const Workspace::Expanded& one : all) {
    if (sources.path(one.expansion->root) == path) return one.expansion;
  }
  return all.empty() ? nullptr : all.front().expansion;
}

}  // namespace

Json expansion(Context& context, const Json& params) {
  const xacro::Expansion* made = expansion_of(context, path_in(params));
  if (made == nullptr) return {{"text", nullptr}, {"root", nullptr}};
  const SourceMap& sources = context.workspace.loaded_sources();
  return {{"text", std::string(sources.text(made->source))},
          {"root", context.workspace.uri_of(sources.path(made->root))}};
}

Json expansion_origin(Context& context, const Json& params) {
  const xacro::Expansion* made = expansion_of(context, path_in(params));
  if (made == nullptr) return nullptr;
  const std::uint32_t offset =
      loaded_positions(context).offset(made->source, at(params, {"position"}));
  return location(context, made->origin_of({made->source, offset, offset}).span);
}

Json expansion_places(Context& context, const Json& params) {
  const std::string path = path_in(params);
  Json ranges = Json::array();
  const xacro::Expansion* made = expansion_of(context, path);
  if (made == nullptr) return ranges;
  const SourceMap& sources = context.workspace.loaded_sources();
  const Positions positions = loaded_positions(context);
  constexpr std::size_t kMostRanges = 1000;
  for (const xml::Document& document : made->documents) {
    if (sources.path(document.source) != path) continue;
    const std::uint32_t offset = positions.offset(document.source, at(params, {"position"}));
    // The smallest part that was made there: its value, its attribute or its tag.
    std::uint32_t least = 0xffffffffU;
    for (const xacro::Leaf& leaf : made->leaves) {
      const bool is_here = leaf.use.source == document.source && leaf.use.begin <= offset &&
                           offset <= leaf.use.end && leaf.kind != xacro::Leaf::Kind::end_tag;
      if (!is_here || leaf.use.end - leaf.use.begin > least) continue;
      if (leaf.use.end - leaf.use.begin < least) ranges.clear();
      least = leaf.use.end - leaf.use.begin;
      if (ranges.size() >= kMostRanges) continue;
      ranges.push_back(positions.range({made->source, leaf.begin, leaf.end}));
    }
  }
  return ranges;
}

}  // namespace smurf::lsp
