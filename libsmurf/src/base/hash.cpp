// SPDX-License-Identifier: BSD-3-Clause
// Multilinear hashing, which is strongly universal for random keys (Lemire and Kaser, "Strongly
// universal string hashing is fast", 2014).
#include "base/hash.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>

namespace smurf {
namespace {

std::uint64_t random_seed() {
  std::random_device random;
  return std::uint64_t{random()} << 32U | random();
}

/// The key for the next four bytes (the generator splitmix64).
std::uint64_t next_key(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15U;
  std::uint64_t key = state;
  key = (key ^ key >> 30U) * 0xbf58476d1ce4e5b9U;
  key = (key ^ key >> 27U) * 0x94d049bb133111ebU;
  return key ^ key >> 31U;
}

}  // namespace

std::size_t hash_of(std::string_view bytes) {
  static const std::uint64_t seed = random_seed();
  std::uint64_t state = seed;
  std::uint64_t sum = next_key(state);
  sum += next_key(state) * bytes.size();
  while (!bytes.empty()) {
    std::uint32_t word = 0;
    const std::size_t size = std::min(bytes.size(), sizeof word);
    std::memcpy(&word, bytes.data(), size);
    sum += next_key(state) * word;
    bytes.remove_prefix(size);
  }
  return static_cast<std::size_t>(sum >> 32U);
}

}  // namespace smurf
