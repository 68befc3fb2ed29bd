// SPDX-License-Identifier: BSD-3-Clause
#include "render/line_hash.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>

#include "base/text/utf8.hpp"

namespace smurf::render {
namespace {

constexpr std::size_t kWindow = 100;
constexpr std::uint64_t kFactor = 37;
constexpr std::uint16_t kEnd = 0xFFFF;
constexpr std::size_t kNoLine = static_cast<std::size_t>(-1);

constexpr std::uint64_t power_of_factor() {
  std::uint64_t power = 1;
  for (std::size_t i = 0; i < kWindow; ++i) power *= kFactor;
  return power;
}

/// A rolling hash: the value for a line is known after the window has moved past its start.
class Hasher {
 public:
  Hasher() { starting_.fill(kNoLine); }

  void take(std::uint16_t unit) {
    const bool is_rest_of_line_end = after_return_ && unit == '\n';
    after_return_ = unit == '\r';
    if (unit == ' ' || unit == '\t' || is_rest_of_line_end) return;
    if (unit == '\r') unit = '\n';
    finish_line();
    if (at_line_start_) {
      starting_[at_] = hashes_.size();
      hashes_.push_back(0);
    }
    at_line_start_ = unit == '\n';
    roll(unit);
  }

  std::vector<std::uint64_t> finish() {
    take(kEnd);
    for (std::size_t i = 0; i < kWindow; ++i) {
      finish_line();
      roll(0);
    }
    return std::move(hashes_);
  }

 private:
  void finish_line() {
    if (starting_[at_] == kNoLine) return;
    hashes_[starting_[at_]] = hash_;
    starting_[at_] = kNoLine;
  }

  void roll(std::uint16_t unit) {
    constexpr std::uint64_t kPower = power_of_factor();
    hash_ = kFactor * hash_ + unit - kPower * window_[at_];
    window_[at_] = unit;
    at_ = (at_ + 1) % kWindow;
  }

  std::array<std::uint16_t, kWindow> window_{};
  std::array<std::size_t, kWindow> starting_{};  ///< the line that begins with this unit
  std::size_t at_ = 0;
  std::uint64_t hash_ = 0;
  bool at_line_start_ = true;
  bool after_return_ = false;
  std::vector<std::uint64_t> hashes_;
};

}  // namespace

LineHashes::LineHashes(std::string_view text) {
  Hasher hasher;
  while (!text.empty()) {
    const utf8::CodePoint point = utf8::decode(text);
    if (point.value >= 0x10000) {
      const auto rest = static_cast<std::uint32_t>(point.value) - 0x10000U;
      hasher.take(static_cast<std::uint16_t>(0xD800U + (rest >> 10U)));
      hasher.take(static_cast<std::uint16_t>(0xDC00U + (rest & 0x3FFU)));
    } else {
      hasher.take(static_cast<std::uint16_t>(point.value));
    }
    text.remove_prefix(point.size);
  }
  hashes_ = hasher.finish();
  // Sorted, equal hashes follow each other. A table could be made slow by the lines of a file.
  std::vector<std::uint32_t> order(hashes_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
    return hashes_[a] != hashes_[b] ? hashes_[a] < hashes_[b] : a < b;
  });
  occurrences_.resize(hashes_.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_repeated = i > 0 && hashes_[order[i]] == hashes_[order[i - 1]];
    occurrences_[order[i]] = is_repeated ? occurrences_[order[i - 1]] + 1 : 1;
  }
}

std::string LineHashes::of(std::size_t line) const {
  const std::size_t index = std::min(line, hashes_.size() - 1);
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), hashes_[index], 16);
  return std::string(digits.data(), end.ptr) + ":" + std::to_string(occurrences_[index]);
}

}  // namespace smurf::render
