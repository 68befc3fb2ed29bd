// SPDX-License-Identifier: BSD-3-Clause
// Loads the planned files and finds the names in them, for code that asks what a name means.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "smurf/check.hpp"
#include "smurf/references.hpp"

namespace smurf::tools {

/// Models and scenes of a plan, with the SRDF files beside their URDF, and the names in each. Names
/// and spans point into what was loaded by the session.
class LoadedNames {
 public:
  LoadedNames(const Plan& plan, const CheckSettings& settings, Session& session);

  /// One model with its SRDF files, or one scene with its models.
  struct Part {
    const LoadedModel* model = nullptr;  ///< null: a scene
    const LoadedScene* scene = nullptr;
    std::vector<const xml::Document*> srdfs = {};
    std::set<std::string> read = {};  ///< all its files, by identity
  };
  const std::deque<Part>& parts() const { return parts_; }
  /// The names of each part.
  const std::vector<std::vector<Reference>>& names() const { return names_; }
  /// True for a planned model or scene, and for a file that belongs to one.
  bool has_read(const std::string& path) const;
  /// The reason why names are missing; "" if none is missing.
  const std::string& problem() const { return problem_; }

  /// Frees the loaded files, but keeps the names and their texts in the files.
  void release();

 private:
  void load_scene(const std::string& path);
  void load_model(const std::string& path);
  void note(const LinkedModel& model, Part& part) const;
  void add_srdfs(LoadedModel& loaded, Part& part, std::vector<Reference>& names);
  const std::vector<std::string>& srdfs_in(const std::string& folder);
  const xml::Document* srdf(const std::string& path, LoadedModel& loaded);

  Session& session_;
  CheckSettings settings_;
  std::deque<LoadedScene> scenes_;
  std::deque<LoadedModel> models_;
  std::map<std::string, std::optional<xml::Document>> srdfs_;         ///< by path
  std::map<std::string, std::vector<std::string>> folders_of_srdfs_;  ///< their paths
  std::uint64_t repeated_bytes_ = 0;  ///< of SRDF files whose names each model stores
  std::string problem_;
  std::set<std::string> read_;  ///< in any part, by identity
  std::deque<Part> parts_;
  std::vector<std::vector<Reference>> names_;
};

}  // namespace smurf::tools
