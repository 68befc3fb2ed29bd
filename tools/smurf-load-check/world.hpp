// SPDX-License-Identifier: BSD-3-Clause
// A plan as an ODE world that can be stepped and measured. The only part that knows ODE. What ODE
// refuses ends the process: use it in a child process, after the bodies were checked.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "smurf-load-check/plan.hpp"

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

/// Two shapes that are inside each other.
struct Overlap {
  std::size_t first = 0, second = 0;  ///< in Plan::shapes, first < second
  double depth = 0;                   ///< m
};

/// How far a joint is from what it allows.
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

  /// Throws std::bad_alloc when ODE gets no memory.
  void step();
  double time() const;  ///< s, since the start
  double step_size() const;

  /// Lowest z of all shapes that move; none when there are none.
  std::optional<double> lowest_point() const;
  /// A horizontal ground, part of no plan.
  void add_ground(double z);

  /// Shapes that overlap and may touch, deepest point of each pair, by pair.
  std::vector<Overlap> overlaps();

  /// X_WB; B lies in the centre of mass and starts with the axes of the world. The identity for
  /// kWorld.
  Pose body_pose(std::size_t body) const;
  /// X_WL of a link of the plan.
  Pose link_pose(const LinkPlan& link) const;
  JointError joint_error(std::size_t joint) const;
  /// Hinge: rad; slider: m; 0 for the others.
  double joint_position(std::size_t joint) const;
  /// Kinetic and potential, in metres: divided by the weight of all that moves; without gravity by
  /// its weight on earth.
  double energy() const;
  /// Speed of the centre of mass of a body, in m/s.
  double speed(std::size_t body) const;
  bool is_finite() const;

 private:
  struct Engine;
  std::unique_ptr<Engine> engine_;
};

/// Something that ODE's solver complains about, and how often.
struct EngineMessage {
  std::string text;
  std::size_t count = 0;
};

/// What ODE said since the last call, in the order in which it began to.
std::vector<EngineMessage> take_engine_messages();

/// What is wrong with the ODE library that this program was linked with; empty when nothing is.
std::string unusable_engine();

/// Starts ODE in this process. Whatever ODE gives up on is passed to `on_fault`, which must not
/// return.
void start_engine(void (*on_fault)(const std::string& message));

}  // namespace smurf::load_check
