// SPDX-License-Identifier: BSD-3-Clause
// Source texts, byte spans into them, and values that know where they were written.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smurf {

/// U+FEFF, which some editors write at the start of a text in UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

enum class SourceId : std::uint32_t {};

/// The language of the file of a robot. A URDF is read as it is; from the others one is made.
enum class Language : std::uint8_t { urdf, xacro, mjcf, sdf };

/// Half-open byte range [begin, end) of one source.
struct Span {
  SourceId source{};
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  bool empty() const { return begin == end; }
  bool contains(std::uint32_t offset) const { return begin <= offset && offset < end; }
  friend bool operator==(const Span&, const Span&) = default;
};

/// 1-based line and column; the column counts Unicode code points.
struct Position {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  friend bool operator==(const Position&, const Position&) = default;
};

/// A value together with the bytes it was read from.
template <class T>
struct Spanned {
  T value{};
  Span span;
};

/// A key or attribute in a file. It has three states: absent, unreadable, readable. `written` is
/// true if it is in the file; it has a value only if the value is readable.
template <class T>
class Field {
 public:
  Field() = default;
  /// A value written at a place; `read` is none if the value is unreadable.
  Field(std::optional<T> read, Span place)
      : value_(read ? *std::move(read) : T{}), span(place), written(true), has_value_(read) {}

  bool has_value() const { return has_value_; }
  explicit operator bool() const { return has_value_; }
  /// Precondition of these two functions: there is a value.
  const T& operator*() const { return value_; }
  const T* operator->() const { return &value_; }
  T& operator*() { return value_; }
  T* operator->() { return &value_; }
  T value_or(T fallback) const { return has_value_ ? value_ : fallback; }
  std::optional<T> value() const { return has_value_ ? std::optional<T>(value_) : std::nullopt; }
  void set(T value) {
    value_ = std::move(value);
    has_value_ = true;
  }

 private:
  T value_{};  // no std::optional, which adds 8 bytes to each of the many fields of a robot

 public:
  Span span;
  bool written = false;

 private:
  bool has_value_ = false;
};

/// The new ids of sources after one map has taken over those of another.
struct SourceShift {
  std::uint32_t first = 0;  ///< sources before it keep their ids
  std::uint32_t by = 0;

  Span operator()(Span span) const {
    const auto id = static_cast<std::uint32_t>(span.source);
    return {id < first ? span.source : SourceId{id + by}, span.begin, span.end};
  }
};

/// Owns the texts of all read files. References and views stay valid as long as the map. A copy
/// shares the texts, because thousands of checked files use the same configuration.
class SourceMap {
 public:
  /// `path` is the name shown to the user, with '/' separators.
  SourceId add(std::string path, std::string text);
  /// Adds a file without a text, to name it in messages about files that cannot be read.
  SourceId add_unreadable(std::string path);
  /// Takes over the sources of a map that began as a copy of the first `common` sources of this
  /// map. A text that was already taken under the same path is kept once, so views into the texts
  /// of the other map may become invalid.
  SourceShift take(SourceMap&& other, std::size_t common);

  const std::string& path(SourceId id) const { return at(id).path; }
  std::string_view text(SourceId id) const { return at(id).text; }
  std::string_view text(Span span) const;
  bool is_readable(SourceId id) const { return at(id).readable; }
  std::size_t size() const { return sources_.size(); }

  /// Precondition: offset <= text(id).size().
  Position position(SourceId id, std::uint32_t offset) const;
  /// The offset of a 1-based line.
  std::uint32_t line_begin(SourceId id, std::uint32_t line) const {
    return line_start(at(id), line);
  }
  /// The number of characters between two bytes that take two units in UTF-16.
  std::uint32_t wide_characters(Span span) const;
  /// The 1-based line that contains the byte.
  std::uint32_t line_of(SourceId id, std::uint32_t offset) const;
  std::uint32_t line_count(SourceId id) const;
  /// Bytes of a 1-based line without its line end.
  Span line_span(SourceId id, std::uint32_t line) const;

 private:
  struct Source {
    std::string path;
    std::string text;
    /// The number of line ends before each block of the text. A table of all lines would be a fifth
    /// as large as the text, and most files are never asked for a line.
    std::vector<std::uint32_t> line_ends_before;
    /// The number of characters before each block, for texts with characters of several bytes.
    std::vector<std::uint32_t> characters_before;
    std::vector<std::uint32_t> wide_before;  ///< the number of characters with two units in UTF-16
    std::uint32_t line_count = 1;
    bool is_ascii = true;  ///< then each byte is a column
    bool readable = true;
  };
  SourceId keep(Source source);
  const Source& at(SourceId id) const { return *sources_[static_cast<std::size_t>(id)]; }
  /// Offset of the first byte of a 1-based line.
  static std::uint32_t line_start(const Source& source, std::uint32_t line);
  /// Characters before a byte.
  static std::uint32_t characters_before(const Source& source, std::uint32_t offset);

  std::vector<std::shared_ptr<const Source>> sources_;
  std::map<std::string, std::shared_ptr<const Source>, std::less<>> taken_;  ///< last of each path
};

}  // namespace smurf
