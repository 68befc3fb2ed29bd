// SPDX-License-Identifier: BSD-3-Clause
// A position index over the bytes of an XML file, and the strictness that tinyxml2 lacks.
#pragma once

#include <cstdint>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/limits.hpp"

namespace smurf {

struct ScannedAttribute {
  Span span;
  Span name_span;
  Span value_span;
};

struct ScannedElement {
  Span span;  ///< from '<' to the end of the end tag
  Span tag_span;
  Span name_span;
  Span text_span;     ///< the first piece of text that is not blank; empty when there is none
  Span visible_text;  ///< the same without blanks around it
  std::uint32_t first_attribute = 0;
  std::uint32_t attribute_count = 0;
};

/// Start tags in document order, as tinyxml2 meets them.
struct XmlIndex {
  std::vector<ScannedElement> elements;
  std::vector<ScannedAttribute> attributes;
  std::vector<Span> comments;
  bool well_formed = true;  ///< false: the structure is broken and was reported
};

/// Reports SML1001-SML1013. Stops at the first structural error.
XmlIndex scan_xml(const SourceMap& sources, SourceId id, const Limits& limits,
                  DiagnosticSink& sink);

}  // namespace smurf
