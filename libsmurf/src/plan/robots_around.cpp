// SPDX-License-Identifier: BSD-3-Clause
#include "plan/robots_around.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "link/companions/library.hpp"
#include "link/companions/places.hpp"
#include "link/package_search.hpp"
#include "link/surroundings/stated_ties.hpp"
#include "link/surroundings/wanted_names.hpp"
#include "plan/companion_robots.hpp"
#include "smurf/companions.hpp"
#include "smurf/load.hpp"
#include "smurf/names.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostStatedRobots = 6;

/// The robots that other files give the file to.
std::vector<std::string> stated_robots(const std::string& path, const FileReader& files,
                                       const Limits& limits, CompanionRobots& robots_of) {
  SourceMap sources;
  DiagnosticSink ignored(limits);
  LoadContext context{sources, files, ignored, limits, {}};
  const std::string wanted = path::normalize(path);
  const CompanionPlaces places =
      companion_places(std::string(path::parent(path)), files, search_of(context));
  std::set<std::string> robots;  // by identity
  for (const NearPackage& package : places.packages) {
    for (const StatedTie& tie :
         search_of(context).companions->stated->in_package(package, context)) {
      const bool is_here =
          path::normalize(tie.by) == wanted ||
          std::any_of(tie.files.begin(), tie.files.end(),
                      [&](const std::string& one) { return path::normalize(one) == wanted; });
      if (is_here) robots.insert(tie.robots.begin(), tie.robots.end());
    }
  }
  std::vector<std::string> found;
  if (robots.empty()) return found;
  for (const std::string& one : robots_of.in_project(path)) {
    if (robots.contains(files.identity(one)) && found.size() < kMostStatedRobots)
      found.push_back(one);
  }
  return found;
}

}  // namespace

std::vector<std::string> robots_around(const std::string& path, const FileReader& files,
                                       const Limits& limits) {
  const FileContent content = files.read(path, limits.file_bytes);
  if (content.status != ReadStatus::ok) return {};
  const bool is_companion = find_companion_kind(path, content.text) != nullptr;
  if (!is_companion && !is_surrounding_file(path, content.text)) return {};
  SeenCompanion seen;
  if (is_companion) {
    CompanionLibrary library(nullptr);
    seen.names = library.look_at(path, files).names;
  } else {
    for (std::string& name : frames_in(path, content.text, limits))
      seen.names.push_back({NameKind::link, std::move(name)});
  }
  // A project may be a repository of thousands of robots.
  using Scope = CompanionRobots::Scope;
  for (const Scope scope : {Scope::packages, Scope::project}) {
    CompanionRobots all(files, limits, scope);
    std::vector<std::string> robots = stated_robots(path, files, limits, all);
    if (robots.empty()) robots = all.of(path, seen, {});
    if (!robots.empty()) return robots;
  }
  return {};
}

}  // namespace smurf
