// SPDX-License-Identifier: BSD-3-Clause
#include "link/packages.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/text/words.hpp"

namespace smurf {

Packages::Packages(LoadContext& context, const LinkedModel& model, FileIndex& index)
    : context_(context),
      index_(index),
      urdf_path_(model.urdf_path),
      is_xacro_(model.language == Language::xacro) {
  const std::string_view urdf_folder = path::parent(urdf_path_);
  std::string folder = path::normalize(urdf_folder.empty() ? "." : urdf_folder);
  for (std::size_t level = 0; level <= kFoldersAbove; ++level) {
    folders_.push_back(folder);
    folder = path::join(folder, "..");
  }
}

std::string Packages::address_of(const std::string& path) {
  // PACKAGE/urdf/ROBOT/robot.urdf; a package.xml still farther above is that of something else.
  constexpr std::size_t kLevels = 4;
  for (std::size_t i = 0; i < kLevels; ++i) {
    const std::string& folder = folders_[i];
    const std::string& name = package_name(folder);
    if (name.empty()) continue;
    // What `$(find NAME)` stands for is absolute, whatever way the robot is named.
    const bool is_absolute = path::is_absolute(path) && !path::is_absolute(folder);
    const std::string rest =
        path::relative(path, is_absolute ? path::normalize(places::absolute(folder)) : folder);
    const bool is_inside = !rest.empty() && !rest.starts_with("..") && !path::is_absolute(rest);
    return is_inside ? "package://" + name + "/" + rest : "";
  }
  return {};
}

Packages::Place Packages::find(const std::string& name_and_rest) {
  Place place = search(name_and_rest);
  place.is_elsewhere = !place.path.empty() && lies_elsewhere(place, name_and_rest);
  return place;
}

bool Packages::lies_elsewhere(const Place& place, const std::string& name_and_rest) {
  if (place.is_given || place.is_guess) return false;
  const auto holds_it = [&](const std::string& folder) {
    return index_.exists(path::join(folder, name_and_rest));
  };
  if (std::any_of(folders_.begin(), folders_.end(), holds_it)) return false;
  // In memory, the outermost folder has no name.
  const std::string_view rest = std::string_view(name_and_rest).substr(name_and_rest.find('/') + 1);
  if (!place.path.ends_with(rest)) return false;  // `..` in it
  const std::string folder = path::join(place.path.substr(0, place.path.size() - rest.size()), ".");
  const std::string known = index_.files().identity(folder);
  return !is_one_of(path::file_name(known), {"", ".", ".."});
}

Packages::Place Packages::search(const std::string& name_and_rest) {
  const std::size_t slash = name_and_rest.find('/');
  if (slash == std::string::npos || slash == 0) return {};
  const std::string name = name_and_rest.substr(0, slash);
  const std::string rest = name_and_rest.substr(slash + 1);
  if (const auto given = context_.packages.find(name); given != context_.packages.end()) {
    return {path::join(given->second, rest), true};
  }
  std::optional<Place> guess;
  for (const std::string& folder : folders_) {
    const std::string inner = path::join(folder, name + "/" + rest);
    if (index_.exists(inner)) return {inner};
    std::string here = path::join(folder, rest);
    if (!index_.exists(here)) continue;
    if (is_called(folder, name) || package_name(folder) == name) return {std::move(here)};
    if (!guess) guess = {std::move(here), false, true, package_name(folder)};
  }
  for (const std::string& folder : folders_) {
    if (package_name(folder) == name) return {path::join(folder, rest)};
  }
  const std::string package = installed(name);
  if (!package.empty()) return {path::join(package, rest)};
  // Without a package or a repository around the file, the search would look through the disk.
  if (is_xacro_ || is_in_package()) {
    if (const auto found = find_package(name, urdf_path_, context_)) {
      return {path::join(*found, rest)};
    }
  }
  if (guess) {
    guessed_.emplace(name, guess->path.substr(0, guess->path.size() - rest.size()));
    return *guess;
  }
  // Another file of the package was found.
  const auto other = guessed_.find(name);
  if (other != guessed_.end()) return {path::join(other->second, rest)};
  // A package without package.xml: the folder of the file is there, and the file may be in it under
  // a similar name.
  const bool is_in_folder = rest.find('/') != std::string::npos;
  for (const std::string& folder : folders_) {
    if (!is_in_folder) break;
    std::string inner = path::join(folder, name + "/" + rest);
    if (!index_.list(std::string(path::parent(inner))).empty()) return {std::move(inner)};
  }
  return {};
}

bool Packages::is_called(const std::string& folder, const std::string& name) {
  const std::string_view written = path::file_name(folder);
  if (!written.empty() && written != "." && written != "..") return written == name;
  const FileReader& files = index_.files();  // "..", whose name is not written
  return files.identity(path::join(folder, "../" + name)) == files.identity(folder);
}

bool Packages::is_in_package() {
  return std::any_of(folders_.begin(), folders_.end(),
                     [&](const std::string& folder) { return !package_name(folder).empty(); });
}

std::string Packages::installed(const std::string& name) {
  if (!installed_) {
    installed_.emplace();
    for (const std::string& folder : context_.package_folders) {
      (*installed_)[std::string(path::file_name(folder))].push_back(folder);
      for (const std::string& inner : index_.list(folder)) {
        (*installed_)[inner].push_back(path::join(folder, inner));
      }
    }
  }
  const auto found = installed_->find(name);
  if (found == installed_->end()) return {};
  for (const std::string& package : found->second) {
    if (!index_.list(package).empty()) return package;
  }
  return {};
}

const std::string& Packages::package_name(const std::string& folder) {
  return search_of(context_).manifest(folder).name;
}

}  // namespace smurf
