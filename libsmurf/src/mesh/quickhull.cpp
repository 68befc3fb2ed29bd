// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/quickhull.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "base/deadline.hpp"
#include "base/numbers/vectors.hpp"

namespace smurf {
namespace {

double length_of(const Vector3& a) { return std::sqrt(dot(a, a)); }

/// The neighbour `k` is behind the edge from corner `k` to the next.
struct Face : HullFace {
  std::array<std::uint32_t, 3> neighbours{};
  std::vector<std::uint32_t> outside;  ///< the points above it that no other face has
  bool is_gone = false;
};

/// In tolerances: a face that a point is less above does not see it. Rounding errors would decide,
/// and let the horizon cross itself.
constexpr double kLeastSeen = 0.01;

/// Quickhull: Barber, Dobkin and Huhdanpaa, "The Quickhull Algorithm for Convex Hulls", 1996.
class HullMaker {
 public:
  HullMaker(const std::vector<Vector3>& points, double tolerance)
      : points_(points), tolerance_(tolerance) {}

  /// False if there is no hull.
  bool make() {
    if (!start()) return false;
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
      while (!faces_[i].is_gone && !faces_[i].outside.empty()) {
        Deadline::look(faces_.size() / 16 + faces_[i].outside.size());
        if (!add(farthest_above(i), i)) return false;
      }
    }
    return true;
  }

  std::vector<HullFace> take() const {
    std::vector<HullFace> faces;
    for (const Face& face : faces_) {
      if (!face.is_gone) faces.push_back(face);
    }
    return faces;
  }

 private:
  double height(const Face& face, std::uint32_t point) const {
    return dot(face.side.normal, points_[point]) - face.side.distance;
  }

  /// The index with the largest value.
  template <class Value>
  std::uint32_t largest(const Value& value) const {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < points_.size(); ++i) {
      if (value(i) > value(best)) best = i;
    }
    return best;
  }

