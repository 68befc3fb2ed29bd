// SPDX-License-Identifier: BSD-3-Clause
// The settings of a URDF for MuJoCo: the element `compiler` in its element `mujoco`.
#pragma once

#include "smurf/load.hpp"

namespace smurf {

/// MuJoCo refuses an STL file of more triangles (stl_decoder.cc:70).
inline constexpr std::size_t kMostStlTrianglesOfMujoco = 200000;

/// The element; empty if there is none.
xml::View mujoco_compiler(const LinkedModel& model);

/// Whether MuJoCo discards visuals, which is its default.
bool keeps_visuals(const LinkedModel& model);

/// Whether it tells MuJoCo to look for meshes in other folders.
bool is_told_where_meshes_are(const LinkedModel& model);

/// Whether `balanceinertia` tells MuJoCo to repair impossible inertias.
bool balances_inertias(const LinkedModel& model);

/// Whether MuJoCo merges links that fixed joints connect into one body. It does so by default.
bool fuses_fixed_links(const LinkedModel& model);

// Cases of SML1647: MuJoCo keeps the folder in the path of a mesh since 3.7, unless it is told to
// strip it.
inline constexpr Circumstance kLostToNewMujoco{"with its folder"};
inline constexpr Circumstance kLostToOldMujoco{"without its folder"};

/// Reports meshes that are not in the folder where MuJoCo looks for them.
void check_meshes_of_mujoco(const LinkedModel& model, const LoadContext& context);

}  // namespace smurf
