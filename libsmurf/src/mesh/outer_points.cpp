// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/outer_points.hpp"

#include <iterator>
#include <utility>

namespace smurf {
namespace {

/// Columns of the axes, so that the compiler can compute several axes at once.
constexpr std::array<float, 8> kX = {1, 0, 0, 1, 1, 1, -1, 0};
constexpr std::array<float, 8> kY = {0, 1, 0, 1, 1, -1, 1, 0};
constexpr std::array<float, 8> kZ = {0, 0, 1, 1, -1, 1, 1, 0};

OuterPoints::Point to_single(const Vector3& point) {
  return {static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2])};
}

}  // namespace

void OuterPoints::add(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3* corners[] = {&a, &b, &c};
  for (; next_ < corners_ + std::size(corners); next_ += stride_) {
    keep(to_single(*corners[next_ - corners_]));
  }
  corners_ += std::size(corners);
  // In a closed mesh, nearly each point is the first corner of some triangle.
  if (stride_ > 1) extend(to_single(a));
}

void OuterPoints::keep(const Point& corner) {
  if (kept_.size() == kMostKept) thin_out();
  kept_.push_back(corner);
}

void OuterPoints::thin_out() {
  if (stride_ == 1) {
    const auto& [x, y, z] = kept_.front();
    for (std::size_t i = 0; i < kAxes; ++i) {
      least_[i] = most_[i] = kX[i] * x + kY[i] * y + kZ[i] * z;
    }
    outermost_.fill(kept_.front());
    for (const Point& point : kept_) extend(point);
  }
  for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
  kept_.resize(kept_.size() / 2);
  stride_ *= 2;
}

void OuterPoints::extend(const Point& point) {
  const auto [x, y, z] = point;
  std::array<float, kAxes> along;
  for (std::size_t i = 0; i < kAxes; ++i) along[i] = kX[i] * x + kY[i] * y + kZ[i] * z;
  unsigned is_farther = 0;  // no branches, which would prevent computing several at once
  for (std::size_t i = 0; i < kAxes; ++i) {
    is_farther |=
        static_cast<unsigned>(along[i] > most_[i]) | static_cast<unsigned>(along[i] < least_[i]);
  }
  if (is_farther == 0) return;
  for (std::size_t i = 0; i < kAxes; ++i) {
    if (along[i] > most_[i]) {
      most_[i] = along[i];
      outermost_[2 * i] = point;
    } else if (along[i] < least_[i]) {
      least_[i] = along[i];
      outermost_[2 * i + 1] = point;
    }
  }
}

std::vector<OuterPoints::Point> OuterPoints::take() {
  if (stride_ > 1) kept_.insert(kept_.end(), outermost_.begin(), outermost_.end());
  return std::move(kept_);
}

}  // namespace smurf
