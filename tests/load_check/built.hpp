// SPDX-License-Identifier: BSD-3-Clause
// A robot built in ODE from a few URDF elements, for the physics tests.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "smurf-load-check/collision_shapes.hpp"
#include "smurf-load-check/world.hpp"
#include "smurf/load.hpp"

namespace smurf::load_check {

constexpr double kGravity = 9.81;

[[noreturn]] inline void fail_on_fault(const std::string& message) {
  throw std::runtime_error(message);
}

inline void start_engine_once() {
  static const bool is_started = (start_engine(fail_on_fault), true);
  REQUIRE(is_started);
}

/// A plan of the elements in a `robot`. `annotation` is an annotation file of the model.
struct Built {
  SourceMap sources;
  DiskFiles disk;
  MemoryFiles files{&disk};
  DiagnosticSink sink;
  LinkedModel model;
  Plan plan;

  Built(const std::string& body, Base::Kind base, const JointPositions& positions = {},
        const Pose& X_WR = {}, const std::string& annotation = "") {
    start_engine_once();
    files.add("robot.urdf", "<robot name=\"r\">" + body + "</robot>");
    files.add("more.yml", annotation.empty() ? "motors: []" : annotation);
    files.add("robot.smurf", "modelname: r\nfiles: [robot.urdf, more.yml]\n");
    LoadContext context{sources, files, sink, {}, {}};
    model = load_model("robot.smurf", context);
    REQUIRE(model.robot);
    PlacedModel placed{&model, "", X_WR, positions, {}};
    placed.base.kind = base;
    plan = make_plan({placed});
    add_shapes(plan, {disk}, sink);
    REQUIRE(sink.diagnostics().empty());
  }
};

/// A link whose inertia is the same about all axes (kg m^2).
inline std::string link(const std::string& name, const std::string& center, double mass,
                        double moment, const std::string& more = "") {
  const std::string i = std::to_string(moment);
  return "<link name=\"" + name + "\"><inertial><origin xyz=\"" + center + "\"/><mass value=\"" +
         std::to_string(mass) + "\"/><inertia ixx=\"" + i + "\" ixy=\"0\" ixz=\"0\" iyy=\"" + i +
         "\" iyz=\"0\" izz=\"" + i + "\"/></inertial>" + more + "</link>";
}

/// Joint `j` from `base` to `arm`.
inline std::string joint(const std::string& type, const std::string& axis,
                         const std::string& more = "") {
  return "<joint name=\"j\" type=\"" + type +
         "\"><parent link=\"base\"/><child link=\"arm\"/><axis xyz=\"" + axis + "\"/>" + more +
         "</joint>";
}

inline const std::string kBase = "<link name=\"base\"/>";

inline void run(World& world, double seconds) {
  const auto steps = std::lround(seconds / world.step_size());
  for (long i = 0; i < steps; ++i) world.step();
}

/// Steps for ten seconds; the period is measured between zero crossings, by interpolation.
template <class Position>
double period_of(World& world, const Position& position) {
  constexpr double kWatched = 10;
  std::vector<double> passages;
  double before = position();
  while (world.time() < kWatched) {
    world.step();
    const double now = position();
    if ((before > 0) != (now > 0)) {
      passages.push_back(world.time() - world.step_size() * now / (now - before));
    }
    before = now;
  }
  REQUIRE(passages.size() > 8);
  return 2 * (passages.back() - passages.front()) / static_cast<double>(passages.size() - 1);
}

/// The period of a compound pendulum, s. `length` is from the pivot to the centre of mass, and
/// `moment` is about the centre of mass.
inline double pendulum_period(double mass, double length, double moment, double amplitude) {
  constexpr double kTurn = 6.283185307179586;
  const double small =
      kTurn * std::sqrt((moment + mass * length * length) / (mass * kGravity * length));
  return small * (1 + amplitude * amplitude / 16);
}

}  // namespace smurf::load_check
