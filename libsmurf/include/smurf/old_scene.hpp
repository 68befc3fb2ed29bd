// SPDX-License-Identifier: BSD-3-Clause
// Scenes of MARS before SMURF: entities of type scn (a zip that contains XML), scene (XML) and yml.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "smurf/linked.hpp"
#include "smurf/load.hpp"
#include "smurf/xml.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Exactly one of the two is set.
struct OldSceneFile {
  std::optional<yaml::Document> yaml;
  std::optional<xml::Document> xml;
};

/// By the path of the entity's file.
using OldScenes = std::map<std::string, OldSceneFile, std::less<>>;

/// Reads the old scenes that a scene names, each once. Reports and omits files that cannot be read.
OldScenes load_old_scenes(const LinkedScene& scene, LoadContext& context);

}  // namespace smurf
