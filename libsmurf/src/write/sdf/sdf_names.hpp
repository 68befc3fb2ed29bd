// SPDX-License-Identifier: BSD-3-Clause
// Names that SDF accepts.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/flatten.hpp"

namespace smurf {

/// SDF reserves `world`, names like `__this__`, and the separator `::`. libsdformat refuses the
/// file for one of them.
std::string sdf_name(std::string_view name);

/// The names of the links of a model.
std::vector<std::string> sdf_names(const LinkedModel& model);
/// By instance: the names of models in the world, without reserved ones.
std::vector<std::string> sdf_names(const FlatScene& scene);

/// By link: the link whose body contains it. A link without mass at the end of a fixed joint
/// belongs to its parent; libsdformat merges all links at fixed joints.
std::vector<std::size_t> sdf_bodies(const LinkedModel& model, bool as_libsdformat);

/// The names of visuals and collisions, unique in each body. They are those of libsdformat, where
/// it merges no links.
struct SdfShapeNames {
  std::map<const urdf::Visual*, std::string> visuals;
  std::map<const urdf::Collision*, std::string> collisions;
};
SdfShapeNames sdf_shape_names(const LinkedModel& model, const std::vector<std::size_t>& bodies);

}  // namespace smurf
