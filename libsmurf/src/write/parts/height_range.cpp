// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/height_range.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "archive/inflate.hpp"

namespace smurf {
namespace {

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (const char byte : bytes.substr(at, 4)) {
    number = number << 8U | static_cast<unsigned char>(byte);
  }
  return number;
}

struct PngImage {
  std::uint32_t width = 0, height = 0;
  unsigned depth = 0, kind = 0;  ///< as in IHDR
  bool is_interlaced = false;
  std::string palette, packed;

  unsigned channels() const { return kind == 2 ? 3 : kind == 4 ? 2 : kind == 6 ? 4 : 1; }
  bool has_palette() const { return kind == 3; }
};

bool read_chunks(std::string_view png, PngImage& image) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kFrame = 12;  // length, name and checksum
  std::size_t at = kSignature;
  while (png.size() >= at + kFrame) {
    const std::size_t size = number_at(png, at);
    const std::string_view name = png.substr(at + 4, 4);
    if (size > png.size() - at - kFrame) return false;
    const std::string_view content = png.substr(at + 8, size);
    if (name == "IHDR" && size >= 13) {
      image.width = number_at(content, 0);
      image.height = number_at(content, 4);
      image.depth = static_cast<unsigned char>(content[8]);
      image.kind = static_cast<unsigned char>(content[9]);
      image.is_interlaced = content[12] != 0;
    } else if (name == "PLTE") {
      image.palette = content;
    } else if (name == "IDAT") {
      image.packed += content;
    } else if (name == "IEND") {
      return true;
    }
    at += size + kFrame;
  }
  return false;
}

bool is_sound(const PngImage& image) {
  const unsigned depth = image.depth;
  const bool is_small = depth == 1 || depth == 2 || depth == 4;
  const bool has_depth = image.kind == 0   ? is_small || depth == 8 || depth == 16
                         : image.kind == 3 ? is_small || depth == 8
                                           : depth == 8 || depth == 16;
  return has_depth &&
         (image.kind == 0 || image.kind == 2 || image.kind == 3 || image.kind == 4 ||
          image.kind == 6) &&
         image.width > 0 && image.height > 0;
}

/// Undoes the filter of a row, given the row above it.
bool unfilter(unsigned filter, std::string& row, const std::string& above, std::size_t pixel) {
  const auto byte = [](const std::string& bytes, std::size_t at) -> int {
    return static_cast<unsigned char>(bytes[at]);
  };
  if (filter > 4) return false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int a = i >= pixel ? byte(row, i - pixel) : 0;
    const int b = byte(above, i);
    const int c = i >= pixel ? byte(above, i - pixel) : 0;
    int guess = 0;
    if (filter == 1) guess = a;
    if (filter == 2) guess = b;
    if (filter == 3) guess = (a + b) / 2;
    if (filter == 4) {
      const int pa = std::abs(b - c);
      const int pb = std::abs(a - c);
      const int pc = std::abs(a + b - 2 * c);
      guess = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
    }
    row[i] = static_cast<char>(byte(row, i) + guess);
  }
  return true;
}

class RangeReader {
 public:
  RangeReader(const PngImage& image, HeightRange& range) : image_(image), range_(range) {
    range_.darkest = 1;
  }

  /// Reads the rows of an image of this size; false if bytes are missing.
  bool pass(std::string_view& bytes, std::uint32_t width, std::uint32_t height) {
    if (width == 0 || height == 0) return true;
    const std::uint64_t bits = std::uint64_t{image_.channels()} * image_.depth;
    const auto stride = static_cast<std::size_t>((bits * width + 7) / 8);
    const auto pixel = static_cast<std::size_t>(std::max<std::uint64_t>(1, bits / 8));
    std::string above(stride, '\0');
    for (std::uint32_t y = 0; y < height; ++y) {
      if (bytes.size() < stride + 1) return false;
      std::string row(bytes.substr(1, stride));
      if (!unfilter(static_cast<unsigned char>(bytes[0]), row, above, pixel)) return false;
      bytes.remove_prefix(stride + 1);
      for (std::uint32_t x = 0; x < width; ++x) add(row, x);
      above = std::move(row);
    }
    return true;
  }

 private:
  void add(const std::string& row, std::uint32_t x) {
    const unsigned channels = image_.channels();
    std::array<unsigned, 3> rgb{};
    const unsigned colors = channels >= 3 ? 3 : 1;
    for (unsigned i = 0; i < colors; ++i) rgb[i] = sample(row, std::size_t{x} * channels + i);
    double white = (1U << image_.depth) - 1;
    if (image_.has_palette()) {
      white = 255;
      const std::size_t at = 3 * std::size_t{rgb[0]};
      for (std::size_t i = 0; i < 3; ++i) {
        rgb[i] =
            at + i < image_.palette.size() ? static_cast<unsigned char>(image_.palette[at + i]) : 0;
      }
    } else if (colors == 1) {
      rgb[1] = rgb[2] = rgb[0];
    }
    range_.is_grey = range_.is_grey && rgb[0] == rgb[1] && rgb[0] == rgb[2];
    range_.darkest = std::min(range_.darkest, rgb[0] / white);
    range_.brightest = std::max(range_.brightest, rgb[0] / white);
  }

  unsigned sample(const std::string& row, std::size_t at) const {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(row[i]); };
    if (image_.depth == 8) return byte(at);
    if (image_.depth == 16) return byte(2 * at) * 256U + byte(2 * at + 1);
    const std::size_t bit = at * image_.depth;
    const unsigned shift = 8U - image_.depth - static_cast<unsigned>(bit % 8);
    return (byte(bit / 8) >> shift) & ((1U << image_.depth) - 1);
  }

  const PngImage& image_;
  HeightRange& range_;
};

/// Every pass of an interlaced image is an image of its own.
bool read_passes(const PngImage& image, std::string_view bytes, HeightRange& range) {
  RangeReader reader(image, range);
  if (!image.is_interlaced) return reader.pass(bytes, image.width, image.height);
  struct Pass {
    std::uint32_t x, y, step_x, step_y;
  };
  constexpr Pass kPasses[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                              {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  return std::all_of(std::begin(kPasses), std::end(kPasses), [&](const Pass& pass) {
    const std::uint64_t width =
        (std::uint64_t{image.width} + pass.step_x - 1 - pass.x) / pass.step_x;
    const std::uint64_t height =
        (std::uint64_t{image.height} + pass.step_y - 1 - pass.y) / pass.step_y;
    return reader.pass(bytes, static_cast<std::uint32_t>(width),
                       static_cast<std::uint32_t>(height));
  });
}

}  // namespace

HeightRange height_range(std::string_view png, std::uint64_t most) {
  HeightRange range;
  PngImage image;
  if (!read_chunks(png, image) || !is_sound(image)) return {.fault = "is damaged"};
  range.width = image.width;
  range.height = image.height;
  const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
  if (pixels > most) return {.fault = "has more than " + std::to_string(most) + " pixels"};
  // A row has one byte for its filter; the passes of an interlaced image have more rows.
  const std::uint64_t row =
      (std::uint64_t{image.width} * image.channels() * image.depth + 7) / 8 + 8;
  const auto bytes = inflate_zlib(image.packed, 2 * (row + 1) * (std::uint64_t{image.height} + 8));
  if (!bytes || !read_passes(image, *bytes, range)) return {.fault = "is damaged"};
  return range;
}

}  // namespace smurf
