// SPDX-License-Identifier: BSD-3-Clause
// Spans are not in the events: yaml-cpp tells where a value begins, the text where it ends.
#include "syntax/yaml_builder.hpp"

#include <algorithm>

#include "base/limits.hpp"
#include "base/rules.hpp"
#include "syntax/yaml_spans.hpp"

namespace smurf {

using yaml::Kind;
using yaml::kNoNode;
using yaml::Node;
using yaml::NodeId;

Span TreeBuilder::open_bracket() const {
  if (frames_.empty() || !frames_.back().flow) return {document_.source, 0, 0};
  const std::uint32_t begin = document_.nodes[index(frames_.back().node)].span.begin;
  return {document_.source, begin, begin + 1};
}

void TreeBuilder::OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) {
  // An absent value carries the mark of the next token; only a written null has a place.
  const std::uint32_t begin = skip_properties(text_, offset(mark));
  const std::uint32_t size = written_null(begin);
  Node node;
  node.span = {document_.source, begin, begin + size};
  if (size == 0) {
    const std::uint32_t at = absent_place(offset(mark));
    node.span = {document_.source, at, at};
    check_absent(offset(mark));
    check_colon();
  }
  append(node, anchor, 1);
}

void TreeBuilder::OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) {
  const std::uint32_t begin = offset(mark);
  std::uint32_t end = begin + 1;
  while (end < text_.size() &&
         std::string_view(" \t\r\n,[]{}").find(text_[end]) == std::string_view::npos) {
    ++end;
  }
  Node node;
  node.span = {document_.source, begin, end};
  const auto target = anchors_.find(anchor);
  if (target == anchors_.end()) {
    sink_.report(rules::sml0016_cyclic_alias, node.span,
                 "the alias `" + std::string(text_.substr(begin, end - begin)) +
                     "` stands inside the value it repeats");
    append(node, 0, 1);
    return;
  }
  const Node& value = at(target->second);
  node.kind = value.kind;
  node.target = target->second;
  node.text = value.text;
  const bool is_complex = value.kind == Kind::sequence || value.kind == Kind::mapping;
  if (is_complex && expects_key()) {
    sink_.report(rules::sml0012_complex_key, node.span, "a list or mapping is used as a key").help =
        "use a plain text, or put it in quotes";
  }
  append(node, 0, sizes_[index(target->second)]);
}

void TreeBuilder::OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                           const std::string& value) {
  const ScalarExtent extent = scalar_extent(text_, offset(mark), value);
  Node node;
  node.kind = Kind::scalar;
  node.style = extent.style;
  node.span = {document_.source, extent.begin, extent.end};
  if (extent.begin == extent.end) {  // only a tag is written
    node.span.begin = node.span.end = absent_place(offset(mark));
  }
  if (!extent.closed) {
    sink_.report(rules::sml0010_yaml_syntax, {document_.source, extent.begin, extent.begin + 1},
                 "this quote is never closed");
  }
  const std::string_view bytes = text_.substr(extent.begin, extent.end - extent.begin);
  const std::string_view inner = extent.style == yaml::Style::plain || bytes.size() < 2
                                     ? bytes
                                     : bytes.substr(1, bytes.size() - 2);
  node.text = inner == value ? inner : std::string_view(document_.decoded.emplace_back(value));
  append(node, anchor, 1);
}

std::uint32_t TreeBuilder::absent_place(std::uint32_t mark) const {
  if (frames_.empty() || expects_key()) return mark;
  const Frame& frame = frames_.back();
  const std::uint32_t before = frame.has_key ? frame.key_span.end : frame.end;
  const std::uint32_t sign = skip_blank(text_, before);
  const bool is_sign = sign < text_.size() && text_[sign] == (frame.has_key ? ':' : '-');
  return is_sign ? sign + 1 : frame.has_key ? before : mark;
}

