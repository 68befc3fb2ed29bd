// SPDX-License-Identifier: BSD-3-Clause
// The bodies that MuJoCo makes of a soft body: one for each point, with three slides.
#include <algorithm>
#include <cmath>

#include "base/numbers/exact_math.hpp"
#include "mjcf/model.hpp"

namespace smurf::mjcf {
namespace {

constexpr std::size_t kMostPoints = 100'000;

/// The points of the kinds that only need numbers; empty for all others.
std::vector<Vector3> points_of(const Settings& s, Reporter& reporter) {
  for (const std::string_view name : {"file", "mesh", "dof", "origin", "scale", "rigid", "point"}) {
    if (s.has(name)) return {};
  }
  const std::string_view type = s.has("type") ? s.text("type") : "grid";
  std::array<double, 3> counts{10, 10, 10};
  std::array<double, 3> spacing{};
  s.numbers("count", counts, 3, reporter);
  s.numbers("spacing", spacing, 3, reporter);
  std::vector<Vector3> points;
  const double all = counts[0] * counts[1] * counts[2];
  if (!(all >= 1) || all > static_cast<double>(kMostPoints)) return {};
  if (type == "circle") {
    const auto count = static_cast<std::size_t>(counts[0]) - 1;
    if (count < 2) return {};
    const double step = 2 * 3.14159265358979323846 / static_cast<double>(count);
    const double radius = spacing[0] / 2 / sine_cosine(step / 2).sine;
    for (std::size_t i = 0; i < count; ++i) {
      const SineCosine turn = sine_cosine(step * static_cast<double>(i));
      points.push_back({radius * turn.cosine, radius * turn.sine, 0});
    }
    return points;
  }
  const bool is_disc = type == "disc";
  if (type != "grid" && !is_disc) return {};
  const auto at = [&](std::size_t axis, std::size_t i) {
    return spacing[axis] * (static_cast<double>(i) - (counts[axis] - 1) / 2);
  };
  for (std::size_t x = 0; x < static_cast<std::size_t>(counts[0]); ++x) {
    for (std::size_t y = 0; y < static_cast<std::size_t>(counts[1]); ++y) {
      for (std::size_t z = 0; z < static_cast<std::size_t>(counts[2]); ++z) {
        Vector3 p{at(0, x), at(1, y), at(2, z)};
        if (is_disc) {
          const double length = std::sqrt(p[0] * p[0] + p[1] * p[1]);
          const double largest = std::max(std::fabs(p[0]), std::fabs(p[1]));
          for (std::size_t i = 0; i < 2 && length > 0; ++i) {
            p[i] *= largest / length * spacing[i] * (counts[i] - 1) / 2;
          }
        }
        points.push_back(p);
      }
    }
  }
  return points;
}

}  // namespace

std::vector<Body> points_of_flex(View element, const Pose& X, const Surroundings& around,
                                 Reporter& reporter) {
  std::vector<Body> bodies;
  const Settings s(element, nullptr);
  bool has_pins = false;
  around.file->each(element, [&](View one) { has_pins = has_pins || one.name() == "pin"; });
  const Attribute* name = element.attribute("name");
  if (has_pins || name == nullptr) return bodies;
  const std::vector<Vector3> points = points_of(s, reporter);
  const Pose pose = X * pose_of(s, around.file->compiler(), reporter);
  const double mass = s.number("mass", 1, reporter) / static_cast<double>(points.size());
  const double half = s.number("inertiabox", 0.005, reporter);
  const double moment = mass * 2 * half * half / 3;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Body& body = bodies.emplace_back();
    body.element = element;
    body.file = around.file;
    body.frame = around.frame;
    body.name =
        around.prefix + std::string(name->value()) + "_" + std::to_string(i) + around.suffix;
    body.has_name = true;
    body.pose.position = (pose * Pose{points[i], {}}).position;
    body.point = MassProperties{mass, {}, {moment, moment, moment, 0, 0, 0}};
    for (const Vector3 axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
      Joint& joint = body.joints.emplace_back();
      joint.type = Joint::Type::slide;
      joint.axis = axis;
      joint.settings = s;
      joint.frame = around.frame;
      joint.file = around.file;
    }
  }
  return bodies;
}

}  // namespace smurf::mjcf
