// SPDX-License-Identifier: BSD-3-Clause
// The bodies that shapes would be if they were full of one material.
#pragma once

#include <cstdint>
#include <optional>

#include "smurf/linked.hpp"

namespace smurf {

/// The file of a mesh of the URDF; null if it names none.
const MeshReference* find_reference(const LinkedModel& model, const urdf::Mesh& mesh);
/// The mesh or texture whose file name begins at this byte of the URDF; null if there is none.
const MeshReference* find_reference(const LinkedModel& model, std::uint32_t begin);
/// The facts about a mesh file; null if the file was not opened or cannot be read.
const MeshFacts* find_facts(const LinkedModel& model, const urdf::Mesh& mesh);

/// Whether a shape is a mesh in glTF, whose axes programs read in different ways: some turn y up to
/// z up.
bool is_gltf(const LinkedModel& model, const urdf::Geometry& geometry);

/// The body that a shape fills, in the frame of the shape, in m; its volume is positive. None if
/// the shape is unknown or not positive, or an open mesh.
std::optional<Solid> solid_of(const LinkedModel& model, const urdf::Geometry& geometry);
/// A block of this size and place.
Solid block(const Box& box);

/// The body in frame A; X_AB is the pose of its current frame.
Solid moved(const Solid& solid_B, const Pose& X_AB);
/// Both bodies as one.
Solid joined(const Solid& a, const Solid& b);

/// The inertia tensor per kg about the centre, as its entries xx, yy, zz, xy, xz and yz; m^2.
std::array<double, 6> unit_inertia(const Solid& solid);

/// The body of all visuals, else of all collisions of a link, in its frame. None if a shape of both
/// is unknown or open.
std::optional<Solid> solid_of(const LinkedModel& model, const urdf::Link& link);

}  // namespace smurf
