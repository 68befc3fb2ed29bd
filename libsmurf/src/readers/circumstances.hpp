// SPDX-License-Identifier: BSD-3-Clause
// Circumstances of findings that readers see, and that facts are about. Each is added by the reader
// under which it stands here (Reader::see).
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

#include "base/findings/readers.hpp"
#include "smurf/linked.hpp"

namespace smurf {

// Every URDF reader: in joints of these types, and in the inertial of the link `world`.
inline constexpr Circumstance kInFixed{"in a fixed joint"};
inline constexpr Circumstance kInFloating{"in a floating joint"};
inline constexpr Circumstance kInContinuous{"in a continuous joint"};
inline constexpr Circumstance kInPlanar{"in a planar joint"};
inline constexpr Circumstance kOfWorld{"of the world"};

// MuJoCo: in inertials, by what moves the link.
inline constexpr Circumstance kCarried{"carried"};  ///< fixed to another link, or to the world
inline constexpr Circumstance kStill{"still"};      ///< nothing moves it
inline constexpr Circumstance kAlone{
    "alone"};  ///< the only inertial of a moving body that is not zero
// MuJoCo: in a tensor whose moments are 0.
inline constexpr Circumstance kWithoutMoments{"without moments"};
// MuJoCo: in a link that is part of a moving body without mass and collisions.
inline constexpr Circumstance kMasslessBody{"massless body"};
// MuJoCo: where the file tells it to.
inline constexpr Circumstance kVisualsKept{"visuals kept"};
inline constexpr Circumstance kBalanced{"balanced"};
inline constexpr Circumstance kElsewhere{"in another folder"};
// MuJoCo: a file of the name of the mesh is in the folder of the URDF.
inline constexpr Circumstance kBeside{"beside the URDF"};
inline constexpr Fact kMujocoLooksBeside{
    &readers::mujoco, Effect::takes,
    "looks beside the URDF for a file of that name, whatever its folder", "3.6.0, run",
    when(kBeside).before({3, 7})};

// Gazebo: in joints and links that it drops, and on names of links that it drops or merges.
inline constexpr Circumstance kDroppedByGazebo{"dropped by Gazebo"};

// Gazebo, Newton: in joints that no root reaches.
inline constexpr Circumstance kUnreached{"no root reaches it"};
// Newton: everywhere, where joints name links that are missing.
inline constexpr Circumstance kMissed{"a joint misses a link"};

// The case of SML1512, which MuJoCo refuses also where it does not use the inertia.
inline constexpr Circumstance kNotPositiveDefinite{"not positive definite"};

// Newton, Isaac, PyBullet: in SML1207 and SML1208, no link with joints is a root.
inline constexpr Circumstance kRootless{"no root has joints"};

// Isaac: on attributes that it cannot keep, wherever they stand.
inline constexpr Circumstance kPrefixed{"prefixed"};

// Drake: in elements that the author lets it ignore.
inline constexpr Circumstance kDrakeIgnored{"drake_ignore"};

/// The part whose span contains the byte at `place`; null if there is none. The parts are in the
/// order of the file and do not overlap.
template <class Part>
const Part* part_at(const std::vector<Part>& parts, std::uint32_t place) {
  const auto next = std::partition_point(
      parts.begin(), parts.end(), [&](const Part& part) { return part.span.begin <= place; });
  if (next == parts.begin()) return nullptr;
  const Part& part = *std::prev(next);
  return place < part.span.end ? &part : nullptr;
}

template <class Part>
std::size_t index_in(const std::vector<Part>& parts, const Part& part) {
  return static_cast<std::size_t>(&part - parts.data());
}

}  // namespace smurf
