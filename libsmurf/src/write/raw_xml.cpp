// SPDX-License-Identifier: BSD-3-Clause
#include "write/raw_xml.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/edits.hpp"
#include "syntax/xml_references.hpp"

namespace smurf {
namespace {

constexpr std::string_view kDeclaration = "xmlns:";

/// Whether an element or attribute at or below `top` has a name that begins with this prefix.
bool uses(xml::View top, std::string_view prefix) {
  const std::vector<xml::Element>& elements = top.document().elements;
  for (std::size_t i = static_cast<std::size_t>(top.id());
       i < elements.size() && elements[i].span.begin < top.span().end; ++i) {
    const xml::View view(top.document(), xml::ElementId{static_cast<std::uint32_t>(i)});
    if (view.name().starts_with(prefix)) return true;
    for (const xml::Attribute& attribute : view.attributes()) {
      if (attribute.name().starts_with(prefix)) return true;
    }
  }
  return false;
}

void declare(xml::View element, const xml::Attribute& declaration, std::vector<Edit>& edits) {
  const std::string prefix(declaration.name().substr(kDeclaration.size()));
  if (element.attribute(declaration.name()) != nullptr || !uses(element, prefix + ":")) return;
  const Span name = element.name_span();
  edits.push_back(
      {{name.source, name.end, name.end},
       " " + std::string(declaration.name()) + "=\"" + escape_xml(declaration.value()) + "\""});
}

/// U+FFFE and U+FFFF become U+FFFD.
std::string with_characters_of_xml(std::string_view text) {
  std::string result(text);
  for (std::size_t at = result.find("\xEF\xBF"); at != result.npos;
       at = result.find("\xEF\xBF", at + 1)) {
    char& last = result[std::min(at + 2, result.size() - 1)];
    if (last == '\xBE' || last == '\xBF') last = '\xBD';
  }
  return result;
}

/// Bytes of a comment or CDATA section, in which `&` is not a reference; 0 for anything else.
std::size_t unread_part(std::string_view text) {
  for (const auto& [begin, end] : {std::pair("<!--", "-->"), std::pair("<![CDATA[", "]]>")}) {
    if (!text.starts_with(begin)) continue;
    const std::size_t found = text.find(end, std::string_view(begin).size());
    return found == text.npos ? text.size() : found + std::string_view(end).size();
  }
  return 0;
}

}  // namespace

std::string strict_xml(std::string_view text) {
  constexpr std::string_view kEnd = "]]>";  // of a CDATA section
  const std::string whole = with_characters_of_xml(text);
  std::string_view rest = whole;
  std::string result;
  result.reserve(whole.size());
  while (!rest.empty()) {
    const std::size_t plain = std::min(rest.find_first_of("<&]"), rest.size());
    result += rest.substr(0, plain);
    rest.remove_prefix(plain);
    std::size_t size = std::min<std::size_t>(1, rest.size());
    if (const std::size_t unread = unread_part(rest); unread > 0) {
      size = unread;
      result += rest.substr(0, size);
    } else if (rest.starts_with(kEnd)) {
      size = kEnd.size();
      result += "]]&gt;";
    } else if (rest.starts_with('&') &&
               read_reference(rest).kind != XmlReference::Kind::character) {
      result += "&amp;";
    } else {
      result += rest.substr(0, size);
    }
    rest.remove_prefix(size);
  }
  return result;
}

void declare_prefix(xml::View robot, const xml::Attribute& declaration, std::vector<Edit>& edits) {
  for (const xml::View child : robot) declare(child, declaration, edits);
}

std::string raw_xml(xml::View element, std::string_view source, std::vector<Edit> edits) {
  std::set<std::string_view> declared;  // the nearest declaration applies
  for (xml::View at = element.parent(); at; at = at.parent()) {
    for (const xml::Attribute& each : at.attributes()) {
      const bool is_such = each.name().starts_with(kDeclaration);
      if (is_such && declared.insert(each.name()).second) declare(element, each, edits);
    }
  }
  const Span span = element.span();
  for (Edit& edit : edits) {
    edit.span.begin -= span.begin;
    edit.span.end -= span.begin;
  }
  return strict_xml(apply_edits(source.substr(span.begin, span.end - span.begin), edits));
}

}  // namespace smurf
