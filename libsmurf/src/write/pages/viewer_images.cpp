// SPDX-License-Identifier: BSD-3-Clause
#include "write/pages/viewer_images.hpp"

#include "write/text/base64.hpp"

namespace smurf {
namespace {

/// A number whose most significant byte comes first.
std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t number = 0;
  for (const char byte : bytes.substr(at, size)) {
    number = number << 8U | static_cast<unsigned char>(byte);
  }
  return number;
}

std::optional<ImageHead> head_of_jpeg(std::string_view bytes) {
  std::size_t at = 2;
  while (at + 9 <= bytes.size() && bytes[at] == '\xff') {
    const std::uint64_t marker = number_at(bytes, at + 1, 1);
    const bool is_frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (is_frame) {
      return ImageHead{"image/jpeg", number_at(bytes, at + 7, 2), number_at(bytes, at + 5, 2)};
    }
    // The pixels, or the end of the image: the header has ended.
    if (marker == 0xda || marker == 0xd9) return std::nullopt;
    // 0xff may be repeated before a marker, and a few markers have no length.
    const bool is_alone = marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
    at += marker == 0xff ? 1 : is_alone ? 2 : 2 + number_at(bytes, at + 2, 2);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ImageHead> image_head(std::string_view bytes) {
  constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
  if (bytes.starts_with(kPng) && bytes.size() >= 24 && bytes.substr(12, 4) == "IHDR") {
    return ImageHead{"image/png", number_at(bytes, 16, 4), number_at(bytes, 20, 4)};
  }
  return bytes.starts_with("\xff\xd8\xff") ? head_of_jpeg(bytes) : std::nullopt;
}

const ViewerImages::Known& ViewerImages::find(const std::string& file) {
  const auto [known, is_new] = known_.try_emplace(file);
  if (is_new) known->second = read(file);
  return known->second;
}

ViewerImages::Known ViewerImages::read(const std::string& file) {
  if (!scene_.meshes.image) return {std::nullopt, "is not available"};
  const FileContent content = scene_.meshes.image(file);
  if (content.status != ReadStatus::ok) return {std::nullopt, content.reason};
  const std::optional<ImageHead> head = image_head(content.text);
  if (!head || head->width == 0 || head->height == 0) {
    return {std::nullopt, "is neither PNG nor JPEG"};
  }
  // Both sides have at most 32 bits, so the product does not overflow.
  const std::uint64_t pixels = head->width * head->height;
  if (pixels > scene_.meshes.most_pixels - pixels_) {
    return {std::nullopt, "would make more than " + std::to_string(scene_.meshes.most_pixels) +
                              " pixels of textures"};
  }
  if (content.text.size() > scene_.meshes.most_bytes - bytes_) {
    return {std::nullopt, "is too large to write"};
  }
  pixels_ += pixels;
  bytes_ += content.text.size();
  shown_.push_back({file, head->type, base64(content.text)});
  return {shown_.size() - 1, {}};
}

void ViewerImages::print(JsonPrinter& json) const {
  json.begin_list(JsonPrinter::Layout::block);
  for (const Shown& image : shown_) {
    json.begin_object();
    json.member("file", image.file);
    json.member("type", image.type);
    json.member("bytes", image.bytes);
    json.end();
  }
  json.end();
}

}  // namespace smurf
