// SPDX-License-Identifier: BSD-3-Clause
// How models stand on the floor that an option adds.
#pragma once

#include "smurf/write_scene.hpp"

namespace smurf {

/// Lifts a single model onto the floor, and reports models of a scene that are below it. `flat` is
/// that of `written`.
void stand_on_floor(FlatScene& flat, const SceneExport& written);

}  // namespace smurf
