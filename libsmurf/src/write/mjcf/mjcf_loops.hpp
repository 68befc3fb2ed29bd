// SPDX-License-Identifier: BSD-3-Clause
// Loops of a MuJoCo world: equalities between bodies.
#pragma once

#include <map>
#include <vector>

#include "write/mjcf/mjcf_sensors.hpp"
#include "write/parts/loops.hpp"

namespace smurf {

class MjcfLoops : protected MjcfSensors {
 public:
  using MjcfSensors::MjcfSensors;

 protected:
  bool has_loops(std::size_t instance) {
    return robot_of(instance) != nullptr && !ends_of(*robot_of(instance)).empty();
  }
  /// Writes the sites of loops in the body of a link.
  void add_loop_sites(std::size_t instance, std::size_t link);
  /// Inside <equality>.
  void add_loop_equalities(std::size_t instance);
  /// Calls `exclude(body, other)` for both sides of each loop, whose shapes may overlap there.
  void exclude_loop_ends(std::size_t instance, const auto& exclude) {
    for (const Ends& ends : ends_of(*robot_of(instance))) {
      exclude(name(instance, link_name(*robot_of(instance), ends.loop.parent)),
              name(instance, link_name(*robot_of(instance), ends.loop.child)));
    }
  }

 private:
  /// Where both sides of a loop are held together.
  struct Ends {
    Loop loop;
    bool needs_sites = false;        ///< open at the zero of all joints, where MuJoCo measures it
    std::vector<Vector3> anchors{};  ///< in the frame of the joint; one for a hinge in a plane
  };

  const std::vector<Ends>& ends_of(const LinkedModel& model);
  std::string site(std::size_t instance, const Ends& ends, std::size_t anchor, bool of_child) const;

  std::map<const LinkedModel*, std::vector<Ends>> ends_;
};

}  // namespace smurf
