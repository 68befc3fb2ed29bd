// SPDX-License-Identifier: BSD-3-Clause
#include "common/confine.hpp"

#include <filesystem>

#include "common/input.hpp"
#include "smurf/config.hpp"

namespace smurf::tools {
namespace {

namespace fs = std::filesystem;

bool has(const fs::path& folder, std::string_view name) {
  std::error_code ignored;
  return fs::exists(folder / name, ignored);
}

fs::path project_of(const fs::path& folder) {
  fs::path package;
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path()) {
    if (has(at, ".git") || has(at, ".hg") || has(at, ".svn")) return at;
    if (package.empty() && has(at, "package.xml")) package = at;
  }
  return package.empty() ? folder.parent_path().parent_path() : package.parent_path();
}

void allow_project(ConfinedFiles& files, const std::string& input) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(input, error);
  if (error) return;
  const fs::path folder = fs::is_directory(path, error) ? path : path.parent_path();
  files.allow(project_of(folder).string());
  if (folder == path) files.allow(path.string());
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path()) {
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
  for (const std::string& input : inputs) {
    if (!input.empty() && input != "-") allow_project(files, input);
  }
  for (const auto& [name, folder] : packages) files.allow(folder);
  for (const std::string& folder : package_folders_of_environment()) files.allow(folder);
}

}  // namespace smurf::tools
