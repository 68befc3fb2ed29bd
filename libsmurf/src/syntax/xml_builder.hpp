// SPDX-License-Identifier: BSD-3-Clause
// The tree of an XML file as it grows: tags are opened and closed in document order.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "smurf/xml.hpp"

namespace smurf {

class XmlBuilder {
 public:
  XmlBuilder(std::string_view text, SourceId id);

  /// Without what was added behind end_root().
  xml::Document take();
  /// The root element has ended, and another begins: readers leave it out. Whether one did before.
  bool end_root();

  /// The number of open elements.
  std::size_t depth() const { return open_.size(); }
  const std::vector<xml::Element>& elements() const { return document_.elements; }
  const std::vector<xml::Attribute>& attributes() const { return document_.attributes; }
  /// The innermost element that is open. Precondition: depth() > 0.
  const xml::Element& innermost() const;

  void add_comment(Span comment) { document_.comments.push_back(comment); }
  /// Add attributes before their element.
  void add_attribute(const xml::Attribute& attribute) { document_.attributes.push_back(attribute); }
  /// Adds an attribute whose value must be decoded: it contains an '&' or a carriage return.
  void add_coded_attribute(xml::Attribute attribute);
  /// Its attributes are those from `first_attribute` on.
  void open(xml::Element element);
  void close(std::uint32_t end);
  /// Readers use the first text of an element that is not blank, or the first CDATA section, if it
  /// comes before its children.
  void add_text(Span text);
  /// Ignores text after a declaration. Precondition: depth() > 0.
  void add_declaration() { open_.back().has_declaration = true; }
  /// `text` is the text inside its brackets.
  void add_character_section(Span text);

  /// A direct child of the innermost element with the same name: the missing end tag may belong
  /// before it. Null if there is none.
  const xml::Element* suspect() const;

 private:
  struct OpenElement {
    xml::ElementId element = xml::kNoElement;
    xml::ElementId last_child = xml::kNoElement;
    bool has_text = false;
    bool has_declaration = false;
  };

  /// Adds a text as written. False if no reader uses this text.
  bool take_text(Span text, bool is_section);
  /// The text that was just added.
  void decode_text(std::string (*decode)(std::string_view));

  xml::Element& at(xml::ElementId id) { return document_.elements[static_cast<std::size_t>(id)]; }

  std::string_view text_;
  xml::Document document_;
  std::vector<OpenElement> open_;
  std::size_t elements_of_root_ = 0;  ///< if another root element follows
};

}  // namespace smurf
