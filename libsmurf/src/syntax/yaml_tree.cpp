// SPDX-License-Identifier: BSD-3-Clause
// Reading a yaml::Document.
#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "smurf/yaml.hpp"

namespace smurf::yaml {
namespace {

/// Hexadecimal and octal integers of the core schema: 0x1F, 0o17.
std::optional<std::int64_t> parse_radix(std::string_view text) {
  const int base = text.starts_with("0x") ? 16 : text.starts_with("0o") ? 8 : 0;
  if (base == 0 || text.size() < 3) return std::nullopt;
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data() + 2, end, value, base);
  if (result.ec != std::errc() || result.ptr != end || text[2] == '-') return std::nullopt;
  return value;
}

bool looks_numeric(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; }

}  // namespace

ScalarType classify(std::string_view text, Style style) {
  if (style != Style::plain) return ScalarType::text;
  if (text.empty()) return ScalarType::null;
  if (!looks_numeric(text.front())) {
    if (is_one_of(text, {"~", "null", "Null", "NULL"})) return ScalarType::null;
    const bool is_boolean = is_one_of(text, {"true", "True", "TRUE", "false", "False", "FALSE"});
    return is_boolean ? ScalarType::boolean : ScalarType::text;
  }
  if (parse_integer(text) || parse_radix(text)) return ScalarType::integer;
  if (parse_number(text)) return ScalarType::number;
  std::string_view unsigned_text = text;
  if (text.front() == '+' || text.front() == '-') unsigned_text.remove_prefix(1);
  if (is_one_of(unsigned_text, {".inf", ".Inf", ".INF"}) ||
      is_one_of(text, {".nan", ".NaN", ".NAN"})) {
    return ScalarType::number;
  }
  return ScalarType::text;
}

ScalarType View::type() const {
  const Node& own = value();
  return own.kind() == Kind::scalar ? classify(own.text(), own.style) : ScalarType::null;
}

std::optional<double> View::number() const {
  const Node& own = value();
  if (own.kind() != Kind::scalar || own.style != Style::plain || own.text().empty())
    return std::nullopt;
  if (!looks_numeric(own.text().front())) return std::nullopt;
  if (const auto number = parse_number(own.text())) return number;
  switch (classify(own.text(), own.style)) {
  case ScalarType::integer:
    if (const auto radix = parse_radix(own.text())) return static_cast<double>(*radix);
    return std::nullopt;
  case ScalarType::number:
    if (own.text().back() == 'n' || own.text().back() == 'N') {
      return std::numeric_limits<double>::quiet_NaN();
    }
    return own.text().front() == '-' ? -std::numeric_limits<double>::infinity()
                                     : std::numeric_limits<double>::infinity();
  default: return std::nullopt;
  }
}

std::optional<std::int64_t> View::integer() const {
  const Node& own = value();
  if (own.kind() != Kind::scalar || own.style != Style::plain) return std::nullopt;
  if (const auto radix = parse_radix(own.text())) return radix;
  return parse_integer(own.text());
}

std::optional<bool> View::boolean() const {
  const Node& own = value();
  if (own.kind() != Kind::scalar || classify(own.text(), own.style) != ScalarType::boolean) {
    return std::nullopt;
  }
  return own.text().front() == 't' || own.text().front() == 'T';
}

View View::find(std::string_view key) const {
  if (!*this || !is_mapping()) return {};
  for (NodeId id = value().first_child(); id != kNoNode;) {
    const Node& child = document_->nodes[static_cast<std::size_t>(id)];
    if (is_same(child.key(), key)) return {*document_, id};
    id = child.next_sibling;
  }
  return {};
}

View::Iterator& View::Iterator::operator++() {
  id_ = document_->nodes[static_cast<std::size_t>(id_)].next_sibling;
  return *this;
}

View::Iterator View::Iterator::operator++(int) {
  Iterator old = *this;
  ++*this;
  return old;
}

namespace {

/// Escapes a step as in JSON pointers.
std::string escape_step(std::string_view text) {
  std::string step;
  step.reserve(text.size());
  for (const char c : text) {
    switch (c) {
    case '~': step += "~0"; break;
    case '/': step += "~1"; break;
    default: step += c;
    }
  }
  return step;
}

/// "name=elbow" for an item of a sequence that has a name.
std::optional<std::string> name_step(const Document& document, NodeId id) {
  const View item(document, id);
  constexpr std::size_t kMostKeys = 1000;  // keys searched per finding
  if (!item.is_mapping() || item.size() > kMostKeys) return std::nullopt;
  const View name = item.find("name");
  constexpr std::size_t kMost = 200;  // bytes; longer texts are not names
  if (!name || !name.is_scalar() || name.text().size() > kMost) return std::nullopt;
  return "name=" + escape_step(name.text());
}

/// Every finding has pointers, so long keys in them would be kept ten thousand times.
constexpr std::size_t kLongestStep = 200;
constexpr std::size_t kLongestPointer = 2000;

/// The last steps of a pointer that is too long.
std::string path_to(const Document& document, NodeId id, bool by_name) {
  std::vector<std::string> steps;
  std::size_t length = 0;
  while (id != kNoNode && id != document.root) {
    const Node& node = document.nodes[static_cast<std::size_t>(id)];
    if (node.parent == kNoNode) break;
    const Node& parent = document.nodes[static_cast<std::size_t>(node.parent)];
    if (parent.kind() == Kind::mapping) {
      steps.push_back(escape_step(shortened(node.key(), kLongestStep)));
    } else {
      const auto name = by_name ? name_step(document, id) : std::nullopt;
      steps.push_back(name ? *name : std::to_string(node.position()));
    }
    length += steps.back().size() + 1;
    if (length > kLongestPointer) {
      steps.emplace_back("...");
      break;
    }
    id = node.parent;
  }
  std::string result;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) result += "/" + *step;
  return result;
}

}  // namespace

std::string pointer(const Document& document, NodeId id) { return path_to(document, id, false); }

std::string named_pointer(const Document& document, NodeId id) {
  return path_to(document, id, true);
}

NodeId node_at(const Document& document, std::uint32_t offset) {
  const auto at = [&](NodeId id) -> const Node& {
    return document.nodes[static_cast<std::size_t>(id)];
  };
  const auto begin_of = [](const Node& node) {
    return node.key_span().empty() ? node.span.begin
                                   : std::min(node.key_span().begin, node.span.begin);
  };
  // Nodes are in document order, so it is the last one that begins before the byte, or one of its
  // parents.
  const auto after =
      std::partition_point(document.nodes.begin(), document.nodes.end(),
                           [&](const Node& node) { return begin_of(node) <= offset; });
  for (auto last = after; last != document.nodes.begin();) {
    NodeId id{static_cast<std::uint32_t>(--last - document.nodes.begin())};
    while (id != document.root && at(id).parent != kNoNode) {
      if (at(id).span.contains(offset) || at(id).key_span().contains(offset)) return id;
      id = at(id).parent;
    }
    if (id == document.root) return id;
    // A key with an anchor or a collection: its nodes, which follow it, are not in the tree.
    last = document.nodes.begin() + static_cast<std::ptrdiff_t>(id);
  }
  return kNoNode;
}

}  // namespace smurf::yaml
