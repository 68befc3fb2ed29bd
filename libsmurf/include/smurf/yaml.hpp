// SPDX-License-Identifier: BSD-3-Clause
// The YAML tree: order, duplicates, styles and byte spans as the author wrote them.
#pragma once

#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/source.hpp"

namespace smurf::yaml {

enum class NodeId : std::uint32_t {};
inline constexpr NodeId kNoNode{0xffffffffU};

enum class Kind : std::uint8_t { null, scalar, sequence, mapping };
enum class Style : std::uint8_t { plain, single_quoted, double_quoted, block };

/// One node of the tree. An alias is a separate node that refers to the anchored node. Models have
/// hundreds of thousands of nodes, so members that exclude each other share memory: a scalar has a
/// text, other nodes have children, and only members of a mapping have keys.
class Node {
 public:
  Node(Kind kind, Span place) : span(place), kind_(kind) {
    if (kind == Kind::scalar) set_text({});
  }

  NodeId parent = kNoNode;
  NodeId next_sibling = kNoNode;
  Span span;  ///< the value's bytes; an empty span at its position if it is absent
  Style style = Style::plain;
  bool is_repeated = false;  ///< an earlier key in the same mapping is equal

  Kind kind() const { return kind_; }
  /// The key's bytes when the parent is a mapping.
  Span key_span() const { return {span.source, key_begin_, key_end_}; }
  /// Decoded text of the key; a view into the source or into the document.
  std::string_view key() const {
    return key_ == nullptr ? std::string_view() : std::string_view(key_, key_size_or_position_);
  }
  /// The position among the items of a sequence.
  std::uint32_t position() const { return key_ == nullptr ? key_size_or_position_ : 0; }
  /// Decoded text of a scalar that is not an alias; a view into the source or into the document.
  std::string_view text() const {
    return has_text() ? std::string_view(scalar_text, text_size_or_child_count_)
                      : std::string_view();
  }
  NodeId first_child() const { return has_text() ? kNoNode : links.first_child; }
  std::uint32_t child_count() const { return has_text() ? 0 : text_size_or_child_count_; }
  bool is_alias() const { return is_alias_; }
  /// The anchored node of an alias.
  NodeId target() const { return is_alias_ ? links.target : kNoNode; }

  /// `place` is in the source of the value.
  void set_key(std::string_view key, Span place) {
    key_ = key.data() == nullptr ? "" : key.data();
    key_size_or_position_ = static_cast<std::uint32_t>(key.size());
    key_begin_ = place.begin;
    key_end_ = place.end;
  }
  /// Items of a sequence have a position; members of a mapping have none.
  void set_position(std::uint32_t position) {
    if (key_ == nullptr) key_size_or_position_ = position;
  }
  /// Makes it a scalar.
  void set_text(std::string_view text) {
    kind_ = Kind::scalar;
    is_alias_ = false;
    scalar_text = text.data();
    text_size_or_child_count_ = static_cast<std::uint32_t>(text.size());
  }
  /// Precondition: a sequence or mapping, or null.
  void set_children(NodeId first, std::uint32_t count) {
    links.first_child = first;
    text_size_or_child_count_ = count;
  }
  /// Makes it an alias.
  void set_target(NodeId target) {
    is_alias_ = true;
    text_size_or_child_count_ = 0;
    links = {kNoNode, target};
  }

 private:
  bool has_text() const { return kind_ == Kind::scalar && !is_alias_; }

  Kind kind_;
  bool is_alias_ = false;
  std::uint32_t key_begin_ = 0;
  std::uint32_t key_end_ = 0;
  std::uint32_t key_size_or_position_ = 0;
  std::uint32_t text_size_or_child_count_ = 0;
  const char* key_ = nullptr;
  struct Links {
    NodeId first_child = kNoNode;
    NodeId target = kNoNode;
  };
  union {
    Links links = {};
    const char* scalar_text;
  };
};

class View;

/// The first document of a YAML file, its nodes in document order. Moved, never copied: texts point
/// into it and into the SourceMap.
struct Document {
  Document() = default;
  Document(Document&&) = default;
  Document& operator=(Document&&) = default;
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  SourceId source{};
  std::vector<Node> nodes;
  std::deque<std::string> decoded;  ///< texts that differ from their bytes
  NodeId root = kNoNode;

  View view() const;
};

/// The type of a plain scalar in the YAML 1.2 core schema. Quoted and block scalars are text.
enum class ScalarType : std::uint8_t { null, boolean, integer, number, text };
ScalarType classify(std::string_view text, Style style);

/// A cheap handle to a node; aliases are followed.
class View {
 public:
  View() = default;
  View(const Document& document, NodeId id) : document_(&document), id_(id) {}

  explicit operator bool() const { return document_ != nullptr && id_ != kNoNode; }
  NodeId id() const { return id_; }
  const Document& document() const { return *document_; }

  Kind kind() const { return value().kind(); }
  bool is_mapping() const { return kind() == Kind::mapping; }
  bool is_sequence() const { return kind() == Kind::sequence; }
  bool is_scalar() const { return kind() == Kind::scalar; }
  bool is_null() const { return kind() == Kind::null; }
  std::size_t size() const { return value().child_count(); }

  std::string_view text() const { return value().text(); }
  Style style() const { return value().style; }
  ScalarType type() const;
  /// The number if the scalar is plain and a number (YAML 1.2 core; infinities and NaN included).
  std::optional<double> number() const;
  std::optional<std::int64_t> integer() const;
  std::optional<bool> boolean() const;

  /// The place where this node is used: for an alias, the `*name`, not the anchored value.
  Span span() const { return node().span; }
  Span key_span() const { return node().key_span(); }
  std::string_view key() const { return node().key(); }
  /// True for a duplicate key, which the YAML reader reports; readers use the first.
  bool is_repeated() const { return node().is_repeated; }
  /// The value's span, or the key's when the value is absent.
  Span place() const {
    return node().span.empty() && !node().key_span().empty() ? node().key_span() : node().span;
  }

  /// First child with this key; the first wins in configmaps (MARS) and yaml-cpp.
  View find(std::string_view key) const;

  /// Over the children: members of a mapping, items of a sequence.
  class Iterator {
   public:
    using difference_type = std::ptrdiff_t;
    using value_type = View;
    Iterator() = default;
    Iterator(const Document* document, NodeId id) : document_(document), id_(id) {}
    View operator*() const { return View(*document_, id_); }
    Iterator& operator++();
    Iterator operator++(int);
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.id_ == b.id_; }

   private:
    const Document* document_ = nullptr;
    NodeId id_ = kNoNode;
  };
  Iterator begin() const { return {document_, value().first_child()}; }
  Iterator end() const { return {document_, kNoNode}; }

 private:
  const Node& node() const { return document_->nodes[static_cast<std::size_t>(id_)]; }
  const Node& value() const {
    const Node& own = node();
    return own.is_alias() ? document_->nodes[static_cast<std::size_t>(own.target())] : own;
  }

  const Document* document_ = nullptr;
  NodeId id_ = kNoNode;
};

inline View Document::view() const { return {*this, root}; }

/// JSON-pointer-like path of a node: "/motors/3/joint".
std::string pointer(const Document& document, NodeId id);
/// The same with names instead of positions where possible: "/motors/name=elbow/joint". It stays
/// valid when entries are added, removed or moved.
std::string named_pointer(const Document& document, NodeId id);
/// The deepest node whose key or value contains the byte.
NodeId node_at(const Document& document, std::uint32_t offset);

}  // namespace smurf::yaml
