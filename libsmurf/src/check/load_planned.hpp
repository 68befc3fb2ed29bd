// SPDX-License-Identifier: BSD-3-Clause
// Loads one planned file with all that belongs to it, and judges it. Several threads do so at once.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "check/run.hpp"
#include "check/seen_companions.hpp"
#include "link/package_search.hpp"

namespace smurf {

struct PlannedLoader {
  const CheckSettings& settings;
  const RunContext& run;
  const SeenCompanions& seen;
  std::shared_ptr<PackageSearch> shared_search;  ///< of all threads, if nothing is kept
  std::uint64_t xacro_steps = 0;                 ///< of each expansion of xacro
  bool has_several_robots = false;

  void load(const PlannedFile& planned, const FileReader& files, MeshLibrary& meshes,
            Outcome& outcome) const;

 private:
  void load_one_scene(const PlannedFile& planned, LoadContext& context, Outcome& outcome) const;
  void load_one_robot(const PlannedFile& planned, LoadContext& context, Outcome& outcome) const;
  void keep_asked_for(const LinkedModel& model, Outcome& outcome) const;
  void take_companions(const Companions& companions, const LinkedModel& model,
                       Outcome& outcome) const;
  void take_files(LinkedModel&& model, Outcome& outcome) const;
  std::string identity_of(const std::string& path) const;
};

}  // namespace smurf
