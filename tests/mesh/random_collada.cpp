// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/random_collada.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "smurf/pose.hpp"

namespace smurf::test {
namespace {

std::string text(double value) { return format_number(value) + " "; }

class Writer {
 public:
  explicit Writer(Random& random) : random_(random) {}

  std::string run() {
    geometries_ = 1 + random_.below(4);
    std::string out = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)";
    constexpr const char* kUnits[] = {"1", "0.01", "0.0254", "0.001"};
    if (!random_.one_in(4)) {
      out += "<unit name=\"u\" meter=\"" + std::string(kUnits[random_.below(4)]) + "\"/>";
    }
    constexpr const char* kAxes[] = {"X_UP", "Y_UP", "Z_UP"};
    if (!random_.one_in(4)) {
      out += "<up_axis>" + std::string(kAxes[random_.below(3)]) + "</up_axis>";
    }
    out += "</asset>\n<library_geometries>\n";
    for (std::size_t i = 0; i < geometries_; ++i) out += geometry(i);
    out += "</library_geometries>\n<library_nodes>\n";
    shared_ = random_.below(3);
    for (std::size_t i = 0; i < shared_; ++i) {
      out += node("shared" + std::to_string(i), 2, 0);
    }
    out += "</library_nodes>\n<library_visual_scenes><visual_scene id=\"scene\">\n";
    const std::size_t roots = 1 + random_.below(3);
    for (std::size_t i = 0; i < roots; ++i) out += node("root" + std::to_string(i), 0, shared_);
    return out + "</visual_scene></library_visual_scenes>\n<scene><instance_visual_scene "
                 "url=\"#scene\"/></scene></COLLADA>\n";
  }

