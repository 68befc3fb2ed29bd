// SPDX-License-Identifier: BSD-3-Clause
// OpenUSD as text, prim by prim. Once it is larger than it may be, nothing is added.
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
  /// A prim that is not in the world by itself.
  void open_class(std::string_view name);
  void close();
  void pose(const Pose& pose, const Vector3& scale = {1, 1, 1});
  bool is_full() const { return out_.size() > most_; }
  std::string take() { return std::move(out_); }

  static std::string tuple(std::initializer_list<double> values);
  static std::string tuple(const Vector3& vector);
  static std::string tuple(const Quaternion& q);
  /// The shortest text that reads back as the same numbers of single precision.
  static std::string tuple(const std::array<float, 3>& point);
  /// Characters that are misread are written byte by byte.
  static std::string quoted(std::string_view text);

 private:
  std::uint64_t most_;
  std::string out_;
  std::size_t depth_ = 0;
};

}  // namespace smurf
