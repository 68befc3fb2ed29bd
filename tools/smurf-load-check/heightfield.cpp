// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/heightfield.hpp"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <string_view>

#include "base/findings/limits.hpp"

namespace smurf::load_check {
namespace {

/// libpng returns errors by longjmp, which does not run destructors, so objects with destructors
/// are here.
struct PngReading {
  std::string_view left;  ///< to be read
  std::uint64_t most_pixels = 0;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string fault;
  std::vector<png_byte> bytes;
  std::vector<png_bytep> rows;

  PngReading(std::string_view file, std::uint64_t most) : left(file), most_pixels(most) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    info = png_create_info_struct(png);
  }
  ~PngReading() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReading(const PngReading&) = delete;
  PngReading& operator=(const PngReading&) = delete;

  [[noreturn]] static void on_error(png_structp png, png_const_charp message) {
    static_cast<PngReading*>(png_get_error_ptr(png))->fault = message;
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}

  static void read(png_structp png, png_bytep to, std::size_t size) {
    std::string_view& left = static_cast<PngReading*>(png_get_io_ptr(png))->left;
    if (size > left.size()) png_error(png, "the file is cut short");
    std::memcpy(to, left.data(), size);
    left.remove_prefix(size);
  }
};

std::size_t rows_of(const PngReading& reading) {
  return png_get_image_height(reading.png, reading.info);
}

/// Texts and profiles are skipped: unpacked, they can be a thousand times larger, and they contain
/// no heights.
void skip_other_chunks(png_structp png) {
  static constexpr png_byte kChunks[] =
      "eXIf\0hIST\0iCCP\0iTXt\0pCAL\0sCAL\0sPLT\0tEXt\0tIME\0zTXt";
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kChunks, sizeof kChunks / 5);
}

/// One grey value of 16 bits per pixel, the more significant byte first.
void decode(PngReading& reading) {
  skip_other_chunks(reading.png);
  png_set_read_fn(reading.png, &reading, PngReading::read);
  png_read_info(reading.png, reading.info);
  png_set_expand_16(reading.png);
  png_set_strip_alpha(reading.png);
  if ((png_get_color_type(reading.png, reading.info) & PNG_COLOR_MASK_COLOR) != 0) {
    png_set_rgb_to_gray(reading.png, PNG_ERROR_ACTION_NONE, PNG_RGB_TO_GRAY_DEFAULT,
                        PNG_RGB_TO_GRAY_DEFAULT);
  }
  png_set_interlace_handling(reading.png);
  png_read_update_info(reading.png, reading.info);
  const std::uint64_t pixels =
      std::uint64_t{png_get_image_width(reading.png, reading.info)} * rows_of(reading);
  if (pixels > reading.most_pixels) png_error(reading.png, "it has too many pixels");
  const std::size_t stride = png_get_rowbytes(reading.png, reading.info);
  reading.bytes.resize(stride * rows_of(reading));
  for (std::size_t row = 0; row < rows_of(reading); ++row) {
    reading.rows.push_back(reading.bytes.data() + row * stride);
  }
  png_read_image(reading.png, reading.rows.data());
}

/// Reads the image; false if libpng reports an error.
bool read_grey(PngReading& reading) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) return false;
  decode(reading);
  return true;
}

}  // namespace

std::variant<HeightImage, std::string>
read_height_image(const std::string& path, const ShapeFiles& from, std::uint64_t most) {
  const FileContent content = from.files.read(path, from.limits.mesh_bytes);
  if (content.status != ReadStatus::ok) return content.reason;
  PngReading reading(content.text, most);
  if (!read_grey(reading)) {
    const std::uint64_t pixels =
        std::uint64_t{png_get_image_width(reading.png, reading.info)} * rows_of(reading);
    if (pixels <= most) return reading.fault;
    const std::uint64_t all = from.limits.image_pixels;
    return "it has " + std::to_string(pixels) + " pixels, more than " +
           (most < all ? "are left of " : "") + std::to_string(all) + "; " +
           raise_limit("image-pixels");
  }
  HeightImage image;
  image.columns = png_get_image_width(reading.png, reading.info);
  image.rows = rows_of(reading);
  if (image.columns < 2 || image.rows < 2) return std::string("it has fewer than 2 x 2 pixels");
  constexpr float kWhite = 65535;
  image.heights.reserve(image.columns * image.rows);
  for (std::size_t i = 0; i < image.columns * image.rows; ++i) {
    const int grey = reading.bytes[2 * i] * 256 + reading.bytes[2 * i + 1];
    image.heights.push_back(static_cast<float>(grey) / kWhite);
  }
  return image;
}

}  // namespace smurf::load_check
