// SPDX-License-Identifier: BSD-3-Clause
// Texts to try a reader on: those of a folder, and what becomes of them by mistakes.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "unit/random.hpp"

namespace smurf::test {

/// The contents of the files in and below a folder whose names end so; none when it does not exist.
std::vector<std::string> texts_below(const std::string& folder,
                                     std::span<const std::string_view> extensions);

/// One to three places of a text replaced, doubled, cut or moved.
std::string mutated(std::string text, std::string (*token)(Random&), Random& random);

/// A few lines out of a text: small cases are read fast and fail legibly.
std::string some_lines(const std::string& text, Random& random);

/// Compares how two readers read a text; true when it is one that is compared.
using Compare = bool (*)(const std::string& text);

/// Compares the texts of the fixtures and, where it is there, of the corpus; at least a share of
/// each must be of the kind that is compared.
void compare_files(std::span<const std::string_view> extensions, Compare compare, double share);

/// Compares texts that `make` makes of small ones of the fixtures: SMURF_TEST_CASES of them, or
/// 20,000.
void compare_made(std::span<const std::string_view> extensions, Compare compare, double share,
                  std::string (*make)(const std::string& seed, Random& random));

}  // namespace smurf::test
