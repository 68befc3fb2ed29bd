// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/gltf_names.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace smurf::gltf {
namespace {

/// Tracks how far a parser has read.
class TrackedByte {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  TrackedByte(const char* at, const char** latest) : at_(at), latest_(latest) {}

  const char& operator*() const { return *at_; }
  TrackedByte& operator++() {
    *latest_ = ++at_;
    return *this;
  }
  TrackedByte operator++(int) {
    const TrackedByte before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const TrackedByte& a, const TrackedByte& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  const char** latest_;
};

/// Finds each `uri` of an item of `buffers` or `images`.
class UriFinder : public Json::json_sax_t {
 public:
  UriFinder(std::string_view text, std::vector<MeshDependency>& found)
      : text_(text), latest_(text.data()), found_(found) {}

  void find() {
    const char* end = text_.data() + text_.size();
    Json::sax_parse(TrackedByte(text_.data(), &latest_), TrackedByte(end, &latest_), this);
  }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override {
    return false;
  }

  bool key(string_t& name) override {
    if (level_ == kInFile) list_ = name;
    if (level_ == kInItem) key_ = name;
    return true;
  }

  bool string(string_t& value) override {
    const bool is_buffer = list_ == "buffers";
    if (level_ != kInItem || key_ != "uri" || (!is_buffer && list_ != "images")) return true;
    if (value.starts_with("data:")) return true;
    const auto end = static_cast<std::size_t>(latest_ - text_.data()) - 1;
    const std::size_t begin = begin_of_text(end);
    found_.push_back(
        {.filename = value,
         .kind = is_buffer ? MeshDependency::Kind::buffer : MeshDependency::Kind::texture,
         .line = line_of(begin),
         .offset = begin,
         .length = end - begin});
    return true;
  }

 private:
  static constexpr std::size_t kInFile = 1;  ///< {
  static constexpr std::size_t kInItem = 3;  ///< {"buffers": [{

  bool enter() {
    ++level_;
    return true;
  }

  bool leave() {
    --level_;
    return true;
  }

  /// The position after the opening quotation mark of the text that ends at `end`. Quotation marks
  /// inside the text have backslashes.
  std::size_t begin_of_text(std::size_t end) const {
    for (std::size_t at = end; at > 0; --at) {
      if (text_[at - 1] != '"') continue;
      std::size_t backslashes = 0;
      while (backslashes + 1 < at && text_[at - 2 - backslashes] == '\\') ++backslashes;
      if (backslashes % 2 == 0) return at;
    }
    return 0;
  }

  std::uint32_t line_of(std::size_t offset) {
    lines_ += static_cast<std::uint32_t>(
        std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                   text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
    counted_ = offset;
    return lines_;
  }

  std::string_view text_;
  const char* latest_;
  std::vector<MeshDependency>& found_;
  std::size_t level_ = 0;
  std::string list_, key_;
  std::uint32_t lines_ = 1;
  std::size_t counted_ = 0;
};

bool names_files(const Json& json) {
  for (const char* list : {"buffers", "images"}) {
    const Json* items = member(json, list);
    if (items == nullptr || !items->is_array()) continue;
    for (const Json& item : *items) {
      const Json* uri = member(item, "uri");
      if (uri != nullptr && uri->is_string() &&
          !uri->get_ref<const std::string&>().starts_with("data:")) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

std::vector<MeshDependency> names_in(const Data& data) {
  std::vector<MeshDependency> found;
  if (!names_files(data.json())) return found;  // saves parsing it again
  UriFinder(data.text(), found).find();
  for (MeshDependency& named : found) {
    named.offset += data.text_offset();
    if (data.is_binary()) named.line = 0;
  }
  return found;
}

}  // namespace smurf::gltf
