// SPDX-License-Identifier: BSD-3-Clause
#include "support/scenes.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "support/loaded.hpp"

namespace smurf::test {
namespace {

constexpr const char* kBox = R"(<?xml version="1.0"?>
<robot name="box">
  <link name="base"/>
  <link name="lid"/>
  <joint name="glue" type="fixed">
    <parent link="base"/><child link="lid"/><origin xyz="0 0 0.1"/>
  </joint>
</robot>
)";

constexpr const char* kCrane = R"(<?xml version="1.0"?>
<robot name="crane">
  <link name="foot"/>
  <link name="boom">
    <inertial>
      <mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
    <collision name="boom_hull"><geometry><box size="1 1 1"/></geometry></collision>
  </link>
  <link name="hook"/>
  <joint name="boom_joint" type="revolute">
    <parent link="foot"/><child link="boom"/><origin xyz="0 0 1"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="1" velocity="1"/>
  </joint>
  <joint name="hook_joint" type="fixed">
    <parent link="boom"/><child link="hook"/><origin xyz="2 0 0"/>
  </joint>
</robot>
)";

}  // namespace

LoadedScene::LoadedScene() {
  files.add("box.urdf", kBox);
  files.add("crane.urdf", kCrane);
  files.add("crane.smurf", "modelname: crane\nfiles: [crane.urdf, crane_poses.yml]\n");
  files.add("crane_poses.yml", "poses:\n- name: up\n  joints: {boom_joint: -0.5}\n");
}

void LoadedScene::load(const std::string& path) {
  LoadContext context{sources, archives, sink, limits, {}};
  scene = load_scene(path, context);
  lint_scene(scene, {}, sink);
  for (const LinkedModel& model : scene.models) lint_model(model, {}, sink);
  diagnostics = sink.take();
  locate(scene, diagnostics);
  diagnostics = apply_selection(std::move(diagnostics), sources, {});
}

void LoadedScene::load_text(const std::string& text) {
  files.add("scene.smurfs", text);
  load("scene.smurfs");
}

std::string LoadedScene::briefs() const {
  std::string all;
  for (const Diagnostic& diagnostic : diagnostics) all += brief(diagnostic, sources) + "\n";
  return all;
}

const Instance& LoadedScene::at(const std::string& path) const {
  for (const Instance& instance : scene.instances) {
    if (instance.path == path) return instance;
  }
  FAIL("no instance " << path);
  return scene.instances.front();
}

Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) c[4 * i + j] += a[4 * i + k] * b[4 * k + j];
    }
  }
  return c;
}

Matrix translation(double x, double y, double z) {
  return {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1};
}

Matrix rotation_x(double angle) {
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return {1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0, 0, 0, 0, 1};
}

Matrix rotation_y(double angle) {
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
}

Matrix rotation_z(double angle) {
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return {c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

Matrix rotation(double w, double x, double y, double z) {
  const double n = w * w + x * x + y * y + z * z;
  const double s = 2 / n;
  return {1 - s * (y * y + z * z),
          s * (x * y - w * z),
          s * (x * z + w * y),
          0,
          s * (x * y + w * z),
          1 - s * (x * x + z * z),
          s * (y * z - w * x),
          0,
          s * (x * z - w * y),
          s * (y * z + w * x),
          1 - s * (x * x + y * y),
          0,
          0,
          0,
          0,
          1};
}

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

Matrix to_matrix4(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  const Vector3& p = pose.position;
  return translation(p[0], p[1], p[2]) * rotation(q.w, q.x, q.y, q.z);
}

double difference(const Matrix& a, const Matrix& b) {
  double largest = 0;
  for (std::size_t i = 0; i < 16; ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

}  // namespace smurf::test
