// SPDX-License-Identifier: BSD-3-Clause
// Writes an XML text that is made from a file of another language, and remembers where each part of
// it comes from.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/xacro.hpp"

namespace smurf::mjcf {

/// Where a value was written, and where it acts.
struct Place {
  Span origin;  ///< the bytes to blame
  Span use;     ///< the tag that the value acts on
  xacro::FrameId frame = xacro::kNoFrame;
  bool is_exact = false;  ///< the bytes of the value are those of `origin`
};

class TracedXml {
 public:
  explicit TracedXml(xacro::Expansion& expansion) : leaves_(expansion.leaves) {
    text_ = "<?xml version=\"1.0\" ?>\n";
  }

  /// An element that stands for one of the file; `is_made`: nobody wrote it, or the value.
  void open(std::string_view name, const Place& place, bool is_made = false);
  void attribute(std::string_view name, std::string_view value, const Place& place,
                 bool is_made = false);
  void number(std::string_view name, double value, const Place& place, bool is_made = false);
  void close();
  std::string take() { return std::move(text_); }

 private:
  struct Open {
    std::string name;
    Place place;
    bool is_made = false;
    bool is_empty = true;
  };
  xacro::Leaf& leaf(xacro::Leaf::Kind kind, std::size_t begin, const Place& place,
                    bool is_made = false);
  void end_tag_head();

  std::vector<xacro::Leaf>& leaves_;
  std::string text_;
  std::vector<Open> open_;
};

}  // namespace smurf::mjcf
