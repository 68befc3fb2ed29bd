// SPDX-License-Identifier: BSD-3-Clause
// Writes an XML text that is made from a file of another language, and remembers where each part of
// it comes from.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/xacro.hpp"

namespace smurf::imports {

/// Where a value was written, and where it acts.
struct Place {
  Span origin;  ///< the bytes to blame
  Span use;     ///< the tag that the value acts on
  xacro::FrameId frame = xacro::kNoFrame;
  bool is_exact = false;  ///< the bytes of the value are those of `origin`
};

class TracedXml {
 public:
  /// `most`: the bytes of the text after which nothing is added to it.
  explicit TracedXml(xacro::Expansion& expansion, std::uint64_t most = ~std::uint64_t{0})
      : leaves_(expansion.leaves), most_(most) {
    text_ = "<?xml version=\"1.0\" ?>\n";
  }

  /// An element that stands for one of the file; `is_made`: nobody wrote it, or the value.
  void open(std::string_view name, const Place& place, bool is_made = false);
  void attribute(std::string_view name, std::string_view value, const Place& place,
                 bool is_made = false);
  void number(std::string_view name, double value, const Place& place, bool is_made = false);
  /// What is between the tags of an element; before all elements in it.
  void text(std::string_view value, const Place& place);
  void close();
  /// Whether the text is longer than a robot may be; nothing is added to it then.
  bool is_full() const { return is_full_; }
  std::string take() { return std::move(text_); }

 private:
  struct Open {
    std::string name;
    Place place;
    bool is_made = false;
    bool is_empty = true;
    bool has_text = false;
  };
  xacro::Leaf& leaf(xacro::Leaf::Kind kind, std::size_t begin, const Place& place,
                    bool is_made = false);
  void end_tag_head();
  void escaped(std::string_view value);

  std::vector<xacro::Leaf>& leaves_;
  std::uint64_t most_;
  bool is_full_ = false;
  std::string text_;
  std::vector<Open> open_;
};

}  // namespace smurf::imports
