// SPDX-License-Identifier: BSD-3-Clause
// The result as XML, in the layout of xacro, and where each part of it was written.
#include <algorithm>
#include <array>

#include "xacro/expander.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

class Writer {
 public:
  Writer(const std::vector<Piece>& pieces, std::string& text, std::vector<Leaf>* leaves)
      : pieces_(pieces), text_(text), leaves_(leaves) {}

  void run(const Node& root) {
    text_ = "<?xml version=\"1.0\" ?>\n";
    element(root, 0);
  }

 private:
  static constexpr auto kIsSpecial = [] {
    std::array<bool, 256> table{};
    for (std::size_t c = 0; c < ' '; ++c) table[c] = true;
    for (const char c : {'&', '<', '>', '"'}) table[static_cast<unsigned char>(c)] = true;
    return table;
  }();

  void escaped(std::string_view value, bool is_attribute) {
    unsigned special = 0;
    for (const char c : value) special |= kIsSpecial[static_cast<unsigned char>(c)] ? 1U : 0U;
    if (special == 0) {
      text_ += value;
      return;
    }
    for (const char c : value) {
      switch (c) {
      case '&': text_ += "&amp;"; break;
      case '<': text_ += "&lt;"; break;
      case '>': text_ += "&gt;"; break;
      case '"': text_ += "&quot;"; break;
      case '\n':
      case '\t': text_.push_back(is_attribute ? ' ' : c); break;
      case '\r': text_ += "&#13;"; break;
      default: text_.push_back(c);
      }
    }
  }

  /// A leaf that ends here.
  Leaf& leaf(Leaf::Kind kind, std::size_t begin, const Node& node) {
    Leaf& leaf = leaves_->emplace_back();
    leaf.kind = kind;
    leaf.begin = offset(begin);
    leaf.end = offset(text_.size());
    leaf.frame = node.frame;
    return leaf;
  }

  void tag_leaf(Leaf::Kind kind, std::size_t begin, const Node& node) {
    if (leaves_ == nullptr) return;
    Leaf& tag = leaf(kind, begin, node);
    tag.origin = node.name_span;
    tag.use = node.tag_span;
    tag.whole = node.span;
  }

  void piece(const Piece& piece, std::string_view value, bool is_attribute, const Node& node,
             Span whole) {
    const std::size_t begin = text_.size();
    escaped(value, is_attribute);
    if (leaves_ == nullptr) return;
    Leaf& made = leaf(is_attribute ? Leaf::Kind::value : Leaf::Kind::text, begin, node);
    made.origin = piece.origin;
    made.use = piece.use;
    made.whole = whole;
    made.first_input = piece.first_input;
    made.inputs = piece.inputs;
    // Escapes change the positions of the bytes behind them; a tab in an attribute becomes a blank.
    made.is_exact = piece.is_exact && std::string_view(text_).substr(begin) == value &&
                    piece.origin.end - piece.origin.begin == value.size();
  }

  void traced(const TracedText& text, bool is_attribute, const Node& node, Span whole) {
    if (leaves_ == nullptr) return escaped(text.value, is_attribute);
    if (text.pieces == 0) return piece(text.whole, text.value, is_attribute, node, whole);
    std::size_t at = 0;
    for (std::uint32_t i = 0; i < text.pieces; ++i) {
      const Piece& one = pieces_[text.first_piece + i];
      piece(one, text.value.substr(at, one.size), is_attribute, node, whole);
      at += one.size;
    }
  }

  void attribute(const NodeAttribute& one, const Node& node) {
    text_.push_back(' ');
    const std::size_t begin = text_.size();
    text_ += one.name;
    if (leaves_ != nullptr) {
      Leaf& name = leaf(Leaf::Kind::attribute, begin, node);
      name.origin = one.name_span;
      name.use = name.whole = one.span;
    }
    text_.append("=\"", 2);
    traced(one.text, true, node, one.span);
    text_.push_back('"');
  }

  void attributes(const Node& node) {
    if (node.attributes.size() == 1) return attribute(node.attributes[0], node);
    sorted_.clear();
    for (const NodeAttribute& one : node.attributes) sorted_.push_back(&one);
    std::sort(sorted_.begin(), sorted_.end(),
              [](const NodeAttribute* a, const NodeAttribute* b) { return a->name < b->name; });
    for (const NodeAttribute* one : sorted_) attribute(*one, node);
  }

  static bool is_blank(const Node& node) {
    return node.kind == NodeKind::text && has_only_blanks(node.text);
  }

  void blanks(std::size_t count) {
    constexpr std::string_view kBlanks = "                                ";
    for (; count > kBlanks.size(); count -= kBlanks.size()) text_ += kBlanks;
    text_ += kBlanks.substr(0, count);
  }

  void element(const Node& node, std::size_t indent) {
    blanks(indent);
    const std::size_t begin = text_.size();
    text_.push_back('<');
    text_ += node.name;
    tag_leaf(Leaf::Kind::tag, begin, node);
    attributes(node);
    if (node.children.empty()) {
      text_.append("/>\n", 3);
      return;
    }
    text_.push_back('>');
    if (node.children.size() == 1 && node.children[0]->kind == NodeKind::text) {
      content(*node.children[0], node);
    } else {
      text_.push_back('\n');
      for (const Node* child : node.children) {
        if (!is_blank(*child)) write(*child, node, indent + 2);
      }
      blanks(indent);
    }
    const std::size_t end = text_.size();
    text_.append("</", 2);
    text_ += node.name;
    text_.push_back('>');
    tag_leaf(Leaf::Kind::end_tag, end, node);
    text_.push_back('\n');
  }

  void content(const Node& text, const Node& parent) {
    traced(text.text, false, text.frame == kNoFrame ? parent : text, text.span);
  }

  void write(const Node& node, const Node& parent, std::size_t indent) {
    switch (node.kind) {
    case NodeKind::element: element(node, indent); return;
    case NodeKind::text:
      text_.append(indent, ' ');
      content(node, parent);
      text_.push_back('\n');
      return;
    case NodeKind::comment:
      text_.append(indent, ' ').append("<!--").append(node.text.value).append("-->\n");
      return;
    case NodeKind::character_data:
      text_.append("<![CDATA[").append(node.text.value).append("]]>");
      return;
    case NodeKind::instruction:
      text_.append(indent, ' ').append("<?").append(node.text.value).append("?>\n");
      return;
    }
  }

  const std::vector<Piece>& pieces_;
  std::string& text_;
  std::vector<Leaf>* leaves_;                 ///< null: not wanted
  std::vector<const NodeAttribute*> sorted_;  // of one element
};

/// About how much the result of a node needs.
struct Needs {
  std::size_t leaves = 0, bytes = 0;

  void add(const Node& node, std::size_t indent) {
    leaves += 2 + 2 * node.attributes.size();
    bytes += indent + 2 * node.name.size() + node.text.value.size() + 8;
    for (const NodeAttribute& one : node.attributes) {
      bytes += one.name.size() + one.text.value.size() + 4;
    }
    for (const Node* child : node.children) {
      if (child->kind == NodeKind::element) add(*child, indent + 2);
    }
  }
};

}  // namespace

void write_result(const Node& root, const std::vector<Piece>& pieces, std::string& text,
                  std::vector<Leaf>* leaves) {
  Needs needs;
  needs.add(root, 0);
  if (leaves != nullptr) leaves->reserve(needs.leaves);
  text.reserve(needs.bytes);
  Writer(pieces, text, leaves).run(root);
}

}  // namespace smurf::xacro
