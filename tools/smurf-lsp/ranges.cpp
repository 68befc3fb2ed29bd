// SPDX-License-Identifier: BSD-3-Clause
// Folding ranges and selection ranges: entries and elements.
#include <algorithm>
#include <set>

#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

Span whole_of(const yaml::Node& node) {
  const Span key = node.key_span();
  if (key.empty()) return node.span;
  return {key.source, key.begin, std::max(key.end, node.span.end)};
}

/// All nodes or elements, and comments of XML.
std::vector<Span> blocks_of(const FileView& view) {
  std::vector<Span> blocks;
  if (view.yaml != nullptr) {
    for (const yaml::Node& node : view.yaml->nodes) blocks.push_back(whole_of(node));
  } else if (view.xml != nullptr) {
    for (const xml::Element& element : view.xml->elements) blocks.push_back(element.span);
  }
  return blocks;
}

/// The ranges around a place, from the inside out.
std::vector<Span> around(const FileView& view, std::uint32_t offset) {
  std::vector<Span> spans;
  if (view.yaml != nullptr) {
    for (yaml::NodeId id = yaml::node_at(*view.yaml, offset); id != yaml::kNoNode;) {
      const yaml::Node& node = view.yaml->nodes[static_cast<std::size_t>(id)];
      spans.push_back(node.span);
      spans.push_back(whole_of(node));
      id = node.parent;
    }
  } else if (view.xml != nullptr) {
    for (xml::View at(*view.xml, xml::element_at(*view.xml, offset)); at; at = at.parent()) {
      for (const xml::Attribute& one : at.attributes()) {
        spans.push_back(one.value_span());
        spans.push_back(one.span());
      }
      spans.push_back(at.tag_span());
      spans.push_back(at.span());
    }
  }
  std::erase_if(
      spans, [&](Span span) { return span.empty() || offset < span.begin || offset > span.end; });
  return spans;
}

}  // namespace

Json folding_ranges(Context& context, const Json& params) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> lines;
  std::set<std::pair<std::uint32_t, std::uint32_t>> comments;
  const SourceMap& sources = context.workspace.loaded_sources();
  for (const FileView& view : context.workspace.views(path_in(params))) {
    const auto lines_of = [&](Span span) {
      std::string_view text = sources.text(span);
      const std::size_t used = text.find_last_not_of(" \t\r\n") + 1;
      const auto end = span.begin + static_cast<std::uint32_t>(used == 0 ? 0 : used - 1);
      return std::pair(sources.line_of(view.source, span.begin) - 1,
                       sources.line_of(view.source, end) - 1);
    };
    for (const Span block : blocks_of(view)) lines.insert(lines_of(block));
    if (view.xml == nullptr) continue;
    for (const Span comment : view.xml->comments) comments.insert(lines_of(comment));
  }
  Json folds = Json::array();
  for (const auto& [first, last] : lines) {
    if (first < last) folds.push_back({{"startLine", first}, {"endLine", last}});
  }
  for (const auto& [first, last] : comments) {
    if (first >= last) continue;
    folds.push_back({{"startLine", first}, {"endLine", last}, {"kind", "comment"}});
  }
  return folds;
}

Json selection_ranges(Context& context, const Json& params) {
  const std::vector<FileView> views = context.workspace.views(path_in(params));
  const Positions positions = loaded_positions(context);
  Json selections = Json::array();
  const Json& wanted = at(params, {"positions"});
  if (!wanted.is_array()) return selections;
  for (const Json& position : wanted) {
    Json selection;
    if (!views.empty()) {
      const FileView& view = views.front();
      std::vector<Span> spans = around(view, positions.offset(view.source, position));
      // The widest first, so that each is in the one before it.
      std::stable_sort(spans.begin(), spans.end(),
                       [](Span a, Span b) { return a.end - a.begin > b.end - b.begin; });
      spans.erase(std::unique(spans.begin(), spans.end()), spans.end());
      for (const Span span : spans) {
        Json next = {{"range", positions.range(span)}};
        if (!selection.is_null()) next["parent"] = std::move(selection);
        selection = std::move(next);
      }
    }
    if (selection.is_null()) selection = {{"range", {{"start", position}, {"end", position}}}};
    selections.push_back(std::move(selection));
  }
  return selections;
}

}  // namespace smurf::lsp
