// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/deadline.hpp"
#include "base/numbers/bits.hpp"
#include "base/numbers/vectors.hpp"

namespace smurf {
namespace {

double length(const Vector3& a) { return std::sqrt(dot(a, a)); }

/// The coordinates of the second moments in their order.
constexpr std::array<std::array<std::size_t, 2>, 6> kPairs = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

/// A number for a point. Equal points have equal numbers.
std::uint64_t key_of(const Vector3& point) {
  const auto mixed = [](double coordinate) {
    const auto bits = bit_cast<std::uint64_t>(coordinate + 0.0);  // -0 becomes 0
    return bits ^ bits >> 29U;  // the low bits of single precision are 0
  };
  const std::uint64_t key = mixed(point[0]) * 0x9e3779b97f4a7c15U +
                            mixed(point[1]) * 0xbf58476d1ce4e5b9U +
                            mixed(point[2]) * 0x94d049bb133111ebU;
  return key ^ key >> 32U;
}

}  // namespace

void BoxSum::add(const Box& box) {
  add(box.low);
  add(box.high);
}

void BoxSum::add_corners(const Box& box, const Affine& X) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    add(X * Vector3{(corner & 1U) != 0 ? box.high[0] : box.low[0],
                    (corner & 2U) != 0 ? box.high[1] : box.low[1],
                    (corner & 4U) != 0 ? box.high[2] : box.low[2]});
  }
}

std::optional<Box> BoxSum::finite_box() const {
  if (!box_) return std::nullopt;
  for (const Vector3& corner : {box_->low, box_->high}) {
    for (const double coordinate : corner) {
      if (!std::isfinite(coordinate)) return std::nullopt;
    }
  }
  return box_;
}

void SurfaceSum::add(const Vector3& a, const Vector3& b, const Vector3& c) {
  Deadline::look(1);
  if (visit_) visit_(a, b, c);
  outer_.add(a, b, c);
  if (!origin_) origin_ = a;
  const Vector3 area = cross(difference(b, a), difference(c, a));
  area_ += length(area);
  for (std::size_t i = 0; i < 3; ++i) area_vector_[i] += area[i];

  const Vector3 p = difference(a, *origin_);
  const Vector3 q = difference(b, *origin_);
  const Vector3 r = difference(c, *origin_);
  const Vector3 sum{p[0] + q[0] + r[0], p[1] + q[1] + r[1], p[2] + q[2] + r[2]};
  const double volume = dot(p, area);
  volume_ += volume;
  for (std::size_t i = 0; i < 3; ++i) first_[i] += volume * sum[i];
  const auto [px, py, pz] = p;
  const auto [qx, qy, qz] = q;
  const auto [rx, ry, rz] = r;
  const auto [sx, sy, sz] = sum;
  second_[0] += volume * (px * px + qx * qx + rx * rx + sx * sx);
  second_[1] += volume * (py * py + qy * qy + ry * ry + sy * sy);
  second_[2] += volume * (pz * pz + qz * qz + rz * rz + sz * sz);
  second_[3] += volume * (px * py + qx * qy + rx * ry + sx * sy);
  second_[4] += volume * (px * pz + qx * qz + rx * rz + sx * sz);
  second_[5] += volume * (py * pz + qy * qz + ry * rz + sy * sz);

  const std::uint64_t keys[] = {key_of(a), key_of(b), key_of(c)};
  const std::uint64_t edges =
      add_edge(keys[0], keys[1]) + add_edge(keys[1], keys[2]) + add_edge(keys[2], keys[0]);
  triangle_parity_ ^= edges * 0x9e3779b97f4a7c15U ^ edges >> 31U;
}

std::uint64_t SurfaceSum::add_edge(std::uint64_t from, std::uint64_t to) {
  if (from == to) return 0;
  std::uint64_t edge = (from + to) ^ (from * to);
  edge = (edge ^ edge >> 29U) * 0xd6e8feb86659fd93U;
  edge ^= edge >> 32U;
  directed_ += from < to ? edge : -edge;
  parity_ ^= edge;
  return from < to ? edge : -edge;
}

Closure SurfaceSum::closure() const {
  if (!origin_) return Closure::unknown;
  if (directed_ == 0) return Closure::closed;
  return parity_ == 0 ? Closure::flipped : Closure::open;
}

std::optional<Solid> SurfaceSum::solid() const {
  // Single precision causes errors of 1e-6 of the area; a missing triangle in a mesh of a thousand
  // causes 1e-3.
  constexpr double kClosed = 1e-4;
  if (!(area_ > 0) || !(length(area_vector_) <= kClosed * area_)) return std::nullopt;
  Solid solid;
  solid.volume = volume_ / 6;
  if (volume_ == 0) return solid;
  Vector3 offset;
  for (std::size_t i = 0; i < 3; ++i) {
    offset[i] = first_[i] / (4 * volume_);
    solid.center[i] = (*origin_)[i] + offset[i];
  }
  for (std::size_t k = 0; k < kPairs.size(); ++k) {
    const auto [i, j] = kPairs[k];
    solid.second[k] = second_[k] / 120 - solid.volume * offset[i] * offset[j];
  }
  return solid;
}

void SurfaceSum::write_to(MeshFacts& facts) {
  // What is there twice encloses nothing that can be weighed.
  facts.solid = is_doubled() ? std::nullopt : solid();
  facts.closure = closure();
  facts.outer = outer_.take();
}

}  // namespace smurf