std::uint32_t TreeBuilder::written_null(std::uint32_t begin) const {
  for (const std::string_view word : {"~", "null", "Null", "NULL"}) {
    if (!text_.substr(begin).starts_with(word)) continue;
    std::size_t after = begin + word.size();
    if (after < text_.size() &&
        std::string_view(" \t\r\n,]}:").find(text_[after]) == std::string_view::npos) {
      continue;
    }
    after = std::min(text_.find_first_not_of(" \t", after), text_.size());
    const bool is_key = after < text_.size() && text_[after] == ':';
    return is_key && !expects_key() ? 0 : static_cast<std::uint32_t>(word.size());
  }
  return 0;
}

void TreeBuilder::check_absent(std::uint32_t at_offset) {
  if (frames_.empty() || !frames_.back().flow) return;
  const Frame& frame = frames_.back();
  if (frame.has_key || at_offset >= text_.size() || text_[at_offset] != ',') return;
  sink_.report(rules::sml0010_yaml_syntax, {document_.source, at_offset, at_offset + 1},
               "there is no entry before this comma");
}

/// yaml-cpp takes a line that fits nowhere, at the end of a mapping, for a key without value.
void TreeBuilder::check_colon() {
  const bool is_flow =
      std::any_of(frames_.begin(), frames_.end(), [](const Frame& frame) { return frame.flow; });
  if (frames_.empty() || is_flow || !frames_.back().has_key) return;
  const Span key = frames_.back().key_span;
  const std::uint32_t sign = skip_blank(text_, key.end);
  if (key.empty() || (sign < text_.size() && text_[sign] == ':')) return;
  const std::size_t before =
      key.begin == 0 ? std::string_view::npos : text_.find_last_not_of(" \t", key.begin - 1);
  if (before != std::string_view::npos && text_[before] == '?') return;  // `? key` needs none
  sink_.report(rules::sml0010_yaml_syntax, {key.source, key.begin, key.begin + 1},
               "this line does not fit what stands above it: no `:` makes it a key");
}

void TreeBuilder::append(Node node, YAML::anchor_t anchor, std::uint64_t size) {
  if (!takes_key(node)) {
    const NodeId id = add(node, size);
    if (anchor != 0) anchors_[anchor] = id;
  } else if (anchor != 0) {
    anchors_[anchor] = add_unlinked(node);
  }
}

bool TreeBuilder::takes_key(const Node& node) {
  if (!expects_key()) return false;
  Frame& frame = frames_.back();
  frame.has_key = true;
  // A pair inside a flow list, [a: 1], is a mapping without brackets of its own.
  if (node.span.begin == at(frame.node).span.begin) frame.flow = false;
  const bool is_null = node.kind == Kind::null && node.target == kNoNode;
  frame.key = is_null ? text_.substr(node.span.begin, node.span.end - node.span.begin) : node.text;
  frame.key_span = node.span;
  frame.end = std::max(frame.end, node.span.end);
  return true;
}

NodeId TreeBuilder::add_unlinked(const Node& node) {
  document_.nodes.push_back(node);
  sizes_.push_back(1);
  return NodeId{static_cast<std::uint32_t>(document_.nodes.size() - 1)};
}

NodeId TreeBuilder::add(Node& node, std::uint64_t size) {
  const NodeId id{static_cast<std::uint32_t>(document_.nodes.size())};
  if (frames_.empty()) {
    document_.root = id;
  } else {
    Frame& frame = frames_.back();
    node.parent = frame.node;
    node.key = frame.key;
    node.key_span = frame.key_span;
    Node& parent = at(frame.node);
    node.position = parent.child_count++;
    if (frame.last_child == kNoNode) {
      parent.first_child = id;
    } else {
      at(frame.last_child).next_sibling = id;
    }
    frame.last_child = id;
    frame.has_key = false;
    frame.end = std::max(frame.end, node.span.end);
  }
  if (document_.nodes.size() >= limits_.yaml_nodes) {
    stop(rules::sml0002_file_too_large, {node.span.source, node.span.begin, node.span.begin},
         "the file holds more than " + std::to_string(limits_.yaml_nodes) + " values",
         "yaml-nodes");
  }
  document_.nodes.push_back(node);
  sizes_.push_back(size);
  if (!frames_.empty()) grow(frames_.back().node, size);
  return id;
}

