// SPDX-License-Identifier: BSD-3-Clause
// The data of glTF 2.0: the JSON, the buffers beside it, and the numbers in them.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/numbers/little_endian.hpp"
#include "smurf/mesh_triangles.hpp"
#include "smurf/pose.hpp"

namespace smurf::gltf {

using Json = nlohmann::json;

/// Null if `object` is not an object, or has no such member.
const Json* member(const Json& object, const char* name);
/// Returns the value as a natural number, or none if it is not one.
std::optional<std::uint64_t> natural(const Json* value);
bool is_text(const Json* value, std::string_view text);
/// Finite numbers only.
bool read_numbers(const Json* list, std::span<double> numbers);

/// Types of components.
inline constexpr std::uint64_t kByte = 5121;
inline constexpr std::uint64_t kShort = 5123;
inline constexpr std::uint64_t kInt = 5125;
inline constexpr std::uint64_t kFloat = 5126;

/// The numbers of an accessor. They are read one by one, because accessors may overlap any number
/// of times.
struct Accessor {
  std::string_view bytes;  ///< bytes from the first number on
  std::size_t stride = 0;
  std::uint64_t count = 0;
  std::uint64_t type = 0;    ///< of a component
  std::uint64_t number = 0;  ///< index in the list of accessors

  /// Precondition: the type is an index type, and place < count.
  std::uint32_t index(std::uint64_t place) const {
    const std::size_t at = static_cast<std::size_t>(place) * stride;
    const auto byte = [&](std::size_t i) {
      return std::uint32_t{static_cast<unsigned char>(bytes[at + i])};
    };
    if (type == kByte) return byte(0);
    return type == kShort ? byte(0) | byte(1) << 8U : read_uint32(bytes, at);
  }
  /// Precondition: the type is float, and place < count.
  Vector3 point(std::uint64_t place) const {
    const std::size_t at = static_cast<std::size_t>(place) * stride;
    return {read_float(bytes, at), read_float(bytes, at + 4), read_float(bytes, at + 8)};
  }
  /// Precondition: two components, which are not integers of four bytes, and place < count.
  std::array<double, 2> texture_point(std::uint64_t place) const;
};

/// Reads the data of a file. A file that is not broken may still be unsupported.
inline constexpr std::string_view kBroken = "is broken: ";

class Data {
 public:
  /// Both must outlive this object.
  Data(std::string_view bytes, const MeshNeighbours& neighbours);

  /// The reason why the file cannot be read, or empty. For a broken file, it begins with kBroken.
  const std::string& reason() const { return reason_; }
  bool is_broken() const { return reason_.starts_with(kBroken); }
  /// The name, as written, of the file that is too short for its data; empty if there is none.
  const std::string& short_buffer() const { return short_buffer_; }
  /// Always false.
  bool fail_broken(const std::string& what);
  bool fail_unread(std::string what);

  const Json& json() const { return json_; }
  /// The bytes of the JSON, and their offset in the file.
  std::string_view text() const { return text_; }
  std::size_t text_offset() const { return text_offset_; }
  bool is_binary() const { return text_offset_ > 0; }
  /// The number of bytes read, of the file and all its buffers.
  std::uint64_t bytes() const { return bytes_; }
  /// An item of a list of the file; if it does not exist, null and a reason.
  const Json* item(const char* list, const Json* index);
  /// Reads an accessor of this type ("VEC3"). On failure, returns none and sets the reason.
  std::optional<Accessor> accessor(const Json* index, std::string_view type);

 private:
  bool read_binary(std::string_view bytes);
  bool read_json(std::string_view text);
  bool check_extensions();
  std::optional<std::string_view> buffer(const Json* index);
  bool read_buffer(const Json& buffer, std::string_view& bytes);
  /// The content of a file beside this one. It is read once, even if many buffers name it.
  bool read_file(const std::string& name, std::string_view& bytes);

  const MeshNeighbours& neighbours_;
  Json json_;
  std::string_view chunk_;  ///< the buffer in a binary file
  bool has_chunk_ = false;
  std::map<std::uint64_t, std::string_view> buffers_;
  std::map<std::string, std::string_view> files_;  ///< by name
  std::deque<std::string> contents_;               ///< bytes of files and embedded buffers
  std::string_view text_;
  std::size_t text_offset_ = 0;
  std::uint64_t bytes_;
  std::string reason_;
  std::string short_buffer_;
};

}  // namespace smurf::gltf
