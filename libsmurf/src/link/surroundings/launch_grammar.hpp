// SPDX-License-Identifier: BSD-3-Clause
// `$(name value ...)` in launch files of XML and YAML, as launch reads it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::launch {

/// A substitution in a text; places are bytes of the text.
struct WrittenSubstitution {
  std::string_view name;
  std::size_t begin = 0, end = 0;  ///< of the name
  int values = 0;                  ///< behind it
  /// The first value and its place, if it is only letters.
  std::string_view first;
  std::size_t first_begin = 0;
};

struct SubstitutionFault {
  std::size_t begin = 0, end = 0;
  std::string message, help;
};

struct Substitutions {
  std::vector<WrittenSubstitution> all;  ///< inner ones before the outer ones
  std::optional<SubstitutionFault> fault;
};

/// Source: launch frontend/grammar.lark, run with humble, jazzy and rolling.
Substitutions read_substitutions(std::string_view text);

}  // namespace smurf::launch
