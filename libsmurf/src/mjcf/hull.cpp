// SPDX-License-Identifier: BSD-3-Clause
// The convex hull of points: each face keeps the points that it does not see yet.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/numbers/vectors.hpp"
#include "mjcf/meshes.hpp"

namespace smurf::mjcf {
namespace {

struct Face {
  std::array<std::uint32_t, 3> corners{};
  Vector3 normal{};
  double offset = 0;
  std::vector<std::uint32_t> outside;
  bool is_gone = false;
};

class Hull {
 public:
  explicit Hull(const std::vector<Vector3>& points) : points_(points) {}

  Triangles run() {
    Triangles result;
    if (!begin()) return result;
    for (std::size_t at = 0; at < faces_.size(); ++at) {
      if (!faces_[at].is_gone && !faces_[at].outside.empty()) extend(at);
    }
    result.points = points_;
    for (const Face& face : faces_) {
      if (!face.is_gone) result.faces.push_back(face.corners);
    }
    return result;
  }

 private:
  double distance(const Face& face, std::uint32_t point) const {
    return dot(face.normal, points_[point]) - face.offset;
  }

  void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    Face face;
    face.corners = {a, b, c};
    face.normal = cross(difference(points_[b], points_[a]), difference(points_[c], points_[a]));
    const double size = std::sqrt(dot(face.normal, face.normal));
    for (double& one : face.normal) one /= size > 0 ? size : 1;
    face.offset = dot(face.normal, points_[a]);
    faces_.push_back(std::move(face));
  }

  template <class F>
  std::uint32_t furthest(const F& measure) const {
    std::uint32_t best = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const double value = measure(points_[i]);
      if (value > most) most = value, best = i;
    }
    return best;
  }

  bool begin() {
    if (points_.size() < 4) return false;
    Vector3 low = points_[0];
    Vector3 high = points_[0];
    for (const Vector3& p : points_) {
      for (std::size_t i = 0; i < 3; ++i)
        low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
    }
    const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    tolerance_ = 1e-10 * size;
    const std::uint32_t a =
        furthest([](const Vector3& p) { return -p[0] - 1e-3 * p[1] - 1e-6 * p[2]; });
    const std::uint32_t b = furthest([&](const Vector3& p) {
      const Vector3 d = difference(p, points_[a]);
      return dot(d, d);
    });
    const Vector3 ab = difference(points_[b], points_[a]);
    const std::uint32_t c = furthest([&](const Vector3& p) {
      const Vector3 n = cross(ab, difference(p, points_[a]));
      return dot(n, n);
    });
    const Vector3 n = cross(ab, difference(points_[c], points_[a]));
    const double area = std::sqrt(dot(n, n));
    if (!(area > 1e-12 * size * size)) return false;
    const std::uint32_t d =
        furthest([&](const Vector3& p) { return std::fabs(dot(n, difference(p, points_[a]))); });
    const double height = dot(n, difference(points_[d], points_[a])) / area;
    if (!(std::fabs(height) > 1e-9 * size)) return false;
    const bool is_above = height > 0;
    const std::uint32_t p = is_above ? b : c;
    const std::uint32_t q = is_above ? c : b;
    add_face(a, q, p);
    add_face(a, p, d);
    add_face(p, q, d);
    add_face(q, a, d);
    std::vector<std::uint32_t> all(points_.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    share(all, 0);
    return true;
  }

  /// Assigns each point to the first face at or after `first` that it lies outside of.
  void share(const std::vector<std::uint32_t>& points, std::size_t first) {
    for (const std::uint32_t point : points) {
      for (std::size_t i = first; i < faces_.size(); ++i) {
        if (faces_[i].is_gone || distance(faces_[i], point) <= tolerance_) continue;
        faces_[i].outside.push_back(point);
        break;
      }
    }
  }

  void extend(std::size_t at) {
    const std::vector<std::uint32_t>& own = faces_[at].outside;
    const std::uint32_t top =
        *std::max_element(own.begin(), own.end(), [&](std::uint32_t a, std::uint32_t b) {
          return distance(faces_[at], a) < distance(faces_[at], b);
        });
    std::vector<std::uint32_t> homeless;
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> edges;
    for (Face& face : faces_) {
      if (face.is_gone || distance(face, top) <= tolerance_) continue;
      face.is_gone = true;
      homeless.insert(homeless.end(), face.outside.begin(), face.outside.end());
      face.outside.clear();
      for (std::size_t i = 0; i < 3; ++i)
        edges[{face.corners[i], face.corners[(i + 1) % 3]}] = true;
    }
    const std::size_t first = faces_.size();
    for (const auto& [edge, is_there] : edges) {
      if (!edges.contains({edge.second, edge.first})) add_face(edge.first, edge.second, top);
    }
    std::erase(homeless, top);
    share(homeless, first);
  }

  const std::vector<Vector3>& points_;
  std::vector<Face> faces_;
  double tolerance_ = 0;
};

}  // namespace

Triangles hull_of(const std::vector<Vector3>& points) { return Hull(points).run(); }

}  // namespace smurf::mjcf
