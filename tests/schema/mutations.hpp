// SPDX-License-Identifier: BSD-3-Clause
// Wrong and unusual values for every key, and random changes to whole files.
#pragma once

#include <functional>
#include <random>
#include <string>

#include "schema/case_file.hpp"

namespace smurf::test {

using AddCase = std::function<void(FileKind kind, std::string text)>;

/// For each key of each table, one text per value: values of every kind, the bounds, the choices
/// and the default.
void enumerate_values(const AddCase& add);

/// The text with a value replaced by one of another kind, or a key renamed to another known or
/// unknown one. Works on bytes, so that layout, quotes and comments stay as they are.
std::string mutate(std::string text, std::mt19937& random);

}  // namespace smurf::test
