// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/each.hpp"

#include <algorithm>
#include <string_view>

#include "base/files/path.hpp"
#include "check/parallel.hpp"
#include "link/companions/library.hpp"
#include "smurf/companions.hpp"

namespace smurf {

std::vector<EachFile> each_file(const Plan& plan) {
  std::vector<EachFile> files;
  for (const PlannedFile& one : plan.scenes) files.push_back({&one, true});
  for (const auto* planned : {&plan.models, &plan.others}) {
    for (const PlannedFile& one : *planned) {
      const bool is_beside =
          input_kind(one.path) == InputKind::annotation || is_companion_path(one.path);
      if (!is_beside) files.push_back({&one, false});
    }
  }
  std::sort(files.begin(), files.end(),
            [](const EachFile& a, const EachFile& b) { return a.planned->path < b.planned->path; });
  return files;
}

std::shared_ptr<CompanionFolders> SharedFolder::of(const EachFile& file) {
  const std::string_view folder = path::parent(file.planned->path);
  const std::lock_guard lock(mutex_);
  if (shared_ == nullptr || folder_ != folder) {
    folder_ = folder;
    shared_ = std::make_shared<CompanionFolders>();
  }
  return shared_;
}

Plan plan_of(const EachFile& file, const Plan& plan) {
  Plan alone;
  alone.configs = plan.configs;
  (file.is_scene ? alone.scenes : alone.models).push_back(*file.planned);
  return alone;
}

bool is_only_part(const EachFile& file, const Report& report) {
  return file.planned->may_be_part && report.summary.models == 0 && report.diagnostics.empty();
}

void for_each_of(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& check,
                 const std::function<bool(std::size_t)>& take) {
  for_each_in_order(
      count, count_of_jobs(jobs), [&](std::size_t, std::size_t i) { check(i); }, take);
}

}  // namespace smurf
