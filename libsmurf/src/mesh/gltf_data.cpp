// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/gltf_data.hpp"

#include <cmath>

#include "base/files/path.hpp"
#include "base/files/uri.hpp"
#include "base/numbers/little_endian.hpp"
#include "base/text/quoted.hpp"
#include "base/text/utf8.hpp"
#include "mesh/base64_text.hpp"

namespace smurf::gltf {
namespace {

/// A value of JSON needs up to fifty bytes of memory; in large files, the numbers are in buffers.
constexpr std::size_t kMostValues = 1'000'000;
constexpr std::size_t kMostLevels = 64;
/// Sums and products of larger numbers might overflow.
constexpr std::uint64_t kMost = std::uint64_t{1} << 40U;

/// Ignores the contents of texts. The result for a text that is not JSON is arbitrary.
bool is_too_complex(std::string_view text) {
  std::size_t values = 0;
  std::size_t level = 0;
  bool is_in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_in_text && c == '\\') {
      ++i;
    } else if (c == '"') {
      is_in_text = !is_in_text;
    } else if (is_in_text) {
      continue;
    } else if (c == '[' || c == '{') {
      if (++level > kMostLevels) return true;
      ++values;
    } else if (c == ']' || c == '}') {
      if (level > 0) --level;
    } else if (c == ',') {
      ++values;
    }
  }
  return values > kMostValues;
}

std::size_t size_of(std::uint64_t type) {
  switch (type) {
  case kByte: return 1;
  case kShort: return 2;
  case kInt:
  case kFloat: return 4;
  default: return 0;
  }
}

/// Extensions that do not move triangles.
bool is_harmless(std::string_view extension) {
  for (const std::string_view start :
       {"KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "KHR_xmp"}) {
    if (extension.starts_with(start)) return true;
  }
  return false;
}

}  // namespace

const Json* member(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

std::optional<std::uint64_t> natural(const Json* value) {
  if (value == nullptr || !value->is_number_unsigned()) return std::nullopt;
  const auto number = value->get<std::uint64_t>();
  return number <= kMost ? std::optional(number) : std::nullopt;
}

bool is_text(const Json* value, std::string_view text) {
  return value != nullptr && value->is_string() && value->get_ref<const std::string&>() == text;
}

bool read_numbers(const Json* list, std::span<double> numbers) {
  if (list == nullptr || !list->is_array() || list->size() != numbers.size()) return false;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Json& value = (*list)[i];
    if (!value.is_number()) return false;
    numbers[i] = value.get<double>();
    if (!std::isfinite(numbers[i])) return false;
  }
  return true;
}

std::array<double, 2> Accessor::texture_point(std::uint64_t place) const {
  const std::size_t at = static_cast<std::size_t>(place) * stride;
  const auto byte = [&](std::size_t i) {
    return static_cast<double>(static_cast<unsigned char>(bytes[at + i]));
  };
  if (type == kFloat) return {read_float(bytes, at), read_float(bytes, at + 4)};
  if (type == kByte) return {byte(0) / 255, byte(1) / 255};
  return {(byte(0) + 256 * byte(1)) / 65535, (byte(2) + 256 * byte(3)) / 65535};
}

Data::Data(std::string_view bytes, const MeshNeighbours& neighbours)
    : neighbours_(neighbours), bytes_(bytes.size()) {
  if (bytes.starts_with("glTF") ? read_binary(bytes) : read_json(bytes)) check_extensions();
}

bool Data::fail_broken(const std::string& what) { return fail_unread(std::string(kBroken) + what); }

bool Data::fail_unread(std::string what) {
  if (reason_.empty()) reason_ = std::move(what);
  return false;
}

bool Data::read_binary(std::string_view bytes) {
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  constexpr std::uint32_t kJson = 0x4e4f534aU;
  constexpr std::uint32_t kBinary = 0x004e4942U;
  if (bytes.size() < kHeader + kChunkHeader) return fail_broken("the file ends in its header");
  if (read_uint32(bytes, 4) != 2) {
    return fail_unread("is glTF " + std::to_string(read_uint32(bytes, 4)) + ", which is not read");
  }
  bool has_json = false;
  std::size_t at = kHeader;
  for (std::size_t chunk = 0; chunk < 2 && at + kChunkHeader <= bytes.size(); ++chunk) {
    const std::uint32_t size = read_uint32(bytes, at);
    const std::uint32_t type = read_uint32(bytes, at + 4);
    at += kChunkHeader;
    if (size > bytes.size() - at) return fail_broken("a chunk is longer than the file");
    const std::string_view content = bytes.substr(at, size);
    if (chunk == 0) {
      text_offset_ = at;
      has_json = type == kJson && read_json(content);
      if (!has_json) return fail_broken("the first chunk is not JSON");
    } else if (type == kBinary) {
      chunk_ = content;
      has_chunk_ = true;
    }
    at += size;
  }
  return has_json;
}

bool Data::read_json(std::string_view text) {
  if (is_too_complex(text)) return fail_unread("has too much JSON to be read");
  text_ = text;
  json_ = Json::parse(text.begin(), text.end(), nullptr, false);
  if (!json_.is_object()) return fail_broken("it is not JSON");
  const Json* asset = member(json_, "asset");
  const Json* version = asset == nullptr ? nullptr : member(*asset, "version");
  if (version == nullptr || !version->is_string())
    return fail_broken("it does not state the version of glTF");
  const auto& written = version->get_ref<const std::string&>();
  return written.starts_with("2.") ||
         fail_unread("is glTF " + shortened(utf8::replace_controls(written), 20) +
                     ", which is not read");
}

