// SPDX-License-Identifier: BSD-3-Clause
// Texts for testing a reader: those of a folder, and variants with faults.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "unit/random.hpp"

namespace smurf::test {

/// The contents of the files below a folder with these endings; none if it does not exist.
std::vector<std::string> texts_below(const std::string& folder,
                                     std::span<const std::string_view> extensions);

/// Replaces, doubles, deletes or moves one to three parts of a text.
std::string mutated(std::string text, std::string (*token)(Random&), Random& random);

/// A few lines of a text: small cases are fast to read and give readable failures.
std::string some_lines(const std::string& text, Random& random);

/// Compares the results of two readers for a text; returns whether it was compared.
using Compare = bool (*)(const std::string& text);

/// Compares the texts of the fixtures and, if it exists, of the corpus; at least a given share of
/// each must be comparable.
void compare_files(std::span<const std::string_view> extensions, Compare compare, double share);

/// Compares texts that `make` generates from small texts of the fixtures: SMURF_TEST_CASES of them,
/// or 20,000.
void compare_made(std::span<const std::string_view> extensions, Compare compare, double share,
                  std::string (*make)(const std::string& seed, Random& random));

}  // namespace smurf::test
