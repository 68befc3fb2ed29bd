// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/confine.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>

#include "base/canonical_paths.hpp"
#include "base/path.hpp"
#include "smurf/check.hpp"
#include "smurf/config.hpp"
#include "smurf/repository.hpp"

namespace smurf {
namespace {

namespace fs = std::filesystem;

bool has(const fs::path& folder, std::string_view name) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(folder / name, ignored));
}

/// `folder` or above it?
bool is_around(const fs::path& around, const fs::path& folder) {
  const auto [end, other] =
      std::mismatch(around.begin(), around.end(), folder.begin(), folder.end());
  return end == around.end();
}

bool is_home(const fs::path& folder) {
  const fs::path above = folder.parent_path();
  if (above == "/home" || above == "/Users" || folder == "/root") return true;
  static const fs::path home = [] {
    const char* variable = std::getenv("HOME");
    // What an empty path is, the libraries do not agree on.
    if (variable == nullptr || *variable == '\0') return fs::path();
    std::error_code error;
    const fs::path found = fs::weakly_canonical(variable, error);
    return error ? fs::path() : found;
  }();
  return home.has_relative_path() && is_around(folder, home);
}

/// As confine() says. What is above a shared folder is shared.
bool is_shared(const fs::path& folder) {
  if (!folder.has_relative_path() || is_home(folder)) return true;
  return !folder.parent_path().has_relative_path() && !is_repository(folder);
}

/// Where the project would end if no folder were shared.
fs::path widest_project_of(const fs::path& folder) {
  fs::path package;
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path()) {
    if (is_repository(at) && !is_home(at)) return at;
    if (package.empty() && has(at, "package.xml")) package = at;
  }
  return package.empty() ? folder.parent_path().parent_path() : package.parent_path();
}

/// None when the folder itself is shared.
std::optional<fs::path> project_of(const fs::path& folder) {
  const fs::path widest = widest_project_of(folder);
  std::optional<fs::path> project;
  for (fs::path at = folder; !is_shared(at); at = at.parent_path()) {
    project = at;
    if (at == widest) break;
  }
  return project;
}

/// Where an input is; none when that cannot be told. A link that leads out of its repository may
/// have come with a pull request: where it leads is no project of the user.
std::optional<fs::path> folder_of(const std::string& input) {
  std::error_code error;
  const std::string link = link_out_of_repository(input);
  if (!link.empty()) return fs::path(link).parent_path();
  const auto there = canonical_now(input);
  const fs::path path = there ? fs::path(*there) : fs::weakly_canonical(input, error);
  if (error) return std::nullopt;
  return fs::is_directory(path, error) ? path : path.parent_path();
}

constexpr std::array<std::string_view, 3> kRuleFiles = {".gitignore", ".smurf-lintignore",
                                                        kConfigName};

/// The one file in .git that says what is checked.
constexpr const char* kGitExclude = "info/exclude";

/// The project around a folder and, above it, the files that say what is checked and how.
void allow_project(ConfinedFiles& files, const fs::path& folder) {
  const auto project = project_of(folder);
  if (project) {
    files.allow(project->string());
  } else {
    files.allow_files_in(folder.string());
  }
  for (fs::path at = project ? project->parent_path() : folder; at.has_relative_path();
       at = at.parent_path()) {
    for (const std::string_view name : kRuleFiles) {
      if (has(at, name)) files.allow((at / name).string());
    }
  }
}

}  // namespace

void confine(ConfinedFiles& files, std::span<const std::string> inputs,
             const std::map<std::string, std::string>& packages, bool allow_outside) {
  if (allow_outside) return files.allow("/");
  for (const std::string_view name : kHistories) {
    files.deny_named(std::string(name), name == ".git" ? kGitExclude : "");
  }
  if (!is_shared_folder(".")) files.allow(".");
  std::set<fs::path> folders;
  std::set<std::string_view> seen;  // folders of files
  std::error_code ignored;
  for (const std::string& input : inputs) {
    if (input.empty() || input == "-") continue;
    const bool is_file = fs::is_regular_file(fs::symlink_status(input, ignored));
    if (is_file && !seen.insert(path::parent(input)).second) continue;
    if (is_shared_folder(input) && link_out_of_repository(input).empty()) {
      for (const std::string_view name : kRuleFiles) files.allow_named(std::string(name), input);
    } else if (auto folder = folder_of(input)) {
      folders.insert(*std::move(folder));
    }
  }
  for (const fs::path& folder : folders) allow_project(files, folder);
  for (const auto& [name, folder] : packages) files.allow(folder);
  for (const std::string& folder : ros_package_folders()) files.allow(folder);
}

bool is_shared_folder(const std::string& path) {
  std::error_code error;
  const auto folder = canonical_now(path);
  return folder && fs::is_directory(*folder, error) && is_shared(*folder);
}

}  // namespace smurf
