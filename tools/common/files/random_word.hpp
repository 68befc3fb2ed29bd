// SPDX-License-Identifier: BSD-3-Clause
// Words that nobody can guess, for names of files and addresses.
#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <string_view>

namespace smurf::tools {

/// A word of `count` small letters and digits, from the random numbers of the system.
inline std::string random_word(std::size_t count) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device device;
  std::uniform_int_distribution<std::size_t> any(0, kLetters.size() - 1);
  std::string word;
  for (std::size_t i = 0; i < count; ++i) word += kLetters[any(device)];
  return word;
}

}  // namespace smurf::tools