bool Data::check_extensions() {
  const Json* required = member(json_, "extensionsRequired");
  if (required == nullptr || !required->is_array()) return true;
  for (const Json& extension : *required) {
    if (!extension.is_string()) continue;
    const auto& name = extension.get_ref<const std::string&>();
    if (!is_harmless(name)) {
      return fail_unread("needs " + shortened(utf8::replace_controls(name), 80) +
                         " of glTF, which is not read");
    }
  }
  return true;
}

const Json* Data::item(const char* list, const Json* index) {
  const Json* items = member(json_, list);
  const auto place = natural(index);
  if (items != nullptr && items->is_array() && place && *place < items->size()) {
    return &(*items)[static_cast<std::size_t>(*place)];
  }
  fail_broken("it refers to one of its " + std::string(list) + " that does not exist");
  return nullptr;
}

std::optional<Accessor> Data::accessor(const Json* index, std::string_view type) {
  const Json* written = item("accessors", index);
  if (written == nullptr) return std::nullopt;
  if (member(*written, "sparse") != nullptr) {
    fail_unread("has sparse accessors, which are not read");
    return std::nullopt;
  }
  const Json* view = item("bufferViews", member(*written, "bufferView"));
  const auto bytes = view == nullptr ? std::nullopt : buffer(member(*view, "buffer"));
  if (!bytes) return std::nullopt;
  const auto number = [](const Json& object, const char* name, std::uint64_t absent) {
    const Json* value = member(object, name);
    return value == nullptr ? std::optional(absent) : natural(value);
  };
  const auto start = number(*view, "byteOffset", 0);
  const auto length = number(*view, "byteLength", kMost + 1);
  const auto offset = number(*written, "byteOffset", 0);
  const auto count = number(*written, "count", 0);
  const auto component = number(*written, "componentType", 0);
  const std::size_t components = type == "VEC3" ? 3 : type == "VEC2" ? 2 : 1;
  const std::size_t size = component ? size_of(*component) * components : 0;
  const auto stride = number(*view, "byteStride", size);
  if (!start || !length || !offset || !count || size == 0 || !stride || *stride < size ||
      !is_text(member(*written, "type"), type)) {
    fail_broken("an accessor is invalid");
    return std::nullopt;
  }
  if (*start + *length > bytes->size() ||
      (*count > 0 &&
       (*count > kMost / *stride || *offset + (*count - 1) * *stride + size > *length))) {
    fail_broken("an accessor refers to bytes beyond the end of its buffer");
    return std::nullopt;
  }
  if (*count == 0) return Accessor{{}, size, 0, *component, *natural(index)};
  return Accessor{bytes->substr(static_cast<std::size_t>(*start + *offset)),
                  static_cast<std::size_t>(*stride), *count, *component, *natural(index)};
}

std::optional<std::string_view> Data::buffer(const Json* index) {
  const Json* written = item("buffers", index);
  if (written == nullptr) return std::nullopt;
  const std::uint64_t place = *natural(index);
  if (place == 0 && has_chunk_ && member(*written, "uri") == nullptr) return chunk_;
  const auto [known, is_new] = buffers_.try_emplace(place);
  if (is_new && !read_buffer(*written, known->second)) return std::nullopt;
  return known->second;
}

bool Data::read_buffer(const Json& buffer, std::string_view& bytes) {
  const Json* written = member(buffer, "uri");
  if (written == nullptr || !written->is_string()) return fail_broken("a buffer has no data");
  const std::string_view uri = written->get_ref<const std::string&>();
  if (uri.starts_with("data:")) {
    constexpr std::string_view kBase64 = ";base64,";
    const std::size_t comma = uri.find(',');
    const bool is_base64 = comma != std::string_view::npos && comma + 1 >= kBase64.size() &&
                           uri.substr(0, comma + 1).ends_with(kBase64);
    auto content = is_base64 ? from_base64(uri.substr(comma + 1)) : std::nullopt;
    if (!content) return fail_broken("the data of a buffer is not base64");
    bytes = contents_.emplace_back(std::move(*content));
    bytes_ += bytes.size();
    return true;
  }
  const std::string name = decoded_uri(uri);
  const std::string shown = smurf::quoted(utf8::replace_controls(name));
  if (path::is_absolute(name) || name.find(':') != std::string::npos) {
    return fail_unread("has its points in " + shown + ", which is not a file beside it");
  }
  if (!read_file(name, bytes)) return false;
  const auto length = natural(member(buffer, "byteLength"));
  if (!length || *length <= bytes.size()) return true;
  short_buffer_ = uri;
  return fail_broken("the buffer " + shown + " has " + std::to_string(bytes.size()) + " of " +
                     std::to_string(*length) + " bytes");
}

bool Data::read_file(const std::string& name, std::string_view& bytes) {
  const auto [known, is_new] = files_.try_emplace(name);
  if (is_new) {
    FileContent content = neighbours_ ? neighbours_(name) : FileContent{};
    const std::string shown = smurf::quoted(utf8::replace_controls(name));
    if (content.status == ReadStatus::not_found) {
      return fail_unread("has its points in " + shown + ", which does not exist");
    }
    if (content.status != ReadStatus::ok) {
      return fail_unread("has its points in " + shown +
                         ", which cannot be read: " + content.reason);
    }
    known->second = contents_.emplace_back(std::move(content.text));
    bytes_ += known->second.size();
  }
  bytes = known->second;
  return true;
}

}  // namespace smurf::gltf
