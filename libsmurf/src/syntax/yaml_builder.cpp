// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/yaml_builder.hpp"

#include <algorithm>
#include <bitset>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/count.hpp"

namespace smurf {

using yaml::Kind;
using yaml::kNoNode;
using yaml::Node;
using yaml::NodeId;

namespace {

/// Estimates the number of values: one for each key, each item and the root.
std::size_t count_of_nodes(std::string_view text) {
  std::size_t count = 2;
  for (const char sign : {':', '-'}) {
    for (const char blank : {' ', '\n', '\r'}) count += count_of(text, sign, blank);
  }
  const std::size_t lists = count_of(text, '[');
  return count + (lists == 0 ? 0 : 2 * lists + count_of(text, ','));
}

/// Keys have a few letters, for which this is faster than std::hash.
std::size_t quick_hash_of(std::string_view key) {
  std::size_t hash = 0;
  for (const char c : key) hash = 31 * hash + static_cast<unsigned char>(c);
  return hash;
}

}  // namespace

YamlBuilder::YamlBuilder(const SourceMap& sources, SourceId id, const Limits& limits,
                         DiagnosticSink& sink)
    : text_(sources.text(id)), limits_(limits), sink_(sink) {
  document_.source = id;
  // A growing array temporarily needs up to three times its size. Only a hostile file has more than
  // one node in 8 bytes.
  document_.nodes.reserve(std::min(count_of_nodes(text_), text_.size() / 8 + 1));
}

Span YamlBuilder::open_bracket() const {
  if (open_.empty() || !open_.back().is_flow) return span(0, 0);
  return span(begin(open_.back()), begin(open_.back()) + 1);
}

void YamlBuilder::add_null(Span span, Anchor anchor) {
  const bool is_key = expects_key();
  if (is_key) take_key(span, text_.substr(span.begin, span.end - span.begin));
  if (is_key && anchor == 0) return;
  is_key ? add_unlinked(Kind::null, span) : add(Kind::null, span, 1);
  if (anchor != 0) anchors_[anchor] = {last(), 1};
}

void YamlBuilder::add_scalar(Span span, yaml::Style style, std::string_view text, Anchor anchor) {
  const bool is_key = expects_key();
  if (is_key) take_key(span, text);
  if (is_key && anchor == 0) return;
  Node& node = is_key ? add_unlinked(Kind::scalar, span) : add(Kind::scalar, span, 1);
  node.style = style;
  node.set_text(text);
  if (anchor != 0) anchors_[anchor] = {last(), 1};
}

void YamlBuilder::add_alias(Span span, Anchor anchor) {
  const auto target = anchors_.find(anchor);
  if (target == anchors_.end()) {
    sink_.report(rules::sml0016_cyclic_alias, span,
                 "the alias `" + std::string(text_.substr(span.begin, span.end - span.begin)) +
                     "` is inside the value that it repeats");
    return add_null(span);
  }
  const Kind kind = at(target->second.node).kind();
  const std::string_view text = at(target->second.node).text();
  if (expects_key()) {
    if (kind == Kind::sequence || kind == Kind::mapping) report_complex_key(span);
    return take_key(span, text);
  }
  // A long text costs as much as many short ones.
  constexpr std::size_t kTextForNode = 100;
  repeat(span, target->second.size + text.size() / kTextForNode);
  add(kind, span, target->second.size).set_target(target->second.node);
}

/// Readers of the tree visit the value of an alias each time that the alias is written.
void YamlBuilder::repeat(Span alias, std::uint64_t size) {
  repeated_ += size;
  if (repeated_ <= limits_.yaml_expanded_nodes) return;
  stop(rules::sml0015_alias_expansion, alias,
       "the aliases up to here repeat more than " + std::to_string(limits_.yaml_expanded_nodes) +
           " values",
       "yaml-expanded-nodes");
}

void YamlBuilder::report_complex_key(Span place) {
  sink_.report(rules::sml0012_complex_key, place, "a list or mapping is used as a key")
      .help("use a plain text, or put it in quotes");
}

void YamlBuilder::take_key(Span span, std::string_view key) {
  Collection& mapping = open_.back();
  mapping.has_key = true;
  mapping.key = key;
  mapping.key_span = span;
  mapping.end = std::max(mapping.end, span.end);
  // A pair inside a flow list, [a: 1], is a mapping without brackets.
  if (mapping.is_flow && span.begin == begin(mapping)) mapping.is_flow = false;
}

Node& YamlBuilder::add(Kind kind, Span span, std::uint64_t size) {
  if (document_.nodes.size() >= limits_.yaml_nodes) stop_at_nodes(span.begin);
  Node& node = add_unlinked(kind, span);
  if (open_.empty()) {
    document_.root = last();
    return node;
  }
  Collection& collection = open_.back();
  node.parent = collection.node;
  if (collection.is_mapping) node.set_key(collection.key, collection.key_span);
  Node& parent = at(collection.node);
  node.set_position(parent.child_count());
  const bool is_first = collection.last_child == kNoNode;
  parent.set_children(is_first ? last() : parent.first_child(), parent.child_count() + 1);
  if (!is_first) at(collection.last_child).next_sibling = last();
  collection.last_child = last();
  collection.has_key = false;
  collection.end = std::max(collection.end, span.end);
  collection.size += size;
  return node;
}

void YamlBuilder::stop(const Rule& rule, Span place, std::string message, std::string_view limit) {
  sink_.report(rule, place, std::move(message)).help(raise_limit(limit));
  throw StopParsing();
}

void YamlBuilder::stop_at_nodes(std::uint32_t at) {
  stop(rules::sml0002_file_too_large, span(at, at),
       "the file contains more than " + std::to_string(limits_.yaml_nodes) + " values",
       "yaml-nodes");
}

void YamlBuilder::stop_at_depth(Span place) {
  stop(rules::sml0014_nesting_too_deep, place,
       "lists and mappings are nested deeper than " + std::to_string(limits_.yaml_depth) +
           " levels",
       "yaml-depth");
}

void YamlBuilder::open(Kind kind, std::uint32_t begin, bool is_flow, Anchor anchor) {
  const Span place = span(begin, begin + 1);
  if (open_.size() >= limits_.yaml_depth) stop_at_depth(place);
  Collection collection;
  collection.is_key = expects_key();
  if (collection.is_key) {
    report_complex_key(place);
    take_key(place, {});
    add_unlinked(kind, place);
  } else {
    add(kind, place, 1);
  }
  collection.node = last();
  collection.end = begin;
  collection.is_mapping = kind == Kind::mapping;
  collection.is_flow = is_flow;
  collection.anchor = anchor;
  open_.push_back(collection);
}

void YamlBuilder::close(std::uint32_t end) {
  const Collection closed = open_.back();
  open_.pop_back();
  Node& node = at(closed.node);
  if (closed.is_mapping) report_duplicates(node);
  node.span.end = end;
  if (closed.anchor != 0) anchors_[closed.anchor] = {closed.node, closed.size};
  if (open_.empty()) return;
  Collection& parent = open_.back();
  parent.end = std::max(parent.end, end);
  if (closed.is_key) {
    parent.key_span = node.span;
  } else {
    parent.size += closed.size - 1;
  }
}

bool YamlBuilder::may_have_duplicates(const Node& mapping) const {
  if (mapping.child_count() < 2) return false;
  std::bitset<2048> seen;  // by hash; in ordinary mappings, few keys share a bit
  for (NodeId child = mapping.first_child(); child != kNoNode;) {
    const Node& node = document_.nodes[index(child)];
    const std::size_t bit = quick_hash_of(node.key()) % seen.size();
    if (seen[bit]) return true;
    seen[bit] = true;
    child = node.next_sibling;
  }
  return false;
}

void YamlBuilder::report_duplicates(const Node& mapping) {
  if (!may_have_duplicates(mapping)) return;
  entries_.clear();
  for (NodeId child = mapping.first_child(); child != kNoNode; child = at(child).next_sibling) {
    // A list or mapping that is used as a key has no text; it is already reported.
    const Span key = at(child).key_span();
    if (at(child).key().empty() && !key.empty() && text_[key.begin] != '"' &&
        text_[key.begin] != '\'') {
      continue;
    }
    entries_.push_back({at(child).key(), child});
  }
  std::sort(entries_.begin(), entries_.end());
  for (std::size_t i = 1, first = 0; i < entries_.size(); ++i) {
    if (entries_[i].key != entries_[first].key) {
      first = i;
      continue;
    }
    at(entries_[i].id).is_repeated = true;
    Diagnostic& diagnostic =
        sink_.report(rules::sml0011_duplicate_key, at(entries_[i].id).key_span(),
                     "duplicate key `" + std::string(entries_[i].key) + "` in one mapping");
    diagnostic.caret = "repeated here";
    diagnostic.label(at(entries_[first].id).key_span(), "first set here");
    diagnostic.note("MARS uses the first value, Phobos (PyYAML) the last");
    diagnostic.help("delete one of the two");
  }
}

}  // namespace smurf
