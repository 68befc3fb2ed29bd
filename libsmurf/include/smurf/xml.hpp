// SPDX-License-Identifier: BSD-3-Clause
// The XML tree of a URDF: every element and attribute, known or not, with its byte spans.
#pragma once

#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/source.hpp"

namespace smurf::xml {

enum class ElementId : std::uint32_t {};
inline constexpr ElementId kNoElement{0xffffffffU};
inline constexpr std::uint32_t kNoText = 0xffffffffU;

// Robots have hundreds of thousands of both, so what can be told from the rest is not kept.
struct Attribute {
  std::string_view name;   ///< as written
  std::string_view value;  ///< entities decoded
  Span value_span;         ///< between the quotes
  std::uint32_t begin = 0;

  Span name_span() const {
    return {value_span.source, begin, begin + static_cast<std::uint32_t>(name.size())};
  }
  /// From the name to the closing quote.
  Span span() const { return {value_span.source, begin, value_span.end + 1}; }
};

/// Character data directly inside an element, the first piece only.
struct Text {
  std::string_view value;  ///< untrimmed; empty when a child stands before it
  Span span;               ///< without the blanks around it
};

struct Element {
  std::string_view name;  ///< as written, right behind the '<'
  Span span;              ///< from '<' to the end of the end tag
  std::uint32_t tag_end = 0;
  std::uint32_t first_attribute = 0;
  std::uint32_t attribute_count = 0;
  ElementId parent = kNoElement;
  ElementId first_child = kNoElement;
  ElementId next_sibling = kNoElement;
  std::uint32_t text = kNoText;  ///< in Document::texts

  /// The start tag with its brackets.
  Span tag_span() const { return {span.source, span.begin, tag_end}; }
  /// The name in the start tag.
  Span name_span() const {
    return {span.source, span.begin + 1, span.begin + 1 + static_cast<std::uint32_t>(name.size())};
  }
};

class View;

/// Moved, never copied: texts point into it and into the SourceMap.
struct Document {
  Document() = default;
  Document(Document&&) = default;
  Document& operator=(Document&&) = default;
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  SourceId source{};
  std::vector<Element> elements;  ///< in document order
  std::vector<Attribute> attributes;
  std::vector<Text> texts;  ///< elements of URDF have none
  std::vector<Span> comments;
  std::deque<std::string> decoded;
  ElementId root = kNoElement;

  View view() const;
};

/// A cheap handle to an element; iterates over its child elements.
class View {
 public:
  View() = default;
  View(const Document& document, ElementId id) : document_(&document), id_(id) {}

  explicit operator bool() const { return document_ != nullptr && id_ != kNoElement; }
  ElementId id() const { return id_; }
  const Document& document() const { return *document_; }
  const Element& element() const { return document_->elements[static_cast<std::size_t>(id_)]; }
  std::string_view name() const { return element().name; }
  Span span() const { return element().span; }
  Span tag_span() const { return element().tag_span(); }
  Span name_span() const { return element().name_span(); }

  /// Of an element without text both are empty.
  std::string_view text() const {
    return element().text == kNoText ? std::string_view() : document_->texts[element().text].value;
  }
  Span text_span() const {
    return element().text == kNoText ? Span{} : document_->texts[element().text].span;
  }

  const Attribute* attribute(std::string_view name) const;
  /// Begin and end pointers of the attributes, in document order.
  const Attribute* attributes_begin() const {
    return document_->attributes.data() + element().first_attribute;
  }
  const Attribute* attributes_end() const { return attributes_begin() + element().attribute_count; }
  /// First child element of this name.
  View child(std::string_view name) const;
  View parent() const { return document_ ? View(*document_, element().parent) : View(); }

  class Iterator {
   public:
    using difference_type = std::ptrdiff_t;
    using value_type = View;
    Iterator() = default;
    Iterator(const Document* document, ElementId id) : document_(document), id_(id) {}
    View operator*() const { return View(*document_, id_); }
    Iterator& operator++() {
      id_ = document_->elements[static_cast<std::size_t>(id_)].next_sibling;
      return *this;
    }
    Iterator operator++(int) {
      Iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.id_ == b.id_; }

   private:
    const Document* document_ = nullptr;
    ElementId id_ = kNoElement;
  };
  Iterator begin() const { return {document_, element().first_child}; }
  Iterator end() const { return {document_, kNoElement}; }

 private:
  const Document* document_ = nullptr;
  ElementId id_ = kNoElement;
};

inline View Document::view() const { return {*this, root}; }

/// "/robot/joint[@name='a']/limit", with positions where names do not tell siblings apart.
std::string xpath(const Document& document, ElementId id);
/// The same for many elements of one document: siblings are counted once.
class XPaths {
 public:
  explicit XPaths(const Document& document) : document_(&document) {}
  std::string find(ElementId id);

 private:
  void name_children(View parent);

  const Document* document_;
  std::vector<std::string> steps_;  ///< by element; empty as long as nobody asked
};

/// The deepest element whose span holds the byte.
ElementId element_at(const Document& document, std::uint32_t offset);

}  // namespace smurf::xml
