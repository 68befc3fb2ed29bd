// SPDX-License-Identifier: BSD-3-Clause
// Positions and orientations, which MJCF writes in five ways.
#include <algorithm>
#include <cmath>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/rotations.hpp"
#include "base/numbers/vectors.hpp"
#include "base/text/quoted.hpp"
#include "mjcf/model.hpp"

namespace smurf::mjcf {
namespace {

constexpr double kSmall = 1e-14;
double length(const Vector3& v) { return std::sqrt(dot(v, v)); }
Vector3 scaled(const Vector3& v, double by) { return {v[0] * by, v[1] * by, v[2] * by}; }

Quaternion from_euler(const std::array<double, 3>& angles, const std::string& sequence) {
  Quaternion q;
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = sequence[i];
    const bool is_fixed = letter < 'a';
    const char axis = is_fixed ? static_cast<char>(letter + 32) : letter;
    const Quaternion turn = from_axis_angle(
        {axis == 'x' ? 1.0 : 0.0, axis == 'y' ? 1.0 : 0.0, axis == 'z' ? 1.0 : 0.0}, angles[i]);
    q = is_fixed ? multiply(turn, q) : multiply(q, turn);
  }
  return normalized(q);
}

constexpr std::string_view kOrientations[] = {"quat", "axisangle", "xyaxes", "zaxis", "euler"};

}  // namespace

Quaternion turn_from_z(const Vector3& direction) {
  Vector3 axis = cross({0, 0, 1}, direction);
  const double sine = length(axis);
  axis = sine < 1e-10 ? Vector3{1, 0, 0} : scaled(axis, 1 / sine);
  return from_axis_angle(axis, arc_tangent(sine, direction[2]));
}

Pose pose_of(const Settings& settings, const Compiler& compiler, Reporter& reporter,
             std::string_view position) {
  Pose pose;
  settings.numbers(position, pose.position, 3, reporter);
  const Attribute* written = nullptr;
  for (const std::string_view name : kOrientations) {
    const Attribute* own = settings.element().attribute(name);
    if (own == nullptr) continue;
    if (written != nullptr) {
      reporter
          .refuse(own->name_span(),
                  quoted(written->name()) + " and " + quoted(name) + " are both orientations",
                  "delete one of them")
          .label(written->name_span(), "the other one");
    }
    written = own;
  }
  // In a class, an orientation of another kind wins over `quat`.
  for (std::size_t i = std::size(kOrientations); written == nullptr && i-- > 0;)
    written = settings.find(kOrientations[i]);
  if (written == nullptr) return pose;
  const auto bad = [&](std::string text) {
    reporter.refuse(written->value_span(), std::move(text), "write numbers that give a direction");
  };
  const std::string_view name = written->name();
  if (name == "quat") {
    const auto n = numbers_of(*written, 4, 4, reporter);
    if (n.size() < 4) return pose;
    const Quaternion q{n[0], n[1], n[2], n[3]};
    if (!(norm(q) > kSmall)) {
      bad("the quaternion is zero");
    } else {
      pose.orientation = normalized(q);
    }
  } else if (name == "euler") {
    const auto n = numbers_of(*written, 3, 3, reporter);
    if (n.size() < 3) return pose;
    const double unit = compiler.is_degree ? kDegree : 1;
    pose.orientation = from_euler({n[0] * unit, n[1] * unit, n[2] * unit}, compiler.eulerseq);
  } else if (name == "axisangle") {
    const auto n = numbers_of(*written, 4, 4, reporter);
    if (n.size() < 4) return pose;
    const Vector3 axis{n[0], n[1], n[2]};
    if (length(axis) < kSmall) {
      bad("the axis is zero");
    } else {
      pose.orientation = normalized(from_axis_angle(scaled(axis, 1 / length(axis)),
                                                    compiler.is_degree ? n[3] * kDegree : n[3]));
    }
  } else if (name == "zaxis") {
    const auto n = numbers_of(*written, 3, 3, reporter);
    if (n.size() < 3) return pose;
    const Vector3 z{n[0], n[1], n[2]};
    if (length(z) < kSmall) {
      bad("the axis is zero");
    } else {
      pose.orientation = normalized(turn_from_z(scaled(z, 1 / length(z))));
    }
  } else {
    const auto n = numbers_of(*written, 6, 6, reporter);
    if (n.size() < 6) return pose;
    Vector3 x{n[0], n[1], n[2]};
    Vector3 y{n[3], n[4], n[5]};
    if (length(x) < kSmall) return bad("the first axis is zero"), pose;
    x = scaled(x, 1 / length(x));
    const double along = dot(x, y);
    y = {y[0] - along * x[0], y[1] - along * x[1], y[2] - along * x[2]};
    if (length(y) < kSmall) return bad("both axes have one direction"), pose;
    y = scaled(y, 1 / length(y));
    pose.orientation = from_axes(x, y, cross(x, y));
  }
  return pose;
}

}  // namespace smurf::mjcf
