// SPDX-License-Identifier: BSD-3-Clause
#include "plan/companion_robots.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "base/files/path.hpp"
#include "link/companions/places.hpp"
#include "plan/project_inputs.hpp"
#include "plan/xacro_text.hpp"
#include "smurf/companions.hpp"
#include "smurf/confine.hpp"
#include "smurf/plan.hpp"
#include "xacro/whole_word.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostRobots = 6;
constexpr std::uint64_t kMostBytesOfText = 1U << 20U;

/// The robots in the package of a file, and in those beside it.
FoundInputs inputs_beside(const std::string& path, const FileReader& files,
                          PackageSearch& packages) {
  FoundInputs found;
  const std::string_view parent = path::parent(path);
  for (const std::string& folder :
       companion_places(std::string(parent.empty() ? "." : parent), files, packages).folders) {
    for (const std::string& name : files.list(folder)) {
      const std::string file = path::join(folder, name);
      if (xacro::is_xacro_file(file)) {
        found.xacro.push_back(file);
      } else if (input_kind(file) == InputKind::urdf) {
        // A package.xml is no robot.
        const bool is_robot =
            !may_be_imported(file) || is_imported(files.read(file, kMostBytesOfText).text);
        if (is_robot) found.files.push_back(file);
      }
    }
  }
  std::sort(found.files.begin(), found.files.end());
  std::sort(found.xacro.begin(), found.xacro.end());
  return found;
}

}  // namespace

const CompanionRobots::Project& CompanionRobots::project_of(const std::string& path) {
  const bool is_wide = scope_ == Scope::project;
  const std::string project_folder = is_wide ? project_around(path) : std::string();
  const std::string folder =
      project_folder.empty() ? std::string(path::parent(path)) : project_folder;
  const auto [place, is_new] = projects_.try_emplace(folder);
  Project& project = place->second;
  if (!is_new) return project;
  FoundInputs found = project_folder.empty() ? inputs_beside(path, files_, packages_)
                                             : inputs_around(path, limits_);
  for (const std::string& file : found.files) {
    if (input_kind(file) == InputKind::urdf) project.robots.push_back(file);
  }
  project.xacro.emplace(found.xacro, files_, limits_);
  for (const std::string& root : project.xacro->roots()) {
    if (!is_companion_path(root)) project.robots.push_back(root);
  }
  return project;
}

const std::string& CompanionRobots::text_of(const Project& project, const std::string& robot) {
  const auto [place, is_new] = texts_.try_emplace(robot);
  std::string& text = place->second;
  if (!is_new) return text;
  std::vector<std::string> files{robot};
  if (xacro::is_xacro_file(robot)) files = project.xacro->included_by(robot);
  for (std::size_t i = 0; i < files.size() && text.size() < kMostBytesOfText; ++i) {
    const std::string one = files_.read(files[i], kMostBytesOfText).text;
    // A xacro may also include a URDF, which is no xacro file of the project.
    for (const TextRange included : read_xacro_text(one).includes) {
      const std::string_view name = path::file_name(included.of(one));
      if (!name.ends_with(".urdf") || name.find_first_of("${}") != name.npos) continue;
      const std::string beside = path::join(path::parent(files[i]), std::string(name));
      const bool is_new_file = std::find(files.begin(), files.end(), beside) == files.end();
      if (is_new_file && files_.is_file(beside)) files.push_back(beside);
    }
    text += one;
  }
  return text;
}

const std::string& CompanionRobots::text_of(const std::string& companion,
                                            const std::string& robot) {
  return text_of(project_of(companion), robot);
}

bool CompanionRobots::is_written(const std::string& companion, std::string_view name) {
  const Project& project = project_of(companion);
  return std::any_of(project.robots.begin(), project.robots.end(), [&](const auto& robot) {
    return xacro::find_name(text_of(project, robot), name) != std::string_view::npos;
  });
}

/// How many names of a file the texts of a robot have.
std::size_t CompanionRobots::count_in(const Project& project, const std::string& robot,
                                      const SeenCompanion& seen) {
  const std::string& text = text_of(project, robot);
  const auto count =
      std::count_if(seen.names.begin(), seen.names.end(), [&](const CompanionName& one) {
        return text.find(one.name) != std::string::npos;
      });
  return static_cast<std::size_t>(count);
}

std::map<std::string, std::size_t> CompanionRobots::ranks_around(const std::string& path) {
  const std::string_view folder = path::parent(path);
  const CompanionPlaces places =
      companion_places(std::string(folder.empty() ? "." : folder), files_, packages_);
  std::map<std::string, std::size_t> ranks;
  for (std::size_t i = 0; i < places.folders.size(); ++i) {
    ranks.emplace(files_.identity(places.folders[i]), i < places.own ? 0 : 1);
  }
  return ranks;
}

std::string CompanionRobots::near(const std::string& path) {
  const std::map<std::string, std::size_t> ranks = ranks_around(path);
  for (const std::string& robot : project_of(path).robots) {
    const std::string_view parent = path::parent(robot);
    if (ranks.contains(files_.identity(std::string(parent.empty() ? "." : parent)))) return robot;
  }
  return {};
}

std::vector<std::string> CompanionRobots::of(const std::string& path, const SeenCompanion& seen,
                                             std::span<const CompanionTie> ties) {
  std::vector<std::string> robots;
  const std::string id = files_.identity(path);
  for (const CompanionTie& tie : ties) {
    const bool is_here = std::any_of(tie.files.begin(), tie.files.end(),
                                     [&](const auto& file) { return files_.identity(file) == id; });
    if (is_here) robots.push_back(tie.robot);
  }
  if (!robots.empty()) return robots;
  const Project& project = project_of(path);
  const std::map<std::string, std::size_t> ranks = ranks_around(path);
  using Rank = std::tuple<std::size_t, std::size_t, std::string>;
  std::vector<Rank> all;
  for (const std::string& robot : project.robots) {
    const std::string_view parent = path::parent(robot);
    const auto rank = ranks.find(files_.identity(std::string(parent.empty() ? "." : parent)));
    all.emplace_back(rank == ranks.end() ? 2 : rank->second,
                     seen.names.size() - count_in(project, robot, seen), robot);
  }
  std::sort(all.begin(), all.end());
  for (const Rank& one : all) {
    // What is unrelated, and writes none of the names, is another robot.
    const bool is_alien = std::get<0>(one) == 2 && std::get<1>(one) * 2 > seen.names.size();
    if (!is_alien && robots.size() < kMostRobots) robots.push_back(std::get<2>(one));
  }
  return robots;
}

}  // namespace smurf
