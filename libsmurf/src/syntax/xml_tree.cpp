// SPDX-License-Identifier: BSD-3-Clause
// Reading an xml::Document.
#include <algorithm>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/numbers/hash.hpp"
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

namespace {

/// Every finding has a path, so long names in it would be kept ten thousand times.
constexpr std::size_t kLongestStep = 300;
constexpr std::size_t kLongestPath = 2000;

/// A bit of the number of an element: its name is part of the step.
constexpr std::uint32_t kNamed = 1U << 31U;

/// Appends a part of a step; of a long one, what can be left after shortening the step.
void append_part(std::string& step, std::string_view part) {
  step += part.substr(0, kLongestStep);
  if (part.size() <= kLongestStep) return;
  step += part.substr(std::max(kLongestStep, part.size() - kLongestStep));
}

/// The value by which a step names an element; none if it has no name that can be quoted.
std::optional<std::string_view> name_in_step(View element) {
  const Attribute* name = element.attribute("name");
  if (name == nullptr || name->value().find('\'') != std::string_view::npos) return std::nullopt;
  return name->value();
}

/// A step of a path, without a number: the kind of the element and its name.
struct Step {
  std::string_view kind;
  std::optional<std::string_view> name;

  bool operator==(const Step& other) const {
    return name.has_value() == other.name.has_value() && is_same(kind, other.kind) &&
           (!name || is_same(*name, *other.name));
  }
};

struct HashOfStep {
  std::size_t operator()(const Step& step) const {
    constexpr std::size_t kNameless = 1;
    return hash_of(step.kind) * 31 + (step.name ? hash_of(*step.name) : kNameless);
  }
};

}  // namespace

void XPaths::number_children(View parent) {
  struct Siblings {
    std::uint32_t count = 0;
    std::uint32_t seen = 0;
  };
  struct Child {
    Siblings* same = nullptr;     ///< of the same step
    Siblings* of_kind = nullptr;  ///< of the kind, with any name or none
    ElementId id = kNoElement;
  };
  std::unordered_map<Step, Siblings, HashOfStep> steps;
  std::vector<Child> children;
  // For elements without a name, all siblings of the kind are counted.
  for (const View child : parent) {
    const auto name = name_in_step(child);
    Siblings& of_kind = steps[{child.name(), std::nullopt}];
    Siblings& same = name ? steps[{child.name(), name}] : of_kind;
    ++same.count;
    if (name) ++of_kind.count;
    children.push_back({&same, &of_kind, child.id()});
  }
  for (const Child& child : children) {
    const bool is_named = child.same != child.of_kind;
    ++child.same->seen;
    if (is_named) ++child.of_kind->seen;
    const std::uint32_t number = child.same->count > 1 ? child.same->seen : kAlone & ~kNamed;
    numbers_[static_cast<std::size_t>(child.id)] = number | (is_named ? kNamed : 0);
  }
}

std::string XPaths::step(View element) {
  std::string step = "/";
  append_part(step, element.name());
  const View parent = element.parent();
  if (!parent) return step;
  std::uint32_t& known = numbers_[static_cast<std::size_t>(element.id())];
  if (known == kUnknown) number_children(parent);
  if ((known & kNamed) != 0) {
    step += "[@name='";
    append_part(step, element.attribute("name")->value());
    step += "']";
  }
  const std::uint32_t number = known & ~kNamed;
  return number == (kAlone & ~kNamed) ? step : step + "[" + std::to_string(number) + "]";
}

/// The last steps of a path that is too long.
std::string XPaths::find(ElementId id) {
  numbers_.resize(document_->elements.size(), kUnknown);
  std::string result;
  for (View view(*document_, id); view; view = view.parent()) {
    result.insert(0, shortened(step(view), kLongestStep));
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
