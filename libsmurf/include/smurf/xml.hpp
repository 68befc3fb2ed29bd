// SPDX-License-Identifier: BSD-3-Clause
// The XML tree of a URDF: every element and attribute, known or not, with its byte spans.
#pragma once

#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/source.hpp"

namespace smurf::xml {

enum class ElementId : std::uint32_t {};
inline constexpr ElementId kNoElement{0xffffffffU};
inline constexpr std::uint32_t kNoText = 0xffffffffU;

// Robots have hundreds of thousands of both, so values that follow from others are not stored.

/// The decoded value of an attribute, if it differs from the written value.
struct DecodedValue {
  const char* name = nullptr;  ///< of the attribute, in the source
  std::string value;
};

/// An attribute of an element: its name and value, with their places.
class Attribute {
 public:
  /// Both places are in the source whose text is `source`.
  Attribute(std::string_view source, Span name, Span value)
      : source_name(source.data() + name.begin),
        source_(name.source),
        begin_(name.begin),
        name_size_(name.end - name.begin),
        value_begin_(value.begin),
        value_end_(value.end) {}

  /// The name as it is written, with its prefix.
  std::string_view name() const {
    return {is_decoded_ ? decoded_value->name : source_name, name_size_};
  }
  /// Entities decoded.
  std::string_view value() const {
    return is_decoded_
               ? std::string_view(decoded_value->value)
               : std::string_view(source_name + (value_begin_ - begin_), value_end_ - value_begin_);
  }
  Span name_span() const { return {source_, begin_, begin_ + name_size_}; }
  /// Between the quotes.
  Span value_span() const { return {source_, value_begin_, value_end_}; }
  /// From the name to the closing quote, or to the end of a value without quotes.
  Span span() const { return {source_, begin_, value_end_ + (has_quotes() ? 1U : 0U)}; }

  /// `decoded` must outlive this object and have the name of the attribute.
  void set_value(const DecodedValue& decoded) {
    decoded_value = &decoded;
    is_decoded_ = true;
  }

 private:
  /// Values without quotes are never decoded.
  bool has_quotes() const {
    if (is_decoded_) return true;
    const char after = source_name[value_end_ - begin_];
    return after == '"' || after == '\'';
  }

  union {
    const char* source_name;
    const DecodedValue* decoded_value;
  };
  SourceId source_;
  std::uint32_t begin_;
  std::uint32_t name_size_;
  std::uint32_t value_begin_;
  std::uint32_t value_end_;
  bool is_decoded_ = false;
};

/// Character data directly inside an element; only the first piece.
struct Text {
  std::string_view value;  ///< untrimmed; empty if it comes after a child
  Span span;               ///< without the blanks around it
};

/// An element; its parent, siblings and attributes are indices of the document.
struct Element {
  const char* name_begin = nullptr;  ///< in the source, directly after the '<'
  std::uint32_t name_size = 0;
  Span span;  ///< from '<' to the end of the end tag
  std::uint32_t tag_end = 0;
  std::uint32_t first_attribute = 0;
  std::uint32_t attribute_count = 0;
  ElementId parent = kNoElement;
  ElementId next_sibling = kNoElement;
  std::uint32_t text = kNoText;  ///< in Document::texts

  /// The name as it is written, with its prefix.
  std::string_view name() const { return {name_begin, name_size}; }
  /// The start tag with its brackets.
  Span tag_span() const { return {span.source, span.begin, tag_end}; }
  /// The name in the start tag.
  Span name_span() const { return {span.source, span.begin + 1, span.begin + 1 + name_size}; }
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
  std::deque<std::string> decoded;  ///< texts that differ from their bytes
  std::deque<DecodedValue> decoded_values;
  ElementId root = kNoElement;

  View view() const;
  /// The first child comes directly after its parent, because elements are in document order.
  ElementId first_child(ElementId id) const {
    const std::size_t next = static_cast<std::size_t>(id) + 1;
    return next < elements.size() && elements[next].parent == id
               ? ElementId{static_cast<std::uint32_t>(next)}
               : kNoElement;
  }
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
  std::string_view name() const { return element().name(); }
  Span span() const { return element().span; }
  Span tag_span() const { return element().tag_span(); }
  Span name_span() const { return element().name_span(); }

  /// Both are empty for an element without text.
  std::string_view text() const {
    return element().text == kNoText ? std::string_view() : document_->texts[element().text].value;
  }
  Span text_span() const {
    return element().text == kNoText ? Span{} : document_->texts[element().text].span;
  }

  const Attribute* attribute(std::string_view name) const;
  /// All attributes in document order.
  std::span<const Attribute> attributes() const {
    return {document_->attributes.data() + element().first_attribute, element().attribute_count};
  }
  /// First child element of this name.
  View child(std::string_view name) const;
  View parent() const { return document_ ? View(*document_, element().parent) : View(); }

  /// Over the child elements.
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
  Iterator begin() const { return {document_, document_->first_child(id_)}; }
  Iterator end() const { return {document_, kNoElement}; }

 private:
  const Document* document_ = nullptr;
  ElementId id_ = kNoElement;
};

inline View Document::view() const { return {*this, root}; }

/// "/robot/joint[@name='a']/limit", with positions if names do not distinguish siblings.
std::string xpath(const Document& document, ElementId id);
/// Makes paths of many elements of one document: siblings are counted once.
class XPaths {
 public:
  explicit XPaths(const Document& document) : document_(&document) {}
  std::string find(ElementId id);

 private:
  /// Numbers of elements that are not counted among siblings of the same step.
  static constexpr std::uint32_t kUnknown = 0;
  static constexpr std::uint32_t kAlone = static_cast<std::uint32_t>(-1);

  void number_children(View parent);
  std::string step(View element);

  const Document* document_;
  std::vector<std::uint32_t> numbers_;  ///< by element, from 1
};

/// The deepest element whose span contains the byte.
ElementId element_at(const Document& document, std::uint32_t offset);

}  // namespace smurf::xml