 private:
  /// A flat polygon around a random centre: convex, or a star.
  std::vector<std::size_t> polygon(std::size_t corners) {
    const bool is_star = corners > 4 && corners % 2 == 0;
    Vector3 center;
    Vector3 u;
    for (double& c : center) c = random_.between(-5, 5);
    for (double& c : u) c = random_.between(-1, 1);
    Vector3 w;
    for (double& c : w) c = random_.between(-1, 1);
    const Vector3 v{u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2],
                    u[0] * w[1] - u[1] * w[0]};
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
      const double radius = is_star && i % 2 == 1 ? 0.4 : 1;
      Vector3 point;
      for (std::size_t k = 0; k < 3; ++k) {
        point[k] = center[k] + radius * (u[k] * std::cos(angle) + v[k] * std::sin(angle));
      }
      places.push_back(points_.size());
      points_.push_back(point);
    }
    return places;
  }

  std::string list(const std::vector<std::size_t>& corners) {
    std::string out;
    for (const std::size_t corner : corners) {
      for (std::size_t i = 0; i < inputs_; ++i) {
        out += std::to_string(i == vertex_ ? corner : 0) + (random_.one_in(9) ? "\n" : " ");
      }
    }
    return out;
  }

  std::string inputs(std::size_t index) {
    const std::string id = std::to_string(index);
    std::string out;
    for (std::size_t i = 0; i < inputs_; ++i) {
      const bool is_vertex = i == vertex_;
      out += "<input semantic=\"" + std::string(is_vertex ? "VERTEX" : "NORMAL") + "\" source=\"#" +
             (is_vertex ? "v" : "n") + id + "\" offset=\"" + std::to_string(i) + "\"/>";
    }
    return out;
  }

  std::string primitives(std::size_t index) {
    inputs_ = 1 + random_.below(2);
    vertex_ = random_.below(inputs_);
    const std::size_t number = 1 + random_.below(3);
    const std::string count = " material=\"m" + std::to_string(random_.below(3)) + "\" count=\"" +
                              std::to_string(number) + "\">" + inputs(index);
    std::string counts;
    std::string lists;
    switch (random_.below(5)) {
    case 0:
      for (std::size_t i = 0; i < number; ++i) lists += list(polygon(3));
      return "<triangles" + count + "<p>" + lists + "</p></triangles>\n";
    case 1:
      for (std::size_t i = 0; i < number; ++i) {
        const std::size_t corners = 3 + random_.below(8);
        counts += std::to_string(corners) + " ";
        lists += list(polygon(corners));
      }
      return "<polylist" + count + "<vcount>" + counts + "</vcount><p>" + lists +
             "</p></polylist>\n";
    case 2:
      for (std::size_t i = 0; i < number; ++i) {
        lists += "<p>" + list(polygon(3 + random_.below(8))) + "</p>";
      }
      return "<polygons" + count + lists + "</polygons>\n";
    case 3:
      for (std::size_t i = 0; i < number; ++i) {
        lists += "<p>" + list(polygon(3 + random_.below(6))) + "</p>";
      }
      return "<tristrips" + count + lists + "</tristrips>\n";
    default:
      // assimp makes polygons of fans and cuts them in a different way, so these are convex.
      for (std::size_t i = 0; i < number; ++i) {
        lists += "<p>" + list(polygon(3 + 2 * random_.below(3))) + "</p>";
      }
      return "<trifans" + count + lists + "</trifans>\n";
    }
  }

  std::string geometry(std::size_t index) {
    points_.clear();
    std::string all;
    const std::size_t number = 1 + random_.below(3);
    for (std::size_t i = 0; i < number; ++i) all += primitives(index);
    const std::string id = std::to_string(index);
    const std::size_t before = random_.below(2);
    const std::size_t after = random_.below(3);
    const std::size_t stride = before + 3 + after;
    const std::size_t offset = random_.below(3);
    std::string numbers;
    for (std::size_t i = 0; i < offset; ++i) numbers += "77 ";
    for (const Vector3& point : points_) {
      for (std::size_t i = 0; i < before; ++i) numbers += "88 ";
      for (const double c : point) numbers += text(c);
      for (std::size_t i = 0; i < after; ++i) numbers += "99 ";
    }
    std::string params;
    for (std::size_t i = 0; i < before; ++i) params += "<param type=\"float\"/>";
    for (const char* axis : {"X", "Y", "Z"}) {
      params += "<param name=\"" + std::string(axis) + "\" type=\"float\"/>";
    }
    for (std::size_t i = 0; i < after; ++i) params += "<param type=\"float\"/>";
    const auto source = [](const std::string& name, const std::string& values, std::size_t size,
                           const std::string& accessor) {
      return "<source id=\"" + name + "\"><float_array id=\"" + name + "a\" count=\"" +
             std::to_string(size) + "\">" + values +
             "</float_array><technique_common><accessor "
             "source=\"#" +
             name + "a\" " + accessor + "</accessor></technique_common></source>\n";
    };
    const std::string count = std::to_string(points_.size());
    return "<geometry id=\"g" + id + "\"><mesh>\n" +
           source("p" + id, numbers, offset + stride * points_.size(),
                  "count=\"" + count + "\" offset=\"" + std::to_string(offset) + "\" stride=\"" +
                      std::to_string(stride) + "\">" + params) +
           source("n" + id, "0 0 1", 3,
                  "count=\"1\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" "
                  "type=\"float\"/><param name=\"Z\" type=\"float\"/>") +
           "<vertices id=\"v" + id + "\"><input semantic=\"POSITION\" source=\"#p" + id +
           "\"/></vertices>\n" + all + "</mesh></geometry>\n";
  }

  std::string numbers(std::size_t count, double low, double high) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) out += text(random_.between(low, high));
    return out;
  }

  /// An axis of unit length, because assimp ignores rotations about other axes.
  std::string axis() {
    const Quaternion q = normalized({0, random_.between(-1, 1), random_.between(-1, 1), 0.1});
    return text(q.x) + text(q.y) + text(q.z);
  }

  /// A rotation that is far from the identity, because assimp drops nearly identical ones
  /// (aiProcess_PreTransformVertices).
  std::string transform() {
    switch (random_.below(4)) {
    case 0: return "<translate>" + numbers(3, -9, 9) + "</translate>";
    case 1: return "<rotate>" + axis() + numbers(1, 10, 350) + "</rotate>";
    case 2: return "<scale>" + numbers(3, 0.3, 3) + "</scale>";
    default: return "<matrix>" + numbers(12, -2, 2) + "0 0 0 1</matrix>";
    }
  }

  /// `shared` is the number of library nodes that it may refer to.
  std::string node(const std::string& id, std::size_t depth, std::size_t shared) {
    std::string out = "<node id=\"" + id + "\">";
    for (std::size_t i = random_.below(3); i > 0; --i) out += transform();
    for (std::size_t i = random_.below(3) + (depth == 0 ? 1 : 0); i > 0; --i) {
      out += "<instance_geometry url=\"#g" + std::to_string(random_.below(geometries_)) + "\"/>";
    }
    if (shared > 0 && random_.one_in(2)) {
      out += "<instance_node url=\"#shared" + std::to_string(random_.below(shared)) + "\"/>";
    }
    for (std::size_t i = depth < 3 ? random_.below(3) : 0; i > 0; --i) {
      out += node(id + "_" + std::to_string(i), depth + 1, shared);
    }
    return out + "</node>\n";
  }

  Random& random_;
  std::size_t geometries_ = 0, shared_ = 0;
  std::vector<Vector3> points_;  ///< of the geometry
  std::size_t inputs_ = 1, vertex_ = 0;
};

}  // namespace

std::string random_collada(Random& random) { return Writer(random).run(); }

}  // namespace smurf::test
