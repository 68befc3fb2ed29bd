// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "base/text/quoted.hpp"
#include "link/surroundings/launch_elements.hpp"

namespace smurf {
namespace {

// As deep as the file, whose depth is limited.
launch::Element element_of(xml::View from) {
  launch::Element element;
  element.name = from.name();
  element.span = from.name_span();
  for (const xml::Attribute& one : from.attributes()) {
    element.attributes.push_back(
        {std::string(one.name()), std::string(one.value()), one.value_span(), one.name_span()});
  }
  for (const xml::View child : from) element.children.push_back(element_of(child));
  return element;
}

}  // namespace

void read_xml_launch(const xml::Document& document, const FindLaunchPath& find, LaunchFile& file) {
  const xml::View root = document.view();
  if (!root) return;
  if (root.name() == "launch") return launch::read_elements(element_of(root), find, file);
  file.mistakes.push_back({LaunchMistake::Kind::word, root.name_span(),
                           "the first element is " + quoted("<" + std::string(root.name()) + ">") +
                               ", and launch reads only `<launch>`",
                           "write `<launch>` and `</launch>`"});
}

}  // namespace smurf
