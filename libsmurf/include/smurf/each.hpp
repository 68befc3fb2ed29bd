// SPDX-License-Identifier: BSD-3-Clause
// Robots and scenes of a data set, each of which is checked by itself.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "smurf/check.hpp"

namespace smurf {

/// One robot or scene of a plan.
struct EachFile {
  const PlannedFile* planned = nullptr;
  bool is_scene = false;
};

/// All of them, sorted by path. They point into the plan.
std::vector<EachFile> each_file(const Plan& plan);

/// What the checks of files in one folder share: each of them would list it again, which takes a
/// time that grows with the square of their number. Several threads may use it.
class SharedFolder {
 public:
  /// For a file of the plan; ask in their order.
  std::shared_ptr<CompanionFolders> of(const EachFile& file);

 private:
  std::mutex mutex_;
  std::string folder_;
  std::shared_ptr<CompanionFolders> shared_;
};

/// The part of a plan that is about this file.
Plan plan_of(const EachFile& file, const Plan& plan);

/// Whether the file was found in a folder, and is only a part of robots.
bool is_only_part(const EachFile& file, const Report& report);

/// Calls `check(index)` for every index below `count` on `jobs` threads (0: one for each
/// processor), and then `take(index)`, in the order of the indices and one at a time, until it
/// returns false.
void for_each_of(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& check,
                 const std::function<bool(std::size_t)>& take);

}  // namespace smurf
