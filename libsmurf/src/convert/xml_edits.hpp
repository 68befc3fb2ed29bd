// SPDX-License-Identifier: BSD-3-Clause
// Edits elements and attributes of an XML text, keeping its layout.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/pose.hpp"
#include "smurf/urdf.hpp"
#include "smurf/xml.hpp"

namespace smurf {

using Attributes = std::vector<std::pair<std::string_view, std::string>>;
/// <name a="..."/>, with escaped values.
std::string new_element(std::string_view name, const Attributes& attributes);
/// "1 0 0.5".
std::string numbers_text(const Vector3& vector);
/// The attributes of an <origin> element with this pose.
Attributes origin_attributes(const Pose& pose);

/// Collects the edits of one document. An attribute or element is edited at most once.
class XmlEdits {
 public:
  XmlEdits(const xml::Document& document, std::string_view text);

  /// Sets the value, which is escaped; adds the attribute when the element has none.
  void set_attribute(xml::View element, std::string_view name, std::string_view value);
  /// The same for a number; if the number is unchanged, its digits are kept.
  void set_number(xml::View element, std::string_view name, double value);
  /// Adds elements, given as text, as the last children, one per line. Several calls for one
  /// element keep their order.
  void add_child(xml::View element, std::string_view child);
  /// Removes an element, with its line if nothing else is on it.
  void remove(xml::View element) { remove(element.span()); }
  void remove(Span span);
  /// Removes an attribute with the spaces before it.
  void remove(const xml::Attribute& attribute);
  /// Replaces an element by other elements, given as text.
  void replace_element(xml::View element, std::string_view text);
  void replace(Span span, std::string text) { edits_.push_back({span, std::move(text)}); }

  /// Sets the pose of an element; adds an <origin> if there is none.
  Edit origin_edit(xml::View element, const urdf::Origin& origin, const Pose& pose) const;
  /// The element's text after `changes`, for add_child().
  std::string copy(xml::View element, std::vector<Edit> changes) const;

  xml::View view(xml::ElementId id) const { return {document_, id}; }
  bool empty() const { return edits_.empty() && children_.empty(); }
  std::string apply() const;

 private:
  /// Spaces before the element on its line, limited to a few dozen.
  std::string_view indentation(Span span) const;
  /// Indents the lines of a text, except for the first one and empty lines.
  std::string indented(std::string_view text, std::string_view indentation) const;
  void close(xml::View element, std::string_view children, std::vector<Edit>& edits) const;

  const xml::Document& document_;
  std::string_view text_;
  std::string_view line_end_;  ///< of the first line
  std::vector<Edit> edits_;
  std::map<xml::ElementId, std::string> children_;  ///< new ones, by parent
};

}  // namespace smurf
