// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/xml_builder.hpp"

#include <algorithm>

#include "base/text/count.hpp"
#include "base/text/words.hpp"
#include "syntax/xml_references.hpp"

namespace smurf {

using xml::Attribute;
using xml::Element;
using xml::ElementId;
using xml::kNoElement;

XmlBuilder::XmlBuilder(std::string_view text, SourceId id) : text_(text) {
  document_.source = id;
  // A growing array temporarily needs up to three times its size. Only a hostile file has more than
  // one element in 16 bytes.
  document_.elements.reserve(
      std::min(count_of(text_, '<') - count_of(text_, '<', '/'), text_.size() / 16 + 1));
  document_.attributes.reserve(std::min(count_of(text_, '='), text_.size() / 16 + 1));
}

xml::Document XmlBuilder::take() {
  if (elements_of_root_ > 0) {
    const auto first = document_.elements.begin() + static_cast<std::ptrdiff_t>(elements_of_root_);
    document_.elements.erase(first, document_.elements.end());
  }
  return std::move(document_);
}

bool XmlBuilder::end_root() {
  if (elements_of_root_ > 0) return true;
  elements_of_root_ = document_.elements.size();
  return false;
}

const Element& XmlBuilder::innermost() const {
  return document_.elements[static_cast<std::size_t>(open_.back().element)];
}

void XmlBuilder::open(Element element) {
  const ElementId id{static_cast<std::uint32_t>(document_.elements.size())};
  if (open_.empty()) {
    if (document_.root == kNoElement) document_.root = id;
  } else {
    OpenElement& parent = open_.back();
    element.parent = parent.element;
    if (parent.last_child != kNoElement) at(parent.last_child).next_sibling = id;
    parent.last_child = id;
  }
  element.attribute_count =
      static_cast<std::uint32_t>(document_.attributes.size()) - element.first_attribute;
  document_.elements.push_back(element);
  open_.push_back({.element = id});
}

void XmlBuilder::close(std::uint32_t end) {
  at(open_.back().element).span.end = end;
  open_.pop_back();
}

void XmlBuilder::add_coded_attribute(Attribute attribute) {
  std::string decoded = decode_xml(attribute.value());
  if (decoded != attribute.value()) {
    attribute.set_value(document_.decoded_values.emplace_back(
        xml::DecodedValue{attribute.name().data(), std::move(decoded)}));
  }
  add_attribute(attribute);
}

void XmlBuilder::add_text(Span text) {
  if (take_text(text, false)) decode_text(decode_xml);
}

void XmlBuilder::add_character_section(Span text) {
  if (take_text(text, true)) decode_text(decode_character_section);
}

bool XmlBuilder::take_text(Span text, bool is_section) {
  OpenElement& open = open_.back();
  const std::string_view written = text_.substr(text.begin, text.end - text.begin);
  const std::string_view visible = trimmed(written);
  if (open.has_text || (visible.empty() && !is_section)) return false;
  open.has_text = true;
  if (visible.empty()) return false;
  const auto begin = static_cast<std::uint32_t>(visible.data() - text_.data());
  at(open.element).text = static_cast<std::uint32_t>(document_.texts.size());
  const bool is_first = open.last_child == kNoElement && !open.has_declaration;
  document_.texts.push_back(
      {is_first ? written : std::string_view(),
       {text.source, begin, begin + static_cast<std::uint32_t>(visible.size())}});
  return true;
}

void XmlBuilder::decode_text(std::string (*decode)(std::string_view)) {
  std::string_view& text = document_.texts.back().value;
  // find_first_of() would call a function for each byte of a mesh.
  constexpr auto kNone = std::string_view::npos;
  if (text.find('&') == kNone && text.find('\r') == kNone) return;
  std::string decoded = decode(text);
  if (decoded != text) text = document_.decoded.emplace_back(std::move(decoded));
}

const Element* XmlBuilder::suspect() const {
  const std::vector<Element>& elements = document_.elements;
  for (std::size_t i = static_cast<std::size_t>(open_.back().element) + 1; i < elements.size();
       ++i) {
    const Element& inner = elements[i];
    if (inner.name() == innermost().name()) return &inner;
    while (i + 1 < elements.size() && elements[i + 1].span.begin < inner.span.end) {
      ++i;  // text in a closed child
    }
  }
  return nullptr;
}

}  // namespace smurf
