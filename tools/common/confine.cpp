// SPDX-License-Identifier: BSD-3-Clause
#include "common/confine.hpp"

#include <filesystem>
#include <optional>
#include <set>

#include "common/input.hpp"
#include "smurf/config.hpp"

namespace smurf::tools {
namespace {

namespace fs = std::filesystem;

bool has(const fs::path& folder, std::string_view name) {
  std::error_code ignored;
  return fs::exists(folder / name, ignored);
}

/// The repository or package around a folder; without one, the two folders above it, but never the
/// whole machine.
fs::path project_of(const fs::path& folder) {
  fs::path package;
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path()) {
    if (has(at, ".git") || has(at, ".hg") || has(at, ".svn")) return at;
    if (package.empty() && has(at, "package.xml")) package = at;
  }
  if (package.empty()) package = folder.parent_path();
  for (const fs::path& wide : {package.parent_path(), package}) {
    if (wide.has_relative_path()) return wide;
  }
  return folder;
}

/// Where an input is; none when that cannot be told.
std::optional<fs::path> folder_of(const std::string& input) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(input, error);
  if (error) return std::nullopt;
  return fs::is_directory(path, error) ? path : path.parent_path();
}

/// The project around a folder and, above it, the files that say what is checked and how.
void allow_project(ConfinedFiles& files, const fs::path& folder) {
  const fs::path project = project_of(folder);
  files.allow(project.string());
  for (fs::path at = project.parent_path(); at.has_relative_path(); at = at.parent_path()) {
    for (const std::string_view name :
         std::initializer_list<std::string_view>{".gitignore", ".smurf-lintignore", kConfigName}) {
      if (has(at, name)) files.allow((at / name).string());
    }
  }
}

}  // namespace

Option allow_outside_option(bool& allow_outside) {
  return {.group = "Input",
          .name = "allow-outside",
          .help =
              "Read files that models name wherever they lie. Without it: in the current folder, "
              "in the repository or package of the input, and in packages.",
          .set = set_flag(allow_outside)};
}

void confine(ConfinedFiles& files, std::span<const std::string> inputs,
             const std::map<std::string, std::string>& packages, bool allow_outside) {
  files.allow(allow_outside ? "/" : ".");
  if (allow_outside) return;
  std::set<fs::path> folders;
  for (const std::string& input : inputs) {
    if (input.empty() || input == "-") continue;
    if (auto folder = folder_of(input)) folders.insert(*std::move(folder));
  }
  for (const fs::path& folder : folders) allow_project(files, folder);
  for (const auto& [name, folder] : packages) files.allow(folder);
  for (const std::string& folder : package_folders_of_environment()) files.allow(folder);
}

}  // namespace smurf::tools
