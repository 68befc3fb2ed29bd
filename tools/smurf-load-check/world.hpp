// SPDX-License-Identifier: BSD-3-Clause
// A plan as an ODE world that can be stepped and measured. This is the only place that uses ODE.
// ODE ends the process on faults: use it in a child process, after the bodies were checked.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "smurf-load-check/body_plan.hpp"

namespace smurf::load_check {

struct WorldSetup {
  Eigen::Vector3d gravity{0, 0, -9.81};  ///< m/s^2
  double step = 1e-3;                    ///< s
  double cfm = 1e-10;                    ///< as MARS sets it, WorldPhysics.cpp
  double erp = 0.1;
  bool contacts = false;
  /// A joint that starts closer than this to a stop starts this far inside it; rad or m.
  double stop_margin = 0;
};

/// Two shapes that overlap.
struct Overlap {
  std::size_t first = 0, second = 0;  ///< in Plan::shapes, first < second
  double depth = 0;                   ///< m
};

/// The violation of a joint's constraint.
struct JointError {
  double gap = 0;    ///< m
  double angle = 0;  ///< rad
};

class World {
 public:
  /// The plan must outlive the world.
  World(const Plan& plan, const WorldSetup& setup);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Throws std::bad_alloc if ODE runs out of memory.
  void step();
  double time() const;  ///< s, since the start
  double step_size() const;

  /// Lowest z of all moving shapes; none if there are none.
  std::optional<double> lowest_point() const;
  /// Adds a horizontal ground, which is not part of the plan.
  void add_ground(double z);

  /// Overlapping shapes that can collide: the deepest point of each pair, by pair.
  std::vector<Overlap> overlaps();

  /// X_WB; B is at the centre of mass and starts with the axes of the world. The identity for
  /// kWorld.
  Pose body_pose(std::size_t body) const;
  /// X_WL of a link of the plan.
  Pose link_pose(const LinkPlan& link) const;
  JointError joint_error(std::size_t joint) const;
  /// Hinge: rad; slider: m; 0 for the others.
  double joint_position(std::size_t joint) const;
  /// Kinetic and potential energy in metres: divided by the weight of all moving bodies; without
  /// gravity, by their weight on earth.
  double energy() const;
  /// Speed of the centre of mass of a body, in m/s.
  double speed(std::size_t body) const;
  bool is_finite() const;

 private:
  struct Engine;
  std::unique_ptr<Engine> engine_;
};

/// A complaint of ODE's solver, and its number of occurrences.
struct EngineMessage {
  std::string text;
  std::size_t count = 0;
};

/// ODE's complaints since the last call, in the order of their first occurrence.
std::vector<EngineMessage> take_engine_messages();

/// An error message about the linked ODE library; empty if it is usable.
std::string unusable_engine();

/// Starts ODE in this process. Fatal errors of ODE are passed to `on_fault`, which must not
/// return.
void start_engine(void (*on_fault)(const std::string& message));

}  // namespace smurf::load_check
