// SPDX-License-Identifier: BSD-3-Clause
#include "check/shared_companions.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace smurf {

CompanionFit fit_of(const Companion& companion, const LinkedModel& model) {
  bool has_hardware = false;
  if (model.robot) {
    for (const xml::View child : model.robot->document.view()) {
      has_hardware = has_hardware || child.name() == "ros2_control";
    }
  }
  return {companion.kind, companion.known_names * 2 + (has_hardware ? 1 : 0),
          companion.known_names == companion.names};
}

void keep_certain(Companions& companions, const LoadContext& context) {
  constexpr std::size_t kFewestNames = 4;  // fewer may be the same by chance
  std::set<std::string> chosen;            // by identity
  for (const CompanionTie& tie : context.ties) {
    for (const std::string& file : tie.files) chosen.insert(context.files.identity(file));
  }
  for (const PluginFile& one : companions.plugin_files) {
    chosen.insert(context.files.identity(one.path));
  }
  bool has_srdf = false;
  std::erase_if(companions.files, [&](const Companion& one) {
    const bool is_certain = one.names >= kFewestNames && one.known_names * 10 >= one.names * 9;
    const bool is_chosen =
        chosen.contains(context.files.identity(context.sources.path(one.source)));
    const bool is_kept = is_certain || is_chosen;
    has_srdf = has_srdf || (is_kept && one.srdf);
    return !is_kept && one.names > 0;
  });
  std::erase_if(companions.files,
                [&](const Companion& one) { return one.names == 0 && !has_srdf; });
}

Accompanied load_robot(const std::string& path, bool was_found, std::span<const ConfigXacro> xacro,
                       LoadContext& context) {
  Accompanied robot;
  if (was_found) {
    robot.model = load_model(path, context);
    if (!robot.model.robot || robot.model.robot->links.empty()) return robot;
    robot.companions = load_companions(robot.model, context);
  } else {
    robot = load_accompanied(path, context);
  }
  std::map<std::string, std::vector<std::string>> values;  // of arguments
  const std::string id = context.files.identity(robot.model.urdf_path);
  for (const ConfigXacro& one : xacro) {
    if (context.files.identity(one.file.value) != id) continue;
    for (const auto& [name, all] : one.arguments) values.emplace(name.value, all);
  }
  split_variants(robot, context, values);
  if (was_found) keep_certain(robot.companions, context);
  return robot;
}

void SharedCompanions::add(const Key& key, std::size_t rank, bool is_first, Found found) {
  Entry& entry = entries_[key];
  if (rank < entry.rank) return;
  if (rank > entry.rank) entry = {rank, 0, {}};
  if (is_first) ++entry.robots;
  if (entry.robots == 1) entry.found.push_back(std::move(found));
}

void SharedCompanions::note(const std::string& file, std::size_t rank) {
  Best& best = best_[file];
  if (rank < best.rank) return;
  if (rank > best.rank) best = {rank, 0};
  ++best.robots;
}

std::vector<SharedCompanions::Found> SharedCompanions::finish() {
  std::vector<Found> all;
  for (auto& [key, entry] : entries_) {
    const Best& best = best_[key.file];
    if (entry.rank != best.rank || entry.robots != best.robots) continue;
    for (Found& one : entry.found) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace smurf
