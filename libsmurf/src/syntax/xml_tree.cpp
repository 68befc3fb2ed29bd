// SPDX-License-Identifier: BSD-3-Clause
// Reading an xml::Document.
#include <algorithm>
#include <map>

#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "smurf/xml.hpp"

namespace smurf::xml {

const Attribute* View::attribute(std::string_view name) const {
  const Element& element = this->element();
  const Attribute* first = document_->attributes.data() + element.first_attribute;
  const Attribute* end = first + element.attribute_count;
  const Attribute* found = std::find_if(
      first, end, [&](const Attribute& attribute) { return is_same(attribute.name(), name); });
  return found == end ? nullptr : found;
}

View View::child(std::string_view name) const {
  if (!*this) return {};
  for (const View candidate : *this) {
    if (is_same(candidate.name(), name)) return candidate;
  }
  return {};
}

void XPaths::name_children(View parent) {
  const auto key_of = [](View element) {
    const Attribute* name = element.attribute("name");
    const bool is_usable = name != nullptr && name->value().find('\'') == std::string_view::npos;
    return "/" + std::string(element.name()) +
           (is_usable ? "[@name='" + std::string(name->value()) + "']" : "");
  };
  struct Siblings {
    std::size_t count = 0;
    std::size_t seen = 0;
  };
  std::map<std::string, Siblings> same;
  // For elements without a name, all siblings of the kind are counted.
  const auto kind_of = [](View element) { return "/" + std::string(element.name()); };
  for (const View child : parent) {
    ++same[key_of(child)].count;
    if (key_of(child) != kind_of(child)) ++same[kind_of(child)].count;
  }
  for (const View child : parent) {
    std::string step = key_of(child);
    Siblings& siblings = same[step];
    ++siblings.seen;
    if (step != kind_of(child)) ++same[kind_of(child)].seen;
    if (siblings.count > 1) step += "[" + std::to_string(siblings.seen) + "]";
    steps_[static_cast<std::size_t>(child.id())] = std::move(step);
  }
}

/// Every finding has a path, so long names in it would be kept ten thousand times.
constexpr std::size_t kLongestStep = 300;
constexpr std::size_t kLongestPath = 2000;

/// The last steps of a path that is too long.
std::string XPaths::find(ElementId id) {
  steps_.resize(document_->elements.size());
  std::string result;
  for (View view(*document_, id); view; view = view.parent()) {
    std::string& step = steps_[static_cast<std::size_t>(view.id())];
    if (step.empty()) {
      if (const View parent = view.parent()) {
        name_children(parent);
      } else {
        step = "/" + std::string(view.name());
      }
    }
    result.insert(0, shortened(step, kLongestStep));
    if (result.size() > kLongestPath) return "/..." + result;
  }
  return result;
}

std::string xpath(const Document& document, ElementId id) { return XPaths(document).find(id); }

ElementId element_at(const Document& document, std::uint32_t offset) {
  // Elements are in document order, so it is the last one that begins before the byte, or one of
  // its parents.
  const auto after =
      std::partition_point(document.elements.begin(), document.elements.end(),
                           [&](const Element& element) { return element.span.begin <= offset; });
  if (after == document.elements.begin()) return kNoElement;
  ElementId id{static_cast<std::uint32_t>(after - document.elements.begin() - 1)};
  while (id != kNoElement) {
    const Element& element = document.elements[static_cast<std::size_t>(id)];
    if (element.span.contains(offset)) break;
    id = element.parent;
  }
  return id;
}

}  // namespace smurf::xml
