// SPDX-License-Identifier: BSD-3-Clause
#include "check/shared_companions.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "base/text/quoted.hpp"
#include "check/excuses.hpp"
#include "verdict/targets.hpp"

namespace smurf {
namespace {

using Key = std::tuple<const Rule*, std::uint32_t, std::uint32_t>;

Key key_of(const Diagnostic& one) { return {one.rule, one.span.begin, one.span.end}; }

}  // namespace

Accompanied load_robot(const std::string& path, bool was_found, std::span<const ConfigXacro> xacro,
                       LoadContext& context) {
  Accompanied robot;
  if (was_found) {
    robot.model = load_model(path, context);
    if (!robot.model.robot || robot.model.robot->links.empty()) return robot;
    robot.companions = load_companions(robot.model, context);
  } else {
    robot = load_accompanied(path, context);
    // A URDF that is a xacro without its name has no links, and would take files from the robots.
    const bool is_empty = robot.model.robot && robot.model.robot->links.empty();
    if (is_empty && !is_companion_path(path)) robot.companions = {};
  }
  std::map<std::string, std::vector<std::string>> values;  // of arguments
  const std::string id = context.files.identity(robot.model.urdf_path);
  for (const ConfigXacro& one : xacro) {
    if (context.files.identity(one.file.value) != id) continue;
    for (const auto& [name, all] : one.arguments) values.emplace(name.value, all);
  }
  split_variants(robot, context, values);
  return robot;
}

std::vector<CompanionFindings::Found> CompanionFindings::finish() {
  std::vector<Found> all;
  for (auto& one_file : files_) {
    auto& entry = one_file.second;  // a lambda cannot capture a part of a structured binding
    std::vector<std::size_t> owners = choose_owners(entry.claims);
    for (const std::size_t one : owners) owners_.emplace(one_file.first, entry.robots[one].robot);
    // The variants of a configuration are all meant.
    const bool has_variants = std::any_of(owners.begin(), owners.end(), [&](std::size_t one) {
      return entry.robots[one].is_variant;
    });
    std::map<Key, std::size_t> counts;
    for (const std::size_t one : owners) {
      std::set<Key> seen;
      for (const Diagnostic& found : entry.robots[one].found) {
        if (seen.insert(key_of(found)).second) ++counts[key_of(found)];
      }
    }
    std::set<Key> taken;  // of robots before this one
    for (const std::size_t one : owners) {
      OfRobot& robot = entry.robots[one];
      std::set<Key> own;
      for (Diagnostic& found : robot.found) {
        const Key key = key_of(found);
        const bool is_of_all = counts[key] == owners.size();
        if (!has_variants && taken.contains(key)) continue;
        // A name that a robot has with some arguments is right.
        if (!is_of_all && is_about_name(found)) continue;
        if (!has_variants && !is_of_all) {
          found.severity = Severity::info;
          found.when(kExcused);  // a target makes it no error either
          found.note("only with " + quoted(robot.robot) + "; the file fits other robots as well");
        }
        own.insert(key);
        all.push_back({robot.config, std::move(found)});
      }
      taken.merge(own);
    }
  }
  return all;
}

}  // namespace smurf
