// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/inflate.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace smurf {
namespace {

constexpr std::size_t kLongestCode = 15;

/// A Huffman code in canonical form.
struct Code {
  std::array<std::uint16_t, kLongestCode + 1> count{};  ///< number of codes by length
  std::array<std::uint16_t, 288> symbols{};             ///< in the order of their codes

  /// False if more codes are given than fit.
  bool build(std::span<const std::uint8_t> lengths) {
    count.fill(0);
    for (const std::uint8_t length : lengths) ++count[length];
    count[0] = 0;
    int left = 1;
    for (std::size_t length = 1; length <= kLongestCode; ++length) {
      left = 2 * left - count[length];
      if (left < 0) return false;
    }
    std::array<std::uint16_t, kLongestCode + 2> start{};
    for (std::size_t length = 1; length <= kLongestCode; ++length) {
      start[length + 1] = static_cast<std::uint16_t>(start[length] + count[length]);
    }
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
      if (lengths[symbol] != 0) {
        symbols[start[lengths[symbol]]++] = static_cast<std::uint16_t>(symbol);
      }
    }
    return true;
  }
};

class Inflater {
 public:
  Inflater(std::string_view packed, std::uint64_t most) : packed_(packed), most_(most) {}

  std::optional<std::string> run() {
    bool is_last = false;
    while (!is_last) {
      is_last = bits(1) != 0;
      const std::uint32_t kind = bits(2);
      const bool is_sound = kind == 0   ? stored()
                            : kind == 1 ? fixed()
                            : kind == 2 ? dynamic()
                                        : false;
      if (!is_sound || is_cut_) return std::nullopt;
    }
    return std::move(out_);
  }

 private:
  std::uint32_t bits(unsigned count) {
    while (held_ < count) {
      if (at_ >= packed_.size()) {
        is_cut_ = true;
        return 0;
      }
      buffer_ |= std::uint32_t{static_cast<unsigned char>(packed_[at_++])} << held_;
      held_ += 8;
    }
    const std::uint32_t value = buffer_ & ((std::uint32_t{1} << count) - 1);
    buffer_ >>= count;
    held_ -= count;
    return value;
  }

  /// None for a bit sequence that is not a code.
  std::optional<std::uint16_t> symbol(const Code& code) {
    int value = 0;
    int first = 0;
    int index = 0;
    for (std::size_t length = 1; length <= kLongestCode; ++length) {
      value |= static_cast<int>(bits(1));
      if (is_cut_) return std::nullopt;
      const int count = code.count[length];
      if (value - count < first)
        return code.symbols[static_cast<std::size_t>(index + value - first)];
      index += count;
      first = (first + count) << 1;
      value <<= 1;
    }
    return std::nullopt;
  }

  bool has_room(std::uint64_t more) const { return more <= most_ - out_.size(); }

  bool stored() {
    buffer_ = 0;
    held_ = 0;
    if (packed_.size() - at_ < 4) return false;
    const std::uint32_t size = bits(8) | bits(8) << 8U;
    const std::uint32_t inverse = bits(8) | bits(8) << 8U;
    if (size != (~inverse & 0xffffU) || packed_.size() - at_ < size || !has_room(size))
      return false;
    out_.append(packed_.substr(at_, size));
    at_ += size;
    return true;
  }

  bool fixed() {
    std::array<std::uint8_t, 288> lengths{};
    std::fill(lengths.begin(), lengths.begin() + 144, std::uint8_t{8});
    std::fill(lengths.begin() + 144, lengths.begin() + 256, std::uint8_t{9});
    std::fill(lengths.begin() + 256, lengths.begin() + 280, std::uint8_t{7});
    std::fill(lengths.begin() + 280, lengths.end(), std::uint8_t{8});
    std::array<std::uint8_t, 30> distances{};
    distances.fill(5);
    return literals_.build(lengths) && distances_.build(distances) && compressed();
  }

  bool dynamic() {
    const std::size_t literals = bits(5) + 257;
    const std::size_t distances = bits(5) + 1;
    const std::size_t codes = bits(4) + 4;
    if (is_cut_ || literals > 286 || distances > 30) return false;
    constexpr std::array<std::uint8_t, 19> kOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                  11, 4,  12, 3, 13, 2, 14, 1, 15};
    std::array<std::uint8_t, 19> of_lengths{};
    for (std::size_t i = 0; i < codes; ++i) {
      of_lengths[kOrder[i]] = static_cast<std::uint8_t>(bits(3));
    }
    std::array<std::uint8_t, 320> lengths{};
    if (!literals_.build(of_lengths) || !read_lengths({lengths.data(), literals + distances})) {
      return false;
    }
    const std::span<const std::uint8_t> all(lengths);
    return literals_.build(all.first(literals)) &&
           distances_.build(all.subspan(literals, distances)) && compressed();
  }

  /// Decodes the lengths of both codes with the code in `literals_`.
  bool read_lengths(std::span<std::uint8_t> lengths) {
    std::size_t at = 0;
    while (at < lengths.size()) {
      const auto found = symbol(literals_);
      if (!found) return false;
      if (*found < 16) {
        lengths[at++] = static_cast<std::uint8_t>(*found);
        continue;
      }
      if (*found == 16 && at == 0) return false;
      const std::uint8_t repeated = *found == 16 ? lengths[at - 1] : std::uint8_t{0};
      const std::size_t times = *found == 16   ? 3 + bits(2)
                                : *found == 17 ? 3 + bits(3)
                                               : 11 + bits(7);
      if (times > lengths.size() - at) return false;
      std::fill_n(lengths.begin() + static_cast<std::ptrdiff_t>(at), times, repeated);
      at += times;
    }
    return true;
  }

  bool compressed() {
    constexpr std::array<std::uint16_t, 29> kLengths{3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                                     15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                                     67, 83, 99, 115, 131, 163, 195, 227, 258};
    constexpr std::array<std::uint8_t, 29> kLengthBits{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                                       2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
    constexpr std::array<std::uint16_t, 30> kDistances{
        1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
        193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
    while (true) {
      const auto found = symbol(literals_);
      if (!found) return false;
      if (*found == 256) return true;
      if (*found < 256) {
        if (!has_room(1)) return false;
        out_ += static_cast<char>(*found);
        continue;
      }
      const std::size_t length_at = *found - 257U;
      if (length_at >= kLengths.size()) return false;
      const std::size_t length = kLengths[length_at] + bits(kLengthBits[length_at]);
      const auto place = symbol(distances_);
      if (!place || *place >= kDistances.size()) return false;
      const unsigned more = *place < 2 ? 0 : *place / 2U - 1;
      const std::size_t distance = kDistances[*place] + bits(more);
      if (is_cut_ || distance > out_.size() || !has_room(length)) return false;
      // The copied bytes may include those that this loop appends.
      for (std::size_t i = 0; i < length; ++i) out_ += out_[out_.size() - distance];
    }
  }

  std::string_view packed_;
  std::uint64_t most_;
  std::size_t at_ = 2;  // after the header of zlib
  std::uint32_t buffer_ = 0;
  unsigned held_ = 0;
  bool is_cut_ = false;
  Code literals_, distances_;
  std::string out_;
};

}  // namespace

std::optional<std::string> inflate_zlib(std::string_view packed, std::uint64_t most) {
  constexpr int kDeflate = 8;
  if (packed.size() < 2 || (packed[0] & 0xf) != kDeflate) return std::nullopt;
  return Inflater(packed, most).run();
}

}  // namespace smurf
