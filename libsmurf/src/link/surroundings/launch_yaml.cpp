// SPDX-License-Identifier: BSD-3-Clause
// Source: launch_yaml entity.py, branches humble and jazzy.
#include "link/surroundings/launch_elements.hpp"

namespace smurf {
namespace {

void add_content(yaml::View from, launch::Element& element);

launch::Element element_of(yaml::View value, std::string_view name, Span span) {
  launch::Element element;
  element.name = name;
  element.span = span;
  add_content(value, element);
  return element;
}

/// Actions: a list of mappings, each with the name of the action as its only key.
void add_actions(yaml::View list, launch::Element& element) {
  if (!list.is_sequence()) return;
  for (const yaml::View item : list) {
    if (!item.is_mapping()) continue;
    for (const yaml::View action : item) {
      element.children.push_back(element_of(action, action.key(), action.key_span()));
    }
  }
}

/// A mapping has attributes, and lists such as `param`, whose items are elements of that name. A
/// group may also be the list of its actions. As deep as the file, whose depth is limited.
void add_content(yaml::View from, launch::Element& element) {
  if (from.is_sequence()) return add_actions(from, element);
  if (!from.is_mapping()) return;
  for (const yaml::View member : from) {
    if (member.key() == "children") {
      add_actions(member, element);
    } else if (member.is_scalar()) {
      element.attributes.push_back(
          {std::string(member.key()), std::string(member.text()), member.span()});
    } else if (member.is_sequence()) {
      for (const yaml::View item : member) {
        element.children.push_back(element_of(item, member.key(), member.key_span()));
      }
    }
  }
}

}  // namespace

void read_yaml_launch(const yaml::Document& document, const FindLaunchPath& find,
                      LaunchFile& file) {
  const yaml::View root = document.view();
  const yaml::View launch = root && root.is_mapping() ? root.find("launch") : yaml::View();
  if (!launch) return;
  launch::read_elements(element_of(launch, launch.key(), launch.key_span()), find, file);
  file.is_ros1 = false;
}

}  // namespace smurf
