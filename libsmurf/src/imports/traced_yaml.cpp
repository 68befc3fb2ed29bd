// SPDX-License-Identifier: BSD-3-Clause
#include "imports/traced_yaml.hpp"

#include <cstdint>

#include "imports/imports.hpp"

namespace smurf::imports {

std::string yaml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result.push_back('\\');
    result.push_back(static_cast<unsigned char>(c) < ' ' ? ' ' : c);
  }
  return result + "\"";
}

void TracedYaml::part(std::string_view text, const Place& place, bool is_made) {
  xacro::Leaf& leaf = leaves_.emplace_back();
  leaf.kind = xacro::Leaf::Kind::value;
  leaf.begin = static_cast<std::uint32_t>(text_.size());
  text_ += text;
  leaf.end = static_cast<std::uint32_t>(text_.size());
  leaf.origin = place.origin;
  leaf.use = leaf.whole = place.use;
  if (is_made) leaf.first_input = kMade;
  leaf.frame = place.frame;
}

void TracedYaml::line(std::string_view indent, std::string_view key, std::string_view text,
                      const Place& place, bool is_made) {
  // Findings about a key are about what it says, too.
  part(std::string(indent).append(key).append(": ").append(text).append("\n"), place, is_made);
}

void keep_inertia(TracedYaml& yaml, std::string_view link, const Place& place) {
  yaml.line("- ", "name", yaml_text(link), place);
  yaml.line("  ", "link", yaml_text(link), place);
  yaml.line("  ", "keep_inertia", "true", place);
}

}  // namespace smurf::imports