void TreeBuilder::stop(const Rule& rule, Span place, std::string message, std::string_view limit) {
  sink_.report(rule, place, std::move(message)).help = raise_limit(limit);
  throw StopParsing();
}

void TreeBuilder::grow(NodeId parent, std::uint64_t size) {
  std::uint64_t& total = sizes_[index(parent)];
  total += size;
  if (total <= limits_.yaml_expanded_nodes) return;
  stop(rules::sml0015_alias_expansion, at(parent).span,
       "aliases make this value larger than " + std::to_string(limits_.yaml_expanded_nodes) +
           " nodes",
       "yaml-expanded-nodes");
}

void TreeBuilder::open(Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) {
  Node node;
  node.kind = kind;
  const std::uint32_t begin = skip_properties(text_, offset(mark));
  node.span = {document_.source, begin, begin + 1};
  if (frames_.size() >= limits_.yaml_depth) {
    stop(rules::sml0014_nesting_too_deep, node.span,
         "lists and mappings are nested deeper than " + std::to_string(limits_.yaml_depth) +
             " levels",
         "yaml-depth");
  }
  Frame frame;
  frame.end = node.span.begin;
  frame.flow = style == YAML::EmitterStyle::Flow;
  frame.anchor = anchor;
  if (takes_key(node)) {
    sink_.report(rules::sml0012_complex_key, node.span, "a list or mapping is used as a key").help =
        "use a plain text, or put it in quotes";
    frame.is_key = true;
    frame.node = add_unlinked(node);
  } else {
    frame.node = add(node, 1);
  }
  frames_.push_back(frame);
}

void TreeBuilder::close() {
  const Frame frame = frames_.back();
  frames_.pop_back();
  Node& node = at(frame.node);
  node.span.end = frame.end;
  if (frame.flow) node.span.end = flow_end(text_, std::max(frame.end, node.span.begin + 1));
  if (frame.anchor != 0) anchors_[frame.anchor] = frame.node;
  if (frames_.empty()) return;
  frames_.back().end = std::max(frames_.back().end, node.span.end);
  if (frame.is_key) {
    frames_.back().key_span = node.span;
  } else {
    grow(frames_.back().node, sizes_[index(frame.node)] - 1);
  }
}

void TreeBuilder::report_duplicates(NodeId mapping) {
  if (at(mapping).child_count < 2) return;
  std::vector<Entry>& entries = entries_;
  entries.clear();
  for (NodeId child = at(mapping).first_child; child != kNoNode; child = at(child).next_sibling) {
    // A list or mapping as a key has no text; it is reported as such.
    const Span key = at(child).key_span;
    if (at(child).key.empty() && !key.empty() && text_[key.begin] != '"' &&
        text_[key.begin] != '\'') {
      continue;
    }
    entries.push_back({at(child).key, child});
  }
  std::sort(entries.begin(), entries.end());
  for (std::size_t i = 1, first = 0; i < entries.size(); ++i) {
    if (entries[i].key != entries[first].key) {
      first = i;
      continue;
    }
    at(entries[i].id).is_repeated = true;
    Diagnostic& diagnostic =
        sink_.report(rules::sml0011_duplicate_key, at(entries[i].id).key_span,
                     "duplicate key `" + std::string(entries[i].key) + "` in one mapping");
    diagnostic.caret = "repeated here";
    diagnostic.labels.push_back({at(entries[first].id).key_span, "first set here"});
    diagnostic.notes.push_back("MARS takes the first value, Phobos (PyYAML) the last");
    diagnostic.help = "delete one of the two";
  }
}

}  // namespace smurf
