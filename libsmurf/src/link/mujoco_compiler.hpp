// SPDX-License-Identifier: BSD-3-Clause
// What a URDF tells MuJoCo about reading it: the element `compiler` in its element `mujoco`.
#pragma once

#include "smurf/load.hpp"

namespace smurf {

/// A construct of findings on paths of meshes, where the file tells MuJoCo to look elsewhere.
inline constexpr std::string_view kElsewhere = "#elsewhere";

/// The construct of findings on inertias when the file tells MuJoCo to balance inertias.
inline constexpr std::string_view kBalanced = "#balanced";

/// The element; empty when there is none.
xml::View mujoco_compiler(const LinkedModel& model);

/// MuJoCo discards visuals, unless the file says otherwise.
bool keeps_visuals(const LinkedModel& model);

/// Does it tell MuJoCo to look for meshes elsewhere than their paths say?
bool is_told_where_meshes_are(const LinkedModel& model);

/// Whether `balanceinertia` tells MuJoCo to repair inertias that no body can have.
bool balances_inertias(const LinkedModel& model);

/// Reports the meshes that are not where MuJoCo is told to look for them.
void check_meshes_of_mujoco(const LinkedModel& model, const LoadContext& context);

}  // namespace smurf
