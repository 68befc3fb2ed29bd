// SPDX-License-Identifier: BSD-3-Clause
#include "archive/inflate.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>

namespace smurf {

std::optional<std::string> inflate_zlib(std::string_view packed, std::uint64_t most) {
  constexpr int kDeflate = 8, kWithoutHeader = -15;
  if (packed.size() < 2 || (packed[0] & 0xf) != kDeflate) return std::nullopt;
  z_stream stream{};
  if (inflateInit2(&stream, kWithoutHeader) != Z_OK) return std::nullopt;
  std::string out;
  std::array<unsigned char, 1 << 16> piece;  // filled by inflate()
  int result = Z_OK;
  for (packed.remove_prefix(2); result == Z_OK && out.size() <= most;) {
    if (stream.avail_in == 0) {  // counted in 32 bits; zlib does not write there
      const std::size_t next = std::min<std::size_t>(packed.size(), 1 << 30);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
      stream.avail_in = static_cast<uInt>(next);
      packed.remove_prefix(next);
    }
    stream.next_out = piece.data();
    stream.avail_out = static_cast<uInt>(piece.size());
    result = inflate(&stream, Z_NO_FLUSH);
    out.append(reinterpret_cast<const char*>(piece.data()), piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (result != Z_STREAM_END || out.size() > most) return std::nullopt;
  return out;
}

}  // namespace smurf
