// SPDX-License-Identifier: BSD-3-Clause
// Bodies: links that fixed joints combine.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/findings/uncertain.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// Whether a reader finds elements whose names are written in another case.
enum class Case { ignored, heeded };
/// By link: whether it is part of a moving body without mass and without collisions from which a
/// reader could compute one.
std::vector<bool> massless_bodies(const LinkedModel& model, Case names = Case::ignored);

/// The bodies that MuJoCo builds: it merges what fixed joints connect, welds the root to the world,
/// and gives the collisions of a link without an inertial the density of water.
class BodiesOfMujoco {
 public:
  explicit BodiesOfMujoco(const LinkedModel& model);

  /// Whether the link is part of a moving body without mass and collisions.
  bool is_massless(std::size_t link) const { return massless_[link]; }
  /// Whether the link has no inertial, but collisions that add to the mass of a moving body in
  /// which another link has one.
  bool adds_mass_of_shapes(std::size_t link) const { return adds_[link]; }

 private:
  std::vector<bool> massless_, adds_;  ///< by link
};

/// True when the link, or a link fixed to it, has an inertial.
bool has_fixed_mass(const LinkedModel& model, LinkIndex link);

/// By link: whether it is fixed to links that weigh at least as much. Readers can then treat them
/// as one body, so its own mass and inertia matter little.
std::vector<bool> fixed_to_heavier(const LinkedModel& model);

/// By link: whether it is a root, or only fixed joints lead to it from one.
std::vector<bool> fixed_to_root(const LinkedModel& model);

/// By link: the topmost link of the body into which sdformat merges it. Links below `world` are
/// separate bodies.
std::vector<std::size_t> bodies_of_sdformat(const LinkedModel& model);

/// Whether the element is named exactly `inertial`: our own reader accepts other cases, too.
bool has_exact_name(const LinkedModel& model, const urdf::Inertial& inertial);

/// The mass (kg) that sdformat reads, whatever its sign; 0 if urdfdom cannot read the inertial.
double mass_in_sdformat(const LinkedModel& model, std::size_t link);

/// By link: the mass (kg) of the body into which sdformat merges it. Fixed joints merge links,
/// except for joints that a Gazebo element keeps.
std::vector<double> masses_of_bodies(const LinkedModel& model);

/// By link: the link into which sdformat merges it; none if it drops the body, and for `world`.
std::vector<std::optional<LinkIndex>> links_of_sdformat(const LinkedModel& model);

/// Whether sdformat drops all links.
bool is_left_without_links(const LinkedModel& model);

/// Whether sdformat accepts an inertial: moments ixx, iyy, izz and products ixy, ixz, iyz.
bool is_inertia_of_sdformat(double mass, const std::array<double, 3>& moments,
                            const std::array<double, 3>& products);

/// By link: whether no other link of its body, which moves, has an inertial whose tensor is not
/// zero. MuJoCo leaves out those of zero.
std::vector<bool> alone_in_motion(const LinkedModel& model);

/// Findings in links for which this is true.
inline constexpr Circumstance kSoundTogether{"sound together"};
/// By link: whether the sum of the inertials that sdformat merges is acceptable to it, even if each
/// is not. Like gz-math, it accepts a moment of 0. Also true if sdformat drops the body and keeps
/// others.
std::vector<bool> sound_together(const LinkedModel& model);

/// By link: whether sdformat merges it into a body of several inertials whose smallest moment is so
/// close to 0 that rounding decides whether sdformat accepts the body.
std::vector<bool> near_zero_together(const LinkedModel& model);

/// By link: how far the moments of its inertial are rounded when sdformat adds it to the others of
/// its body, in kg m^2; 0 if there is no other link.
std::vector<double> roundings_of_sdformat(const LinkedModel& model);

/// A fact about links that are near_zero_together().
inline constexpr Fact kGazeboAddsZeros{
    &readers::gazebo, Effect::refuses,
    "adds it to the inertias of links that are fixed to it, and refuses a sum that rounding makes "
    "negative",
    kRun, when(kUncertain)};

/// Whether a joint begins at a link to which no joint leads. A joint between a link and itself
/// leads to the link.
bool has_root_with_joints(const LinkedModel& model);

/// By link: whether joints lead to it from a root. Rings that no root reaches are left out.
std::vector<bool> reached_links(const LinkedModel& model);

}  // namespace smurf
