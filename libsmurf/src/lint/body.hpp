// SPDX-License-Identifier: BSD-3-Clause
// A link as a body: its inertial compared with the space of its shapes.
#pragma once

#include <optional>
#include <string_view>

#include "smurf/linked.hpp"

namespace smurf {

/// The axis-aligned box around all visuals and collisions of a link, in the link's frame, m.
struct Extent {
  Vector3 low{}, high{};

  double volume() const;
  double longest_edge() const;
  /// The same box, `margin` larger on every side.
  Extent grown(double margin) const;
  bool contains(const Vector3& point) const;
};
/// kg; lighter bodies are frames of sensors and similar links, whose made-up numbers matter
/// little.
inline constexpr double kNegligibleMass = 0.01;  // kg
/// kg; the tip of a finger. A gram is the usual placeholder.
inline constexpr double kSmallestPart = 0.002;  // kg
/// Density of osmium; nothing is heavier.
inline constexpr double kHeaviestMaterial = 22600;  // kg/m3
/// Less than half of the density of air. Boxes of a metre with a kilogram are usual placeholders.
inline constexpr double kLightestMaterial = 0.5;  // kg/m3
/// Parts of a robot are nearer to each other; farther origins are reported (SML1442).
inline constexpr double kFarthestOrigin = 10;  // m

/// None if the link has no shape, or a shape of unknown size, such as a missing mesh.
std::optional<Extent> extent_of(const LinkedModel& model, const urdf::Link& link);

/// The same for the link and links without mass that fixed joints connect to it: its mass may be
/// theirs. None if one of them has a shape of unknown size.
std::optional<Extent> extent_of_rigid_parts(const LinkedModel& model, const urdf::Link& link);

struct Body {
  double mass = 0;   ///< kg, positive
  Vector3 center{};  ///< of mass, in the link frame, m
  /// Integral of x^2, y^2 and z^2 over the mass, about the centre of mass, along the axes of the
  /// link: what the box around the body bounds. kg m^2
  Vector3 second_moments{};
};
/// None unless mass and inertia are readable and physically possible.
std::optional<Body> body_of(const urdf::Inertial& inertial);

/// The factor by which the second moments exceed those of any mass inside the box (Bhatia-Davis: at
/// most m (high - c)(c - low) along each axis), for the worst axis. A centre of mass outside of the
/// box counts as its middle.
double excess_over(const Body& body, const Extent& extent);

/// The ratio of the inertia (its trace) to that of a homogeneous block that fills the box.
double ratio_to_block(const Body& body, const Extent& extent);

}  // namespace smurf
