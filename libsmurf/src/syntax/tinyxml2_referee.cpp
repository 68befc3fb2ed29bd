// SPDX-License-Identifier: BSD-3-Clause
// Both parsers visit the start tags in document order; the names are compared.
#include "syntax/tinyxml2_referee.hpp"

#include <tinyxml2.h>

#include <algorithm>

#include "base/findings/cases.hpp"
#include "syntax/xml_lenient.hpp"
#include "syntax/xml_references.hpp"

namespace smurf {
namespace {

using xml::Element;

/// Replaces our values by those of tinyxml2.
class Decoder {
 public:
  Decoder(xml::Document& document, const SourceMap& sources)
      : document_(document), sources_(sources) {}

  /// False when tinyxml2 and the scanner saw different elements.
  bool decode(const tinyxml2::XMLElement& root) {
    return element(root) && next_ == document_.elements.size();
  }

 private:
  void text(const char* decoded, xml::Text& ours) {
    if (decoded == nullptr || ours.value.empty()) {
      ours.value = {};
    } else if (ours.value != decoded && !has_wrong_reference(sources_.text(ours.span))) {
      ours.value = document_.decoded.emplace_back(decoded);
    }
  }

  // Recursion is bounded by Limits::xml_depth, which the scanner enforces.
  bool element(const tinyxml2::XMLElement& from) {
    if (next_ >= document_.elements.size()) return false;
    Element& element = document_.elements[next_++];
    if (element.name() != from.Name() || !attributes(from, element)) return false;
    if (element.text != xml::kNoText) text(from.GetText(), document_.texts[element.text]);
    for (const tinyxml2::XMLElement* child = from.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (!this->element(*child)) return false;
    }
    return true;
  }

  bool attributes(const tinyxml2::XMLElement& from, const Element& element) {
    const tinyxml2::XMLAttribute* attribute = from.FirstAttribute();
    for (std::uint32_t i = 0; i < element.attribute_count; ++i) {
      xml::Attribute& ours = document_.attributes[element.first_attribute + i];
      if (attribute == nullptr || ours.name() != attribute->Name()) return false;
      if (ours.value() != attribute->Value() &&
          !has_wrong_reference(sources_.text(ours.value_span()))) {
        ours.set_value(document_.decoded_values.emplace_back(
            xml::DecodedValue{ours.name().data(), attribute->Value()}));
      }
      attribute = attribute->Next();
    }
    return attribute == nullptr;
  }

  xml::Document& document_;
  const SourceMap& sources_;
  std::size_t next_ = 0;
};

void report_tinyxml_error(const tinyxml2::XMLDocument& parsed, const SourceMap& sources,
                          SourceId id, DiagnosticSink& sink) {
  const auto line = static_cast<std::uint32_t>(std::max(parsed.ErrorLineNum(), 1));
  const Span place = sources.line_span(id, std::min(line, sources.line_count(id)));
  report_malformed(place, std::string("tinyxml2 cannot read this line: ") + parsed.ErrorName(),
                   cases::kFault, sink);
}

}  // namespace

bool read_by_tinyxml2(xml::Document& document, const SourceMap& sources, DiagnosticSink& sink) {
  const std::string_view text = sources.text(document.source);
  tinyxml2::XMLDocument parsed;
  if (parsed.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS ||
      parsed.RootElement() == nullptr) {
    report_tinyxml_error(parsed, sources, document.source, sink);
    return false;
  }
  if (!Decoder(document, sources).decode(*parsed.RootElement())) {
    report_malformed({document.source, 0, 0}, "tinyxml2 reads a different structure", cases::kFault,
                     sink);
    return false;
  }
  return true;
}

}  // namespace smurf
