// SPDX-License-Identifier: BSD-3-Clause
// Loads the planned files and finds the names in them, for code that asks what a name means.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "smurf/check.hpp"
#include "smurf/companions.hpp"
#include "smurf/references.hpp"

namespace smurf::tools {

/// Models and scenes of a plan, models with their companions, and the names in each. Names and
/// spans point into what was loaded by the session.
class LoadedNames {
 public:
  /// What stays in memory: thousands of models may share a large file.
  enum class Keeps : std::uint8_t { files, names };
  /// How far from the robots names are looked for.
  enum class Reach : std::uint8_t {
    companions,
    surroundings,  ///< also in launch files, and in files of navigation and RViz
  };
  LoadedNames(const Plan& plan, const CheckSettings& settings, Session& session, Reach reach,
              Keeps keeps = Keeps::files);

  /// One model with its companions, or one scene with its models.
  struct Part {
    const LoadedModel* model = nullptr;  ///< null: a scene
    const LoadedScene* scene = nullptr;
    const Companions* companions = nullptr;                         ///< of the model
    std::shared_ptr<const xacro::Expansions> expansions = nullptr;  ///< of the model
    std::set<std::string> read = {};                                ///< all its files, by identity
    std::set<std::string> around = {};  ///< surrounding files with its names, by identity
  };
  /// There are none if only the names are kept.
  const std::deque<Part>& parts() const { return parts_; }
  /// The names of each part.
  const std::vector<std::vector<Reference>>& names() const { return names_; }
  /// Leaves out the names in these surrounding files.
  void leave(const std::set<std::string>& paths);
  /// True for a planned model or scene, and for a file that belongs to one.
  bool has_read(const std::string& path) const;
  /// All these files, by identity.
  const std::set<std::string>& read() const { return read_; }
  /// The reason why names are missing; "" if none is missing.
  const std::string& problem() const { return problem_; }

 private:
  void load_scene(const std::string& path);
  void load_model(const std::string& path);
  void note(const LinkedModel& model, Part& part) const;
  /// Adds the names of the last part.
  void finish(std::vector<Reference> names);

  Session& session_;
  CheckSettings settings_;
  Reach reach_;
  Keeps keeps_;
  std::deque<LoadedScene> scenes_;
  std::deque<LoadedModel> models_;
  std::deque<Companions> companions_;  ///< by model
  std::string problem_;
  std::set<std::string> read_;  ///< in any part, by identity
  std::deque<Part> parts_;
  std::vector<std::vector<Reference>> names_;
  std::shared_ptr<PackageSearch> search_;  ///< of all models: no file changes meanwhile
  std::deque<std::string> texts_;  ///< of names that the files write otherwise, if only names stay
};

}  // namespace smurf::tools
