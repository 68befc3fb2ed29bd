// SPDX-License-Identifier: BSD-3-Clause
// The scanner says what stands where. Where tinyxml2 may read something else than is written, it is
// asked; both meet the start tags in document order, which is verified name by name.
#include "syntax/xml_reader.hpp"

#include <tinyxml2.h>

#include <algorithm>

#include "base/rules.hpp"
#include "base/words.hpp"
#include "syntax/text_check.hpp"
#include "syntax/xml_scanner.hpp"

namespace smurf {
namespace {

using xml::Element;

/// Puts what tinyxml2 reads in the place of what is written.
class Decoder {
 public:
  explicit Decoder(xml::Document& document) : document_(document) {}

  /// False when tinyxml2 and the scanner saw different elements.
  bool decode(const tinyxml2::XMLElement& root) {
    return element(root) && next_ == document_.elements.size();
  }

 private:
  /// A view into the source when the decoded text equals its bytes, into the document otherwise.
  void text(const char* decoded, std::string_view& written) {
    if (decoded == nullptr || written.empty()) {
      written = {};
    } else if (written != decoded) {
      written = document_.decoded.emplace_back(decoded);
    }
  }

  // Recursion is bounded by Limits::xml_depth, which the scanner enforces.
  bool element(const tinyxml2::XMLElement& from) {
    if (next_ >= document_.elements.size()) return false;
    Element& element = document_.elements[next_++];
    if (element.name() != from.Name() || !attributes(from, element)) return false;
    if (element.text != xml::kNoText) text(from.GetText(), document_.texts[element.text].value);
    for (const tinyxml2::XMLElement* child = from.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (!this->element(*child)) return false;
    }
    return true;
  }

  bool attributes(const tinyxml2::XMLElement& from, const Element& element) {
    const tinyxml2::XMLAttribute* attribute = from.FirstAttribute();
    for (std::uint32_t i = 0; i < element.attribute_count; ++i) {
      xml::Attribute& written = document_.attributes[element.first_attribute + i];
      if (attribute == nullptr || written.name() != attribute->Name()) return false;
      if (written.value() != attribute->Value()) {
        written.set_value(document_.decoded_values.emplace_back(
            xml::DecodedValue{written.name().data(), attribute->Value()}));
      }
      attribute = attribute->Next();
    }
    return attribute == nullptr;
  }

  xml::Document& document_;
  std::size_t next_ = 0;
};

void report_tinyxml_error(const tinyxml2::XMLDocument& parsed, const SourceMap& sources,
                          SourceId id, DiagnosticSink& sink) {
  const auto line = static_cast<std::uint32_t>(std::max(parsed.ErrorLineNum(), 1));
  const Span place = sources.line_span(id, std::min(line, sources.line_count(id)));
  sink.report(rules::sml1001_xml_malformed, place,
              std::string("tinyxml2 cannot read this line: ") + parsed.ErrorName());
}

/// False when tinyxml2 refuses the file, which is reported.
bool decode_by_tinyxml2(xml::Document& document, const SourceMap& sources, DiagnosticSink& sink) {
  const std::string_view text = sources.text(document.source);
  tinyxml2::XMLDocument parsed;
  if (parsed.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS ||
      parsed.RootElement() == nullptr) {
    report_tinyxml_error(parsed, sources, document.source, sink);
    return false;
  }
  if (!Decoder(document).decode(*parsed.RootElement())) {
    sink.report(rules::sml1001_xml_malformed, {document.source, 0, 0},
                "tinyxml2 reads another structure than is written");
    return false;
  }
  return true;
}

}  // namespace

std::optional<xml::Document> parse_xml_by(XmlEngine engine, const SourceMap& sources, SourceId id,
                                          const Limits& limits, DiagnosticSink& sink) {
  const std::string_view text = sources.text(id);
  constexpr std::string_view kLfsPointer = "version https://git-lfs";
  if (text.starts_with(kLfsPointer) || trimmed(text).empty()) {
    Diagnostic& diagnostic =
        sink.report(rules::sml1010_lfs_pointer, {id, 0, 0},
                    text.starts_with(kLfsPointer) ? "the file is a Git LFS pointer, not XML"
                                                  : "the file is empty");
    if (text.starts_with(kLfsPointer)) diagnostic.help = "run `git lfs pull`";
    return std::nullopt;
  }
  if (!check_text(sources, id, TextFormat::xml, sink)) return std::nullopt;
  ScannedXml scanned = scan_xml(sources, id, limits, sink);
  if (!scanned.well_formed) return std::nullopt;
  const bool is_read = engine == XmlEngine::scanner_first && scanned.is_plain;
  if (!is_read && !decode_by_tinyxml2(scanned.document, sources, sink)) return std::nullopt;
  return std::move(scanned.document);
}

std::optional<xml::Document> parse_xml(const SourceMap& sources, SourceId id, const Limits& limits,
                                       DiagnosticSink& sink) {
#ifdef SMURF_SCANNERS
  return parse_xml_by(XmlEngine::scanner_first, sources, id, limits, sink);
#else
  return parse_xml_by(XmlEngine::tinyxml2, sources, id, limits, sink);
#endif
}

}  // namespace smurf
