// SPDX-License-Identifier: BSD-3-Clause
// Writes OpenUSD as text, prim by prim. Nothing is added once the text exceeds its limit.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/pose.hpp"

namespace smurf {

class UsdaText {
 public:
  explicit UsdaText(std::uint64_t most) : most_(most) {}

  void line(std::string_view text);
  /// `references` is the path of a prim, or "".
  void open(std::string_view type, std::string_view name,
            const std::vector<std::string>& schemas = {}, std::string_view references = {});
  /// Opens a prim that is visible only through references.
  void open_class(std::string_view name);
  void close();
  void pose(const Pose& pose, const Vector3& scale = {1, 1, 1});
  bool is_full() const { return out_.size() > most_; }
  std::string take() { return std::move(out_); }

  static std::string tuple(std::initializer_list<double> values);
  static std::string tuple(const Vector3& vector);
  static std::string tuple(const Quaternion& q);
  /// The shortest text that reads back as the same numbers in single precision.
  static std::string tuple(const std::array<float, 3>& point);
  /// As a string literal; control characters are written as escaped bytes.
  static std::string quoted(std::string_view text);

 private:
  std::uint64_t most_;
  std::string out_;
  std::size_t depth_ = 0;
};

}  // namespace smurf
