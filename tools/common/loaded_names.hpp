// SPDX-License-Identifier: BSD-3-Clause
// What is planned, loaded, and the names in it: for all who ask what a name means.
#pragma once

#include <deque>
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
  /// Of each part.
  const std::vector<std::vector<Reference>>& names() const { return names_; }
  /// As a model or scene, or a file of one.
  bool has_read(const std::string& path) const;

 private:
  void load_scene(const std::string& path);
  void load_model(const std::string& path);
  void note(const LinkedModel& model, Part& part) const;
  std::vector<std::string> srdfs_of(const LinkedModel& model) const;

  Session& session_;
  CheckSettings settings_;
  std::deque<LoadedScene> scenes_;
  std::deque<LoadedModel> models_;
  std::deque<xml::Document> srdfs_;
  std::deque<Part> parts_;
  std::vector<std::vector<Reference>> names_;
};

}  // namespace smurf::tools
