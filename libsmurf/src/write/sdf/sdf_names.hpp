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

/// The names of the links of a model. With `bodies`, of links by link, those of nested models are
/// kept: `arm::hand` is the link `hand` of the model `arm`, if nothing else is called `arm`.
std::vector<std::string> sdf_names(const LinkedModel& model,
                                   const std::vector<std::size_t>* bodies = nullptr);
/// The models around a name: "arm::left" of "arm::left::hand"; "" if there is none.
std::string_view sdf_scope(std::string_view name);
/// The nested model that a joint between two links is in; "": the model.
std::string_view sdf_joint_scope(std::string_view joint, std::string_view parent,
                                 std::string_view child);
/// A name as it is said in a scope around it.
std::string_view sdf_local(std::string_view name, std::string_view scope);
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
