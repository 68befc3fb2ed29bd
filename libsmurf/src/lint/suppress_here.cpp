// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "lint/suppress.hpp"

namespace smurf {
namespace {

std::uint32_t to_offset(std::size_t size) { return static_cast<std::uint32_t>(size); }

/// The end of the line, before its line end.
std::uint32_t end_of_line(std::string_view text, std::size_t at) {
  std::size_t end = std::min(text.find('\n', at), text.size());
  if (end > at && text[end - 1] == '\r') --end;
  return to_offset(end);
}

std::size_t start_of_line(std::string_view text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return before == std::string_view::npos ? 0 : before + 1;
}

/// The place for a separate line above `at`, if only "- " comes before `at` in its line.
std::optional<Edit> line_above(SourceId source, std::string_view text, std::size_t at,
                               const std::string& comment) {
  const std::size_t line = start_of_line(text, at);
  const std::string_view before = text.substr(line, at - line);
  if (before.find_first_not_of(" \t-") != std::string_view::npos) return std::nullopt;
  const std::size_t indent = std::min(before.find_first_not_of(" \t"), before.size());
  return Edit{{source, to_offset(line), to_offset(line)},
              std::string(before.substr(0, indent)) + comment + "\n"};
}

const yaml::Node* find_node(const yaml::Document& document, std::uint32_t at) {
  const yaml::NodeId id = yaml::node_at(document, at);
  return id == yaml::kNoNode ? nullptr : &document.nodes[static_cast<std::size_t>(id)];
}

/// Whether a place is between tags and outside of comments.
bool is_between_tags(const xml::Document& document, std::string_view text, std::uint32_t at) {
  for (const Span comment : document.comments) {
    if (comment.begin < at && at < comment.end) return false;
  }
  const std::string_view before = text.substr(0, at);
  const std::size_t open = before.rfind('<');
  const std::size_t close = before.rfind('>');
  return open == std::string_view::npos || (close != std::string_view::npos && open < close);
}

/// Whether the XML declaration comes after a place. A comment there would break the file for more
/// readers.
bool is_before_declaration(const xml::Document& document, std::string_view text, std::uint32_t at) {
  const std::size_t root =
      document.elements.empty() ? text.size() : document.elements[0].span.begin;
  return text.substr(0, root).find("<?xml", at) != std::string_view::npos;
}

std::string words(const Diagnostic& diagnostic) {
  return "smurf-lint: ignore[" + std::string(diagnostic.rule->id) + "]";
}

}  // namespace

std::optional<Edit> suppress_here(const Diagnostic& diagnostic, const yaml::Document& document,
                                  std::string_view text) {
  const Span span = diagnostic.span;
  const std::string comment = "# " + words(diagnostic);
  const std::uint32_t end = end_of_line(text, span.begin);
  const yaml::Node* node = find_node(document, end);
  const bool is_in_scalar =
      node != nullptr && node->kind() == yaml::Kind::scalar && node->span.contains(end);
  const bool is_block = node != nullptr && node->style == yaml::Style::block;
  if (!is_in_scalar && !is_block) return Edit{{span.source, end, end}, "  " + comment};
  node = find_node(document, span.begin);
  if (node == nullptr) return std::nullopt;
  const std::uint32_t begin = node->key_span().empty() ? node->span.begin : node->key_span().begin;
  return line_above(span.source, text, begin, comment);
}

std::optional<Edit> suppress_here(const Diagnostic& diagnostic, const xml::Document& document,
                                  std::string_view text) {
  const Span span = diagnostic.span;
  if (is_before_declaration(document, text, span.begin)) return std::nullopt;
  const std::string comment = "<!-- " + words(diagnostic) + " -->";
  const std::uint32_t end = end_of_line(text, span.begin);
  if (is_between_tags(document, text, end)) return Edit{{span.source, end, end}, " " + comment};
  const xml::ElementId element = xml::element_at(document, span.begin);
  if (element == xml::kNoElement) return std::nullopt;
  const std::uint32_t begin = document.elements[static_cast<std::size_t>(element)].span.begin;
  return line_above(span.source, text, begin, comment);
}

}  // namespace smurf
