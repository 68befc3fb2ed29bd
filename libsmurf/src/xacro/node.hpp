// SPDX-License-Identifier: BSD-3-Clause
// The trees that are expanded, and their results: as in a file, with texts and comments.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "smurf/xacro.hpp"
#include "smurf/xml.hpp"
#include "xacro/arena.hpp"
#include "xacro/value.hpp"

namespace smurf::xacro {

/// Of a place in a source, which has at most 4 GB.
constexpr std::uint32_t offset(std::size_t size) { return static_cast<std::uint32_t>(size); }

/// A part of a text, and where it was written.
struct Piece {
  std::uint32_t size = 0;
  bool is_exact = false;          ///< its bytes are those of `origin`
  Span origin;                    ///< the bytes to blame
  Span use;                       ///< in the text as it is written where it is used
  std::uint32_t first_input = 0;  ///< in Expansion::inputs
  std::uint32_t inputs = 0;
};

/// A text and its pieces; one piece unless it was computed.
struct TracedText {
  std::string_view value;
  Piece whole;                    ///< if there is only one
  std::uint32_t first_piece = 0;  ///< in the list of the expansion
  std::uint32_t pieces = 0;       ///< 0: only `whole`
  bool is_plain = false;          ///< known to have neither `$` nor `{`
  bool is_blank = false;          ///< known to be blanks and line ends only
};

bool has_only_blanks(const TracedText& text);

struct NodeAttribute {
  std::string_view name;
  Span name_span;
  Span span;  ///< with the quotes
  TracedText text;
  bool is_number = false;  ///< xacro:attribute set a value that is no text
};

enum class NodeKind : std::uint8_t { element, text, comment, character_data, instruction };

struct Node {
  explicit Node(Arena& arena)
      : attributes(ArenaAllocator<NodeAttribute>(arena)), children(ArenaAllocator<Node*>(arena)) {}

  NodeKind kind = NodeKind::element;
  FrameId frame = kNoFrame;
  std::string_view name;
  TracedText text;  ///< of other kinds
  Span name_span, tag_span, span;
  ArenaVector<NodeAttribute> attributes;
  ArenaVector<Node*> children;

  const NodeAttribute* attribute(std::string_view wanted) const {
    for (const NodeAttribute& one : attributes) {
      if (one.name == wanted) return &one;
    }
    return nullptr;
  }
};

/// The nodes of a file. Texts that contain references are decoded into `heap`.
class NodeTree {
 public:
  NodeTree(const xml::Document& document, std::string_view text, Heap& heap, Arena& nodes)
      : document_(document), text_(text), heap_(heap), nodes_(nodes) {}
  Node* read();
  /// An entity that XML does not define; empty if there is none.
  const Span& unknown_entity() const { return unknown_entity_; }

 private:
  Node* element(xml::View view);
  void content(Node& parent, std::uint32_t begin, std::uint32_t end);
  TracedText traced(std::uint32_t begin, std::uint32_t end, bool is_attribute);
  std::string decoded(std::string_view raw, bool is_attribute, std::uint32_t begin);
  void add(Node& parent, NodeKind kind, std::uint32_t begin, std::uint32_t end);

  const xml::Document& document_;
  std::string_view text_;
  Heap& heap_;
  Arena& nodes_;
  Span unknown_entity_;
};

}  // namespace smurf::xacro
