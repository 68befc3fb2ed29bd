// SPDX-License-Identifier: BSD-3-Clause
// Edits of elements and attributes of an XML text, in the layout of what is there.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Collects the edits of one document. An attribute or element is edited at most once.
class XmlEdits {
 public:
  XmlEdits(const xml::Document& document, std::string_view text)
      : document_(document), text_(text) {}

  /// Sets the value, which is escaped; adds the attribute when the element has none.
  void set_attribute(xml::View element, std::string_view name, std::string_view value);
  /// The same for a number; a value that is the number already keeps its digits.
  void set_number(xml::View element, std::string_view name, double value);
  /// Adds elements, as text, as the last children; a line each. Several calls for one element keep
  /// their order.
  void add_child(xml::View element, std::string_view child);
  /// Takes an element away, with its line when it stands there alone.
  void remove(xml::View element) { remove(element.span()); }
  void remove(Span span);
  /// Puts other elements, as text, in the place of one.
  void replace_element(xml::View element, std::string_view text);
  void replace(Span span, std::string text) { edits_.push_back({span, std::move(text)}); }

  xml::View view(xml::ElementId id) const { return {document_, id}; }
  bool empty() const { return edits_.empty() && children_.empty(); }
  std::string apply() const;

 private:
  /// Blanks before the element on its line.
  std::string_view indentation(Span span) const;
  std::string_view line_end() const;
  /// The lines of a text, all but the first one indented.
  std::string indented(std::string_view text, std::string_view indentation) const;
  void close(xml::View element, std::string_view children, std::vector<Edit>& edits) const;

  const xml::Document& document_;
  std::string_view text_;
  std::vector<Edit> edits_;
  std::map<xml::ElementId, std::string> children_;  ///< new ones, by parent
};

}  // namespace smurf
