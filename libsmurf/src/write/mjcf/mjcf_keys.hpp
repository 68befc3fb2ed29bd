// SPDX-License-Identifier: BSD-3-Clause
// The keyframes of a MuJoCo world: `initial`, the start, and each joint pose set of its robots.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "smurf/linked.hpp"
#include "write/text/xml_text.hpp"

namespace smurf {

class MjcfKeys {
 public:
  /// Where a joint is; rad or m.
  using PositionOf =
      std::function<double(std::size_t instance, const urdf::Joint&, const JointPositions&)>;

  /// Appends the start of the next joint, in the order of the joints.
  void add_position(std::size_t instance, const urdf::Joint& joint, double start) {
    positions_.push_back({instance, &joint, start, {}});
  }
  /// The same of a free joint: its numbers.
  void add_free(std::string numbers) { positions_.push_back({0, nullptr, 0, std::move(numbers)}); }
  /// Appends the command of the next motor; `joint`: what it moves to a position, null: what it
  /// drives is no position.
  void add_command(std::size_t instance, const urdf::Joint* joint, double command) {
    commands_.push_back({instance, joint, command, {}});
  }

  /// A joint pose set of a robot.
  struct Posed {
    std::size_t instance = 0;
    std::string name;
    JointPositions positions;
  };
  /// Whether so many pose sets can be written: each repeats the numbers of the whole world.
  bool has_room_for(std::size_t sets) const;
  /// Writes <keyframe>, if something can move.
  void write(XmlText& xml, const std::vector<Posed>& sets, const PositionOf& position_of) const;

 private:
  struct Number {
    std::size_t instance = 0;
    const urdf::Joint* joint = nullptr;
    double start = 0;
    std::string free;  ///< of a free joint
  };

  static std::string text_of(const std::vector<Number>& numbers, const Posed* set,
                             const PositionOf& position_of);

  std::vector<Number> positions_;  ///< qpos
  std::vector<Number> commands_;   ///< ctrl
};

}  // namespace smurf
