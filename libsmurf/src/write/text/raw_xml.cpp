// SPDX-License-Identifier: BSD-3-Clause
#include "write/text/raw_xml.hpp"

#include <set>

#include "base/text/edits.hpp"
#include "syntax/strict_xml.hpp"

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

}  // namespace

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
