// SPDX-License-Identifier: BSD-3-Clause
#include "xacro/node.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "base/text/utf8.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

/// Appends what a reference such as "lt" or "#x41" means; false if it is unknown.
bool append_reference(std::string& text, std::string_view name) {
  struct Entity {
    std::string_view name;
    char character;
  };
  constexpr Entity kEntities[] = {
      {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
  for (const Entity& row : kEntities) {
    if (row.name != name) continue;
    text.push_back(row.character);
    return true;
  }
  if (!name.starts_with('#')) return false;
  const bool is_hex = name.substr(1).starts_with('x');
  const std::string_view digits = name.substr(is_hex ? 2 : 1);
  std::uint32_t code = 0;
  const auto result =
      std::from_chars(digits.data(), digits.data() + digits.size(), code, is_hex ? 16 : 10);
  constexpr std::uint32_t kLast = 0x10FFFF;
  if (result.ec != std::errc{} || code == 0 || code > kLast || (code >= 0xD800 && code < 0xE000))
    return false;
  utf8::append(text, code);
  return true;
}

/// What the characters of a text mean for it.
constexpr unsigned kDecoded = 1;  ///< it is not the text that is meant
constexpr unsigned kLine = 2;     ///< a line end or a tab
constexpr unsigned kCode = 4;     ///< it may have an expression
constexpr unsigned kOther = 8;    ///< it is no blank
constexpr auto kMarks = [] {
  std::array<std::uint8_t, 256> marks{};
  marks.fill(kOther);
  marks['&'] = kDecoded | kOther;
  marks['\r'] = kDecoded;
  marks['\n'] = marks['\t'] = kLine;
  marks['$'] = marks['{'] = kCode | kOther;
  marks[' '] = 0;
  return marks;
}();

}  // namespace

bool has_only_blanks(const TracedText& text) {
  return text.is_blank || without_blanks(text.value).empty();
}

Node* NodeTree::read() {
  // Parents come before their children, so the children's lists are complete at the end.
  return element(document_.view());
}

std::string NodeTree::decoded(std::string_view raw, bool is_attribute, std::uint32_t begin) {
  std::string text;
  text.reserve(raw.size());
  for (std::size_t at = 0; at < raw.size(); ++at) {
    const char c = raw[at];
    if (c == '\r') {
      if (at + 1 < raw.size() && raw[at + 1] == '\n') ++at;
      text.push_back(is_attribute ? ' ' : '\n');
    } else if (is_attribute && (c == '\n' || c == '\t')) {
      text.push_back(' ');
    } else if (c == '&') {
      const std::size_t end = std::min(raw.find(';', at), raw.size());
      if (!append_reference(text, raw.substr(at + 1, end - at - 1)) && unknown_entity_.empty()) {
        unknown_entity_ = {document_.source, offset(begin + at),
                           offset(begin + std::min(end + 1, raw.size()))};
      }
      at = end;
    } else {
      text.push_back(c);
    }
  }
  return text;
}

TracedText NodeTree::traced(std::uint32_t begin, std::uint32_t end, bool is_attribute) {
  TracedText result;
  const std::string_view raw = text_.substr(begin, end - begin);
  unsigned marks = 0;
  for (const char c : raw) marks |= kMarks[static_cast<unsigned char>(c)];
  const bool is_exact = (marks & (is_attribute ? kDecoded | kLine : kDecoded)) == 0;
  result.value = is_exact ? raw : heap_.keep(decoded(raw, is_attribute, begin));
  result.whole.size = offset(result.value.size());
  result.whole.is_exact = is_exact;
  result.is_plain = is_exact && (marks & kCode) == 0;
  result.is_blank = is_exact && (marks & kOther) == 0;
  result.whole.origin = result.whole.use = {document_.source, begin, end};
  return result;
}

void NodeTree::add(Node& parent, NodeKind kind, std::uint32_t begin, std::uint32_t end) {
  Node& node = nodes_.make<Node>(nodes_);
  node.kind = kind;
  node.span = node.tag_span = node.name_span = {document_.source, begin, end};
  std::uint32_t inner_begin = begin;
  std::uint32_t inner_end = end;
  switch (kind) {
  case NodeKind::comment: inner_begin += 4, inner_end -= 3; break;
  case NodeKind::character_data: inner_begin += 9, inner_end -= 3; break;
  case NodeKind::instruction: inner_begin += 2, inner_end -= 2; break;
  default: break;
  }
  if (kind == NodeKind::text) {
    node.text = traced(inner_begin, inner_end, false);
  } else {
    node.text.value = text_.substr(inner_begin, inner_end - inner_begin);
    node.text.whole = {
        offset(node.text.value.size()), true, {document_.source, inner_begin, inner_end}, {}, 0, 0};
    node.text.whole.use = node.text.whole.origin;
  }
  parent.children.push_back(&node);
}

void NodeTree::content(Node& parent, std::uint32_t begin, std::uint32_t end) {
  const auto close = [&](std::string_view mark, std::uint32_t from) {
    const std::size_t found = text_.find(mark, from);
    return found == std::string_view::npos || found + mark.size() > end
               ? end
               : offset(found + mark.size());
  };
  while (begin < end) {
    const std::string_view rest = text_.substr(begin, end - begin);
    if (rest.starts_with("<!--")) {
      const std::uint32_t stop = close("-->", begin + 4);
      add(parent, NodeKind::comment, begin, stop);
      begin = stop;
    } else if (rest.starts_with("<![CDATA[")) {
      const std::uint32_t stop = close("]]>", begin + 9);
      add(parent, NodeKind::character_data, begin, stop);
      begin = stop;
    } else if (rest.starts_with("<?")) {
      const std::uint32_t stop = close("?>", begin + 2);
      add(parent, NodeKind::instruction, begin, stop);
      begin = stop;
    } else {
      const std::uint32_t stop =
          std::min(end, offset(std::min(text_.find('<', begin + 1), text_.size())));
      add(parent, NodeKind::text, begin, stop);
      begin = stop;
    }
  }
}

Node* NodeTree::element(xml::View view) {
  Node& node = nodes_.make<Node>(nodes_);
  node.name = view.name();
  node.span = view.span();
  node.tag_span = view.tag_span();
  node.name_span = view.name_span();
  node.attributes.reserve(view.attributes().size());
  for (const xml::Attribute& one : view.attributes()) {
    NodeAttribute& attribute = node.attributes.emplace_back();
    attribute.name = one.name();
    attribute.name_span = one.name_span();
    attribute.span = one.span();
    attribute.text = traced(one.value_span().begin, one.value_span().end, true);
  }
  if (node.span.end == node.tag_span.end) return &node;  // <a/>
  std::size_t count = 0;
  for (auto child = view.begin(); child != view.end(); ++child) ++count;
  node.children.reserve(2 * count + 1);  // with the texts between them
  std::uint32_t at = node.tag_span.end;
  for (const xml::View child : view) {
    content(node, at, child.span().begin);
    node.children.push_back(element(child));
    at = child.span().end;
  }
  const std::size_t end_tag = text_.rfind("</", node.span.end - 1);
  content(node, at, std::max(at, offset(end_tag)));
  return &node;
}

}  // namespace smurf::xacro
