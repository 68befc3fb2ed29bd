// SPDX-License-Identifier: BSD-3-Clause
// The tree of a YAML file as it grows: values come in document order, the key before its value.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Thrown through a parser to abandon a document that exceeds a limit.
struct StopParsing {};

/// Builds a tree for the scanner and for yaml-cpp. In a mapping, alternately add a key and its
/// value. Reports SML0002, SML0011, SML0012 and SML0014-SML0016.
class YamlBuilder {
 public:
  /// Identifies an anchor for aliases; 0: none.
  using Anchor = std::size_t;

  /// An open list or mapping.
  struct Collection {
    yaml::NodeId node = yaml::kNoNode;
    yaml::NodeId last_child = yaml::kNoNode;
    std::uint32_t end = 0;   ///< the last key or value so far
    std::uint64_t size = 1;  ///< number of its nodes so far, including itself and expanded aliases
    Anchor anchor = 0;
    bool is_mapping = false;
    bool is_flow = false;  ///< in brackets
    bool has_key = false;  ///< a mapping that expects the value of `key`
    bool is_key = false;   ///< this collection itself is used as a key
    std::string_view key;
    Span key_span;
  };

  YamlBuilder(const SourceMap& sources, SourceId id, const Limits& limits, DiagnosticSink& sink);

  yaml::Document take() { return std::move(document_); }

  Span span(std::uint32_t begin, std::uint32_t end) const { return {document_.source, begin, end}; }
  /// Keeps a text that differs from its bytes.
  std::string_view keep(std::string text) {
    return document_.decoded.emplace_back(std::move(text));
  }

  /// The span is empty for an absent value.
  void add_null(Span span, Anchor anchor = 0);
  /// `text` is a part of the source, or a text that the builder keeps.
  void add_scalar(Span span, yaml::Style style, std::string_view text, Anchor anchor = 0);
  void add_alias(Span span, Anchor anchor);
  /// `begin` is the opening bracket of a list or mapping in brackets.
  void open(yaml::Kind kind, std::uint32_t begin, bool is_flow, Anchor anchor = 0);
  /// Without brackets, a list or mapping ends with its last child.
  void close() { close(open_.back().end); }
  void close(std::uint32_t end);

  /// From the root to the innermost collection.
  const std::vector<Collection>& collections() const { return open_; }
  bool expects_key() const {
    return !open_.empty() && open_.back().is_mapping && !open_.back().has_key;
  }
  std::uint32_t begin(const Collection& collection) const {
    return document_.nodes[index(collection.node)].span.begin;
  }
  /// The innermost open bracket; an empty span if there is none.
  Span open_bracket() const;
  /// One past the last byte of the root.
  std::uint32_t end() const {
    return document_.root == yaml::kNoNode ? 0 : document_.nodes[index(document_.root)].span.end;
  }

 private:
  struct Anchored {
    yaml::NodeId node = yaml::kNoNode;
    std::uint64_t size = 0;
  };
  struct Entry {
    std::string_view key;
    yaml::NodeId id;
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.key != b.key ? a.key < b.key : a.id < b.id;
    }
  };

  static std::size_t index(yaml::NodeId id) { return static_cast<std::size_t>(id); }
  yaml::Node& at(yaml::NodeId id) { return document_.nodes[index(id)]; }

  yaml::NodeId last() const {
    return yaml::NodeId{static_cast<std::uint32_t>(document_.nodes.size() - 1)};
  }

  /// The innermost mapping then expects the value.
  void take_key(Span span, std::string_view key);
  /// Adds a key with an anchor: it has a node, but no place in the tree.
  yaml::Node& add_unlinked(yaml::Kind kind, Span span) {
    return document_.nodes.emplace_back(kind, span);
  }
  yaml::Node& add(yaml::Kind kind, Span span, std::uint64_t size);
  void repeat(Span alias, std::uint64_t size);
  /// Reports that a limit is exceeded, and abandons the document.
  [[noreturn]] void stop(const Rule& rule, Span place, std::string message, std::string_view limit);
  [[noreturn]] void stop_at_nodes(std::uint32_t at);
  [[noreturn]] void stop_at_depth(Span place);
  void report_complex_key(Span place);

  /// False if all keys are certainly different.
  bool may_have_duplicates(const yaml::Node& mapping) const;
  void report_duplicates(const yaml::Node& mapping);

  std::string_view text_;
  const Limits& limits_;
  DiagnosticSink& sink_;
  yaml::Document document_;
  std::vector<Collection> open_;
  std::vector<Entry> entries_;  ///< used by report_duplicates(); a member to reuse its memory
  std::unordered_map<Anchor, Anchored> anchors_;
  std::uint64_t repeated_ = 0;  ///< number of nodes that the aliases so far stand for
};

}  // namespace smurf
