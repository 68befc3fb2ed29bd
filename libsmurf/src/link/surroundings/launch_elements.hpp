// SPDX-License-Identifier: BSD-3-Clause
// The elements of a launch file in XML or YAML: one form for both.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "link/surroundings/launch_reader.hpp"
#include "link/surroundings/python_calls.hpp"
#include "smurf/source.hpp"

namespace smurf::launch {

/// `exec="rviz2"` in XML, `exec: rviz2` in YAML.
struct Attribute {
  std::string name, value;
  Span span;  ///< of the value
  Span name_span;
  /// What PyYAML makes of the value; in XML always a text.
  enum class Type : std::uint8_t { text, truth, count, real, none, list };
  Type type = Type::text;
};

/// `<node .../>` in XML, an item `node:` of a list in YAML.
struct Element {
  std::string name;
  Span span;  ///< of the name
  std::vector<Attribute> attributes;
  std::vector<Element> children;

  /// Null if the element does not have it.
  const Attribute* attribute(std::string_view wanted) const;
};

/// Substitutions: `$(find-pkg-share P)/urdf/$(var model)`.
python::Value substituted(std::string_view text, Span span);

/// Adds what the elements in `root` start.
void read_elements(const Element& root, const FindLaunchPath& find, LaunchFile& file);

}  // namespace smurf::launch
