// SPDX-License-Identifier: BSD-3-Clause
// Writes a YAML text that is made from a file of another language, and remembers where each value
// of it comes from.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "imports/traced_xml.hpp"

namespace smurf::imports {

/// A text in quotes, as YAML reads it.
std::string yaml_text(std::string_view text);

class TracedYaml {
 public:
  explicit TracedYaml(xacro::Expansion& expansion) : leaves_(expansion.leaves) {}

  void plain(std::string_view text) { text_ += text; }
  /// A part of the text that has one place; `is_made`: nobody wrote YAML there, so rules on writing
  /// are not meant for it.
  void part(std::string_view text, const Place& place, bool is_made = true);
  /// "  key: value".
  void line(std::string_view indent, std::string_view key, std::string_view text,
            const Place& place, bool is_made = true);
  std::size_t size() const { return text_.size(); }
  /// Takes back what was written since then; it has no places.
  void cut(std::size_t size) { text_.resize(size); }
  std::string take() { return std::move(text_); }

 private:
  std::vector<xacro::Leaf>& leaves_;
  std::string text_;
};

/// An entry of the section `link` that keeps the tensor of a link, which looks like a placeholder.
void keep_inertia(TracedYaml& yaml, std::string_view link, const Place& place);

}  // namespace smurf::imports
