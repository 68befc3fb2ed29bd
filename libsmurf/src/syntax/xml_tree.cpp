// SPDX-License-Identifier: BSD-3-Clause
// Reading an xml::Document.
#include <algorithm>

#include "smurf/xml.hpp"

namespace smurf::xml {

const Attribute* View::attributes_begin() const {
  return document_->attributes.data() + element().first_attribute;
}

const Attribute* View::attributes_end() const {
  return attributes_begin() + element().attribute_count;
}

const Attribute* View::attribute(std::string_view name) const {
  const Attribute* found =
      std::find_if(attributes_begin(), attributes_end(),
                   [&](const Attribute& attribute) { return attribute.name == name; });
  return found == attributes_end() ? nullptr : found;
}

View View::child(std::string_view name) const {
  if (!*this) return {};
  for (const View candidate : *this) {
    if (candidate.name() == name) return candidate;
  }
  return {};
}

std::string xpath(const Document& document, ElementId id) {
  std::string result;
  while (id != kNoElement) {
    const View view(document, id);
    const Attribute* name = view.attribute("name");
    if (name != nullptr && name->value.find('\'') != std::string_view::npos) name = nullptr;
    std::size_t position = 0;
    std::size_t count = 0;
    if (const View parent = view.parent()) {
      for (const View sibling : parent) {
        if (sibling.name() != view.name()) continue;
        const Attribute* other = sibling.attribute("name");
        if (name != nullptr && (other == nullptr || other->value != name->value)) continue;
        ++count;
        if (sibling.id() == id) position = count;
      }
    } else {
      name = nullptr;
    }
    std::string step = "/" + std::string(view.name());
    if (name != nullptr) step += "[@name='" + std::string(name->value) + "']";
    if (count > 1) step += "[" + std::to_string(position) + "]";
    result.insert(0, step);
    id = view.element().parent;
  }
  return result;
}

ElementId element_at(const Document& document, std::uint32_t offset) {
  ElementId found = kNoElement;
  ElementId id = document.root;
  while (id != kNoElement) {
    const Element& element = document.elements[static_cast<std::size_t>(id)];
    if (element.span.contains(offset)) {
      found = id;
      id = element.first_child;
    } else {
      id = element.next_sibling;
    }
  }
  return found;
}

}  // namespace smurf::xml
