// SPDX-License-Identifier: BSD-3-Clause
// tinyxml2 reads names, values and nesting; the scanner says where they stand. Both meet the start
// tags in document order, which is verified name by name.
#include "syntax/xml_reader.hpp"

#include <tinyxml2.h>

#include <algorithm>

#include "base/rules.hpp"
#include "syntax/text_check.hpp"
#include "syntax/xml_scanner.hpp"

namespace smurf {
namespace {

using xml::Element;
using xml::ElementId;
using xml::kNoElement;

class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, const XmlIndex& index, xml::Document& document)
      : text_(text), index_(index), document_(document) {}

  /// False when tinyxml2 and the scanner saw different elements.
  bool build(const tinyxml2::XMLElement& root) {
    document_.elements.reserve(index_.elements.size());
    document_.attributes.reserve(index_.attributes.size());
    return add(root, kNoElement) != kNoElement &&
           document_.elements.size() == index_.elements.size();
  }

 private:
  std::string_view slice(Span span) const {
    return text_.substr(span.begin, span.end - span.begin);
  }

  /// A view into the source when the decoded text equals its bytes, into the document otherwise.
  std::string_view keep(const char* decoded, Span span) {
    if (slice(span) == decoded) return slice(span);
    return document_.decoded.emplace_back(decoded);
  }

  // Recursion is bounded by Limits::xml_depth, which the scanner enforces.
  ElementId add(const tinyxml2::XMLElement& from, ElementId parent) {
    const std::size_t number = document_.elements.size();
    if (number >= index_.elements.size()) return kNoElement;
    const ScannedElement& place = index_.elements[number];
    if (slice(place.name_span) != from.Name()) return kNoElement;
    const ElementId id{static_cast<std::uint32_t>(number)};
    Element element;
    element.name = slice(place.name_span);
    element.span = place.span;
    element.tag_span = place.tag_span;
    element.name_span = place.name_span;
    element.parent = parent;
    element.first_attribute = static_cast<std::uint32_t>(document_.attributes.size());
    element.attribute_count = place.attribute_count;
    if (!add_attributes(from, place)) return kNoElement;
    element.text_span = place.visible_text;
    if (const char* text = from.GetText(); text != nullptr && !place.text_span.empty()) {
      element.text = keep(text, place.text_span);
    }
    document_.elements.push_back(element);
    return add_children(from, id) ? id : kNoElement;
  }

  bool add_attributes(const tinyxml2::XMLElement& from, const ScannedElement& place) {
    const tinyxml2::XMLAttribute* attribute = from.FirstAttribute();
    for (std::uint32_t i = 0; i < place.attribute_count; ++i) {
      const ScannedAttribute& scanned = index_.attributes[place.first_attribute + i];
      if (attribute == nullptr || slice(scanned.name_span) != attribute->Name()) return false;
      document_.attributes.push_back({slice(scanned.name_span),
                                      keep(attribute->Value(), scanned.value_span),
                                      scanned.name_span, scanned.value_span, scanned.span});
      attribute = attribute->Next();
    }
    return attribute == nullptr;
  }

  bool add_children(const tinyxml2::XMLElement& from, ElementId id) {
    ElementId previous = kNoElement;
    for (const tinyxml2::XMLElement* child = from.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const ElementId added = add(*child, id);
      if (added == kNoElement) return false;
      if (previous == kNoElement) {
        document_.elements[static_cast<std::size_t>(id)].first_child = added;
      } else {
        document_.elements[static_cast<std::size_t>(previous)].next_sibling = added;
      }
      previous = added;
    }
    return true;
  }

  std::string_view text_;
  const XmlIndex& index_;
  xml::Document& document_;
};

void report_tinyxml_error(const tinyxml2::XMLDocument& parsed, const SourceMap& sources,
                          SourceId id, DiagnosticSink& sink) {
  const auto line = static_cast<std::uint32_t>(std::max(parsed.ErrorLineNum(), 1));
  const Span place = sources.line_span(id, std::min(line, sources.line_count(id)));
  sink.report(rules::sml1001_xml_malformed, place,
              std::string("tinyxml2 cannot read this line: ") + parsed.ErrorName());
}

}  // namespace

std::optional<xml::Document> parse_xml(const SourceMap& sources, SourceId id, const Limits& limits,
                                       DiagnosticSink& sink) {
  const std::string_view text = sources.text(id);
  constexpr std::string_view kLfsPointer = "version https://git-lfs";
  if (text.starts_with(kLfsPointer) ||
      text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    Diagnostic& diagnostic =
        sink.report(rules::sml1010_lfs_pointer, {id, 0, 0},
                    text.starts_with(kLfsPointer) ? "the file is a Git LFS pointer, not XML"
                                                  : "the file is empty");
    if (text.starts_with(kLfsPointer)) diagnostic.help = "run `git lfs pull`";
    return std::nullopt;
  }
  if (!check_text(sources, id, TextFormat::xml, sink)) return std::nullopt;
  const XmlIndex index = scan_xml(sources, id, limits, sink);
  if (!index.well_formed) return std::nullopt;

  tinyxml2::XMLDocument parsed;
  if (parsed.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS ||
      parsed.RootElement() == nullptr) {
    report_tinyxml_error(parsed, sources, id, sink);
    return std::nullopt;
  }
  xml::Document document;
  document.source = id;
  document.root = ElementId{0};
  document.comments = index.comments;
  if (!TreeBuilder(text, index, document).build(*parsed.RootElement())) {
    sink.report(rules::sml1001_xml_malformed, {id, 0, 0},
                "tinyxml2 reads another structure than is written");
    return std::nullopt;
  }
  return document;
}

}  // namespace smurf