  /// Makes a tetrahedron of points that are far from each other.
  bool start() {
    for (const Vector3& point : points_) {
      for (const double x : point) {
        if (!std::isfinite(x)) return false;
      }
    }
    if (points_.size() < 4 || !(tolerance_ > 0)) return false;
    const auto to = [&](std::uint32_t from, std::uint32_t i) {
      return difference(points_[i], points_[from]);
    };
    const std::uint32_t a = largest([&](std::uint32_t i) { return length_of(to(0, i)); });
    const std::uint32_t b = largest([&](std::uint32_t i) { return length_of(to(a, i)); });
    const std::uint32_t c =
        largest([&](std::uint32_t i) { return length_of(cross(to(a, b), to(a, i))); });
    const Vector3 normal = cross(to(a, b), to(a, c));
    const std::uint32_t d =
        largest([&](std::uint32_t i) { return std::fabs(dot(normal, to(a, i))); });
    const double area = length_of(normal);
    if (!(area > 0) || !(std::fabs(dot(normal, to(a, d))) > 4 * tolerance_ * area)) return false;
    const bool is_above = dot(normal, to(a, d)) > 0;
    const std::uint32_t first = is_above ? c : b;
    const std::uint32_t second = is_above ? b : c;
    // Seen from d, the triangle a, first, second turns right.
    if (!(push({a, first, second}) && push({a, d, first}) && push({first, d, second}) &&
          push({second, d, a}))) {
      return false;
    }
    faces_[0].neighbours = {1, 2, 3};
    faces_[1].neighbours = {3, 2, 0};
    faces_[2].neighbours = {1, 3, 0};
    faces_[3].neighbours = {2, 1, 0};
    std::vector<std::uint32_t> all(points_.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    distribute(all, 0);
    return true;
  }

  /// False if the corners are on a line.
  bool push(const std::array<std::uint32_t, 3>& corners) {
    Face face;
    face.corners = corners;
    const Vector3& origin = points_[corners[0]];
    Vector3 normal =
        cross(difference(points_[corners[1]], origin), difference(points_[corners[2]], origin));
    const double size = length_of(normal);
    if (!(size > 0)) return false;
    for (double& x : normal) x /= size;
    face.side = {normal, dot(normal, origin)};
    faces_.push_back(std::move(face));
    return true;
  }

  /// Gives each point to the first face from `first` that it is above.
  void distribute(const std::vector<std::uint32_t>& points, std::size_t first) {
    for (const std::uint32_t point : points) {
      for (std::size_t i = first; i < faces_.size(); ++i) {
        if (height(faces_[i], point) <= tolerance_) continue;
        faces_[i].outside.push_back(point);
        break;
      }
    }
  }

  std::uint32_t farthest_above(std::uint32_t index) const {
    const Face& face = faces_[index];
    return *std::max_element(
        face.outside.begin(), face.outside.end(),
        [&](std::uint32_t a, std::uint32_t b) { return height(face, a) < height(face, b); });
  }

  /// An edge between a face that the new point sees and one that it does not see.
  struct Edge {
    std::uint32_t from, to, behind;
  };

  /// Replaces all faces that the point sees by a cone with the point as its tip.
  bool add(std::uint32_t point, std::uint32_t seen_face) {
    std::vector<std::uint32_t> seen = {seen_face};
    std::vector<std::uint32_t> orphans;
    std::vector<Edge> horizon;
    faces_[seen_face].is_gone = true;
    for (std::size_t at = 0; at < seen.size(); ++at) {
      Face& face = faces_[seen[at]];
      orphans.insert(orphans.end(), face.outside.begin(), face.outside.end());
      face.outside.clear();
      for (std::size_t k = 0; k < 3; ++k) {
        Face& other = faces_[face.neighbours[k]];
        if (other.is_gone) continue;
        if (height(other, point) > kLeastSeen * tolerance_) {
          other.is_gone = true;
          seen.push_back(face.neighbours[k]);
        }
      }
    }
    for (const std::uint32_t index : seen) {
      const Face& face = faces_[index];
      for (std::size_t k = 0; k < 3; ++k) {
        if (faces_[face.neighbours[k]].is_gone) continue;
        horizon.push_back({face.corners[k], face.corners[(k + 1) % 3], face.neighbours[k]});
      }
    }
    return add_cone(point, horizon, orphans);
  }

  bool add_cone(std::uint32_t tip, const std::vector<Edge>& horizon,
                const std::vector<std::uint32_t>& orphans) {
    const std::size_t first = faces_.size();
    std::map<std::uint32_t, std::uint32_t> starting_at;  // corner -> new face
    for (const Edge& edge : horizon) {
      const auto index = static_cast<std::uint32_t>(faces_.size());
      // Rounding can make the horizon cross itself.
      if (!push({edge.from, edge.to, tip})) return false;
      if (!starting_at.emplace(edge.from, index).second) return false;
      faces_[index].neighbours[0] = edge.behind;
      Face& behind = faces_[edge.behind];
      for (std::size_t k = 0; k < 3; ++k) {
        if (behind.corners[k] == edge.to) behind.neighbours[k] = index;
      }
    }
    for (const Edge& edge : horizon) {
      const auto next = starting_at.find(edge.to);
      if (next == starting_at.end()) return false;
      const std::uint32_t own = starting_at[edge.from];
      faces_[own].neighbours[1] = next->second;
      faces_[next->second].neighbours[2] = own;
    }
    distribute(orphans, first);
    return true;
  }

  const std::vector<Vector3>& points_;
  std::vector<Face> faces_;
  double tolerance_;
};

}  // namespace

std::optional<std::vector<HullFace>> quickhull(const std::vector<Vector3>& points,
                                               double tolerance) {
  HullMaker maker(points, tolerance);
  if (!maker.make()) return std::nullopt;
  return maker.take();
}

}  // namespace smurf
