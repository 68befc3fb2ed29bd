// SPDX-License-Identifier: BSD-3-Clause
// Scenes that are made from files of other languages: the worlds of SDF.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "smurf/load.hpp"

namespace smurf {

/// The models of such scenes, by path: "worlds/hall.sdf#table".
using MadeModels = std::map<std::string, xacro::Expansion>;

/// Whether a file may hold a world, by its name.
bool has_name_of_world(std::string_view path);
/// Whether a file holds a world and no robot.
bool is_world_file(const std::string& path, const FileReader& files, const Limits& limits);

/// Makes a scene of the world in a file that has been read. Reports why that is not possible, and
/// returns false.
bool read_imported_world(SceneFile& file, MadeModels& models, LoadContext& context);

/// Gives the entities of such a scene the places in the file that a person edits, as their `span`.
void find_written(Scene& scene, const LoadContext& context);

/// The name of a model of such a scene, by its path; "" for the path of a file.
std::string_view name_in_world(std::string_view path);

/// Makes a model of a robot that was made from such a world: finds its names, its tree and its
/// meshes.
LinkedModel load_made_model(const std::string& path, xacro::Expansion made, LoadContext& context);

}  // namespace smurf
