// SPDX-License-Identifier: BSD-3-Clause
// Multilinear hashing, which is strongly universal for random keys (Lemire and Kaser, "Strongly
// universal string hashing is fast", 2014).
#include "base/numbers/hash.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <exception>
#include <random>

namespace smurf {
namespace {

/// Returns the next random number of splitmix64 and advances its state.
std::uint64_t next_key(std::uint64_t& state) {
  state += 0x9e3779b97f4a7c15U;
  std::uint64_t key = state;
  key = (key ^ key >> 30U) * 0xbf58476d1ce4e5b9U;
  key = (key ^ key >> 27U) * 0x94d049bb133111ebU;
  return key ^ key >> 31U;
}

/// The random keys of a hash: one for each four bytes.
class Keys {
 public:
  Keys() {
    // In Emscripten's library, there is no random device without files.
    try {
      std::random_device random;
      rest_ = std::uint64_t{random()} << 32U | random();
    } catch (const std::exception&) {
      rest_ = static_cast<std::uint64_t>(
          std::chrono::high_resolution_clock::now().time_since_epoch().count());
    }
    for (std::uint64_t& key : first_) key = next_key(rest_);
  }

  /// `state` is rest() at the beginning; it generates the keys for long texts.
  std::uint64_t at(std::size_t i, std::uint64_t& state) const {
    return i < first_.size() ? first_[i] : next_key(state);
  }
  std::uint64_t rest() const { return rest_; }

 private:
  std::array<std::uint64_t, 24> first_{};
  std::uint64_t rest_ = 0;
};

}  // namespace

std::size_t hash_of(std::string_view bytes) {
  static const Keys keys;
  std::uint64_t state = keys.rest();
  std::uint64_t sum = keys.at(0, state) + keys.at(1, state) * bytes.size();
  std::size_t i = 2;
  std::uint32_t word = 0;
  for (; bytes.size() >= sizeof word; bytes.remove_prefix(sizeof word)) {
    std::memcpy(&word, bytes.data(), sizeof word);
    sum += keys.at(i++, state) * word;
  }
  word = 0;
  for (const char c : bytes) word = word << 8U | static_cast<unsigned char>(c);
  sum += keys.at(i, state) * word;
  // Numbered names give numbers at equal distances, which for some keys lie side by side: then a
  // table that searches slot by slot becomes slow.
  sum = (sum ^ sum >> 32U) * 0xd6e8feb86659fd93U;
  return static_cast<std::size_t>((sum ^ sum >> 32U) >> 16U);
}

}  // namespace smurf
