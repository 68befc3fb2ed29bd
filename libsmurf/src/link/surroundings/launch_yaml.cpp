// SPDX-License-Identifier: BSD-3-Clause
// Source: launch_yaml entity.py, branches humble and jazzy.
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "ast/notation.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "link/surroundings/launch_elements.hpp"

namespace smurf {
namespace {

using launch::Attribute;

/// What PyYAML makes of a value.
Attribute::Type type_of(yaml::View value) {
  if (value.is_sequence()) return Attribute::Type::list;
  switch (value.type()) {
  case yaml::ScalarType::null: return Attribute::Type::none;
  case yaml::ScalarType::boolean: return Attribute::Type::truth;
  case yaml::ScalarType::integer:
  case yaml::ScalarType::number: {
    if (number_by_yaml11(value.text())) return Attribute::Type::text;
    return value.type() == yaml::ScalarType::integer ? Attribute::Type::count
                                                     : Attribute::Type::real;
  }
  case yaml::ScalarType::text: break;
  }
  const bool is_plain = value.style() == yaml::Style::plain;
  const auto other = is_plain ? text_by_yaml11(value.text()) : std::nullopt;
  if (other && *other == "a boolean") return Attribute::Type::truth;
  return Attribute::Type::text;
}

struct Mistakes {
  LaunchFile* file = nullptr;
  void add(Span span, std::string message, std::string help) const {
    file->mistakes.push_back(
        {LaunchMistake::Kind::word, span, std::move(message), std::move(help)});
  }
};

void add_content(yaml::View from, launch::Element& element, const Mistakes& mistakes);

launch::Element element_of(yaml::View value, std::string_view name, Span span,
                           const Mistakes& mistakes) {
  launch::Element element;
  element.name = name;
  element.span = span;
  add_content(value, element, mistakes);
  return element;
}

/// Actions: a list of mappings, each with the name of the action as its only key.
void add_actions(yaml::View list, launch::Element& element, const Mistakes& mistakes) {
  if (!list.is_sequence()) return;
  for (const yaml::View item : list) {
    std::set<std::string_view> keys;
    if (item.is_mapping()) {
      for (const yaml::View action : item) keys.insert(action.key());
    }
    if (keys.size() == 1 && item.size() > 1) {
      mistakes.add(item.span(),
                   "of several " + quoted(*keys.begin()) + " in one item the last counts",
                   "write `- ` before each of them");
    } else if (keys.size() != 1) {
      mistakes.add(item.span(), "launch needs an item with one key here, the name of an action",
                   "write `- node:`, and what belongs to it below, further to the right");
    }
    if (!item.is_mapping()) continue;
    for (const yaml::View action : item) {
      element.children.push_back(element_of(action, action.key(), action.key_span(), mistakes));
    }
  }
}

/// A mapping has attributes, and lists such as `param`, whose items are elements of that name. A
/// group may also be the list of its actions. As deep as the file, whose depth is limited.
void add_content(yaml::View from, launch::Element& element, const Mistakes& mistakes) {
  if (from.is_sequence()) return add_actions(from, element, mistakes);
  if (!from.is_mapping()) return;
  for (const yaml::View member : from) {
    if (member.key() == "children") {
      add_actions(member, element, mistakes);
    } else if (member.is_scalar() || member.is_null()) {
      element.attributes.push_back({std::string(member.key()),
                                    std::string(member.is_null() ? "" : member.text()),
                                    member.span(), member.key_span(), type_of(member)});
    } else if (member.is_sequence() && member.key() == "value") {
      // The values of a parameter.
      element.attributes.push_back(
          {std::string(member.key()), "", member.span(), member.key_span(), Attribute::Type::list});
    } else if (member.is_sequence()) {
      for (const yaml::View item : member) {
        element.children.push_back(element_of(item, member.key(), member.key_span(), mistakes));
      }
    } else if (member.is_mapping()) {
      mistakes.add(member.key_span(), quoted(member.key()) + " must be a list here",
                   "write `- ` before its first key");
    }
  }
}

}  // namespace

void read_yaml_launch(const yaml::Document& document, const FindLaunchPath& find,
                      LaunchFile& file) {
  const yaml::View root = document.view();
  if (!root) return;
  const Mistakes mistakes{&file};
  const yaml::View launch = root.is_mapping() ? root.find("launch") : yaml::View();
  if (!launch || root.size() != 1) {
    Span place = root.span();
    if (root.is_mapping() && root.size() > 0) {
      for (const yaml::View member : root) {
        if (member.key() != "launch") place = member.key_span();
      }
    }
    mistakes.add(place, "launch needs `launch` as the only key of the file",
                 "write `launch:` in the first line, and the actions below");
    if (!launch) return;
  }
  if (!launch.is_sequence() && !(launch.is_mapping() && launch.find("children"))) {
    mistakes.add(launch.key_span(), "`launch` needs a list of actions",
                 "write `- ` before each action");
  }
  // An action without attributes is no mapping.
  file.is_ros1 = false;
  launch::read_elements(element_of(launch, launch.key(), launch.key_span(), mistakes), find, file);
  file.is_ros1 = false;
}

}  // namespace smurf
