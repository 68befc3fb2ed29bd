// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/confine.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <set>

#include "base/files/canonical_paths.hpp"
#include "base/files/open_folder.hpp"
#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "base/ranges.hpp"
#include "plan/repository.hpp"
#include "smurf/config.hpp"
#include "smurf/plan.hpp"

namespace smurf {
namespace {

/// Canonical folders.
bool is_around(std::string_view around, std::string_view folder) {
  return folder.starts_with(around) &&
         (around.ends_with('/') || folder.size() == around.size() || folder[around.size()] == '/');
}

/// The user's own home folder, canonical; "" if it is not known.
const std::string& own_home() {
  static const std::string home = [] {
    const char* variable = sys::home();
    // The standard libraries disagree about empty paths.
    if (variable == nullptr || *variable == '\0') return std::string();
    std::string place = places::weakly_canonical(variable).value_or("");
    return place.size() > 1 && place.starts_with('/') ? place : std::string();
  }();
  return home;
}

/// Also true for the folders above the user's own home.
bool is_home(std::string_view folder) {
  const std::string_view below = sys::without_drive(folder);
  const std::string_view above = path::parent(below);
  if (above == "/home" || above == "/Users" || below == "/root") return true;
  return !own_home().empty() && is_around(folder, own_home());
}

/// Whether the homes of several users may lie in it.
bool is_around_homes(std::string_view folder) {
  const std::string_view below = sys::without_drive(folder);
  if (below.size() <= 1 || below == "/home" || below == "/Users") return true;
  return folder != own_home() && !own_home().empty() && is_around(folder, own_home());
}

/// Whether confine() treats a folder as shared, such as a home folder.
bool is_shared(std::string_view folder) {
  const std::string_view below = sys::without_drive(folder);
  if (below.size() <= 1 || is_home(folder)) return true;
  return path::parent(below) == "/" && !OpenFolder(std::string(folder)).has_any(kHistories);
}

/// The root of the project, or a folder above it. Walks upward folder by folder, because paths may
/// be long, to the nearest shared folder: a package.xml there would make everything its package.
/// A configuration names files beside itself and below, so that a new one makes nothing readable.
std::string_view widest_project_of(std::string_view folder, bool is_of_config) {
  std::string_view package;
  OpenFolder open{std::string(folder)};
  for (std::string_view at = folder; !is_shared(at);) {
    if (open.has_any(kHistories)) return at;
    if (package.empty() && open.has("package.xml")) package = at;
    at = path::parent(at);
    open.enter_above(std::string(at));
  }
  if (!package.empty()) return path::parent(package);
  return is_of_config ? folder : path::parent(path::parent(folder));
}

/// "" when the folder itself is shared.
std::string_view project_of(std::string_view folder, bool is_of_config = false) {
  const std::string_view widest = widest_project_of(folder, is_of_config);
  std::string_view project;
  for (std::string_view at = folder; !is_shared(at); at = path::parent(at)) {
    project = at;
    if (at == widest) break;
  }
  return project;
}

/// The folder of an input; none if it is unknown. A link that leads out of its repository may have
/// come with a pull request, so its target is not treated as a project of the user.
std::optional<std::string> folder_of(const std::string& input) {
  const std::string link = link_out_of_repository(input);
  if (!link.empty()) return std::string(path::parent(link));
  const auto there = canonical_now(input);
  const auto place = there ? there : places::weakly_canonical(input);
  if (!place) return std::nullopt;
  return places::is_folder(*place) ? *place : std::string(path::parent(*place));
}

constexpr std::array<std::string_view, 3> kRuleFiles = {".gitignore", ".smurf-lintignore",
                                                        kConfigName};

/// The only file in .git that affects the checked files.
constexpr const char* kGitExclude = "info/exclude";

/// What a model in a shared folder may name: what lies there and below, except hidden files. Where
/// other users have their homes, only the files beside it.
void allow_shared(ConfinedFiles& files, const std::string& folder) {
  const bool is_deep = !is_around_homes(folder);
  if (is_deep) files.allow_files_in(folder);
  const auto allow = [&](const std::string& name, places::Entry kind) {
    const bool is_own = name.starts_with(".smurf-lint");  // configurations and baselines
    if (kind == places::Entry::file && (is_own || (!is_deep && !name.starts_with('.')))) {
      files.allow(path::join(folder, name));
    }
    return true;
  };
  places::for_each_entry(folder, allow);
}

/// The project around a folder and, above it, the files that configure the check.
void allow_project(ConfinedFiles& files, const std::string& folder, bool is_of_config) {
  const std::string project(project_of(folder, is_of_config));
  if (!project.empty()) {
    files.allow(project);
  } else {
    allow_shared(files, folder);
  }
  std::string at = project.empty() ? folder : std::string(path::parent(project));
  OpenFolder open(at);
  while (at.size() > 1) {
    for (const std::string_view name : kRuleFiles) {
      if (open.has(name)) files.allow(path::join(at, name));
    }
    at = path::parent(at);
    open.enter_above(at);
  }
}

}  // namespace

std::string project_around(const std::string& input) {
  const auto folder = folder_of(input);
  return folder ? std::string(project_of(*folder)) : std::string();
}

void confine(ConfinedFiles& files, std::span<const std::string> inputs,
             const std::map<std::string, std::string>& packages, bool allow_outside) {
  if (allow_outside) return files.allow("/");
  if (!is_shared_folder(".")) files.allow(".");
  confine_to_projects(files, inputs);
  for (const auto& [name, folder] : packages) files.allow(folder);
  for (const std::string& folder : ros_package_folders()) files.allow(folder);
}

void confine_to_projects(ConfinedFiles& files, std::span<const std::string> inputs) {
  for (const std::string_view name : kHistories) {
    files.deny_named(std::string(name), name == ".git" ? kGitExclude : "");
  }
  std::map<std::string, bool> folders;  // whether they are only those of configurations
  std::set<std::string_view> seen;      // folders of files
  for (const std::string& input : inputs) {
    if (input.empty() || input == "-") continue;
    const bool is_file = places::is_plain_file(input);
    const bool is_config = is_file && path::file_name(input) == kConfigName;
    if (is_file && !is_config && !seen.insert(path::parent(input)).second) continue;
    if (is_shared_folder(input) && link_out_of_repository(input).empty()) {
      for (const std::string_view name : kRuleFiles) files.allow_named(std::string(name), input);
    } else if (auto folder = folder_of(input)) {
      const auto [known, is_new] = folders.try_emplace(*std::move(folder), is_config);
      known->second = known->second && is_config;
      // In "/" and /home only files that are there are allowed, and a misspelt name is not there.
      const bool is_missing = !is_file && !places::has_entry(input);
      if (is_missing && link_out_of_repository(input).empty()) files.allow(input);
    }
  }
  for (const auto& [folder, is_of_config] : folders) allow_project(files, folder, is_of_config);
}

bool is_shared_folder(const std::string& path) {
  const auto folder = places::is_folder(path) ? canonical_now(path) : std::nullopt;
  return folder && is_shared(*folder);
}

}  // namespace smurf
