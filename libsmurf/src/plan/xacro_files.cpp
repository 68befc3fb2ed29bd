// SPDX-License-Identifier: BSD-3-Clause
#include "plan/xacro_files.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "plan/paths.hpp"
#include "plan/project_inputs.hpp"
#include "plan/xacro_text.hpp"
#include "smurf/confine.hpp"

namespace smurf {
namespace {

/// The parts of a path without its expressions: "$(find a)/urdf/${x}.xacro" is "", "/urdf/",
/// ".xacro".
std::vector<std::string> literal_parts(std::string_view written) {
  std::vector<std::string> parts(1);
  while (!written.empty()) {
    const bool is_expression = written.starts_with("${") || written.starts_with("$(");
    if (!is_expression) {
      parts.back().push_back(written[0]);
      written.remove_prefix(1);
      continue;
    }
    const std::size_t end = written.find(written[1] == '{' ? '}' : ')');
    written.remove_prefix(end == std::string_view::npos ? written.size() : end + 1);
    parts.emplace_back();
  }
  return parts;
}

/// Whether an include in a file may mean the other file.
bool may_mean(const std::string& written, const std::string& from, const std::string& file) {
  const std::vector<std::string> parts = literal_parts(written);
  if (parts.size() == 1) {
    return path::join(path::parent(from), written) == path::normalize(file);
  }
  // `${file}` may mean any file, and often none: with its default it is empty.
  const auto is_empty = [](const std::string& part) { return part.empty(); };
  if (std::all_of(parts.begin(), parts.end(), is_empty)) return false;
  // The folder of a package may be the current one, whose name is not in the path.
  const std::string other = path::is_absolute(file) ? file : "/" + file;
  if (!other.ends_with(parts.back())) return false;
  // The last parts must follow each other in the name of the file.
  std::string_view rest = std::string_view(other).substr(0, other.size() - parts.back().size());
  for (std::size_t i = parts.size() - 1; i > 0; --i) {
    const std::string& part = parts[i - 1];
    // Every path has a slash, so that a name must be with it: `$(arg arm)/$(arg arm).xacro`.
    const bool has_folder = (part.find('/') != std::string::npos && part != "/") || i == 1;
    const std::size_t found = rest.rfind(part);
    if (found == std::string_view::npos) return i == 1;
    rest = rest.substr(0, found);
    if (has_folder) return true;
  }
  return true;
}

/// The text behind the last `/` outside of expressions; "" if it has expressions.
std::string_view literal_name(std::string_view written) {
  const std::string_view name = written.substr(written.find_last_of("/)}") + 1);
  const bool is_whole =
      name.size() == written.size() || written[written.size() - name.size() - 1] == '/';
  return is_whole && name.find_first_of("${*?[") == std::string_view::npos ? name
                                                                           : std::string_view();
}

}  // namespace

XacroFiles::XacroFiles(std::vector<std::string> files, const FileReader& reader,
                       const Limits& limits)
    : files_(std::move(files)), includes_(files_.size()), users_(files_.size()) {
  std::map<std::string_view, std::vector<std::size_t>> by_name;
  std::vector<std::size_t> all(files_.size());
  for (std::size_t i = 0; i < files_.size(); ++i) {
    all[i] = i;
    by_name[path::file_name(files_[i])].push_back(i);
  }
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const FileContent content = reader.read(files_[i], limits.file_bytes);
    for (const TextRange place : read_xacro_text(content.text).includes) {
      const std::string written(place.of(content.text));
      const std::string_view name = literal_name(written);
      const auto named = by_name.find(name);
      if (!name.empty() && named == by_name.end()) continue;
      for (const std::size_t other : name.empty() ? all : named->second) {
        if (other == i || !may_mean(written, files_[i], files_[other])) continue;
        includes_[i].push_back(other);
        users_[other].push_back(i);
      }
    }
  }
}

std::vector<std::string> XacroFiles::roots() const {
  std::vector<std::string> roots;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (users_[i].empty()) roots.push_back(files_[i]);
  }
  return roots;
}

std::set<std::size_t> XacroFiles::closure(std::set<std::size_t> from, const Edges& edges) {
  std::vector<std::size_t> open(from.begin(), from.end());
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (const std::size_t next : edges[at]) {
      if (from.insert(next).second) open.push_back(next);
    }
  }
  return from;
}

std::optional<std::size_t> XacroFiles::index_of(const std::string& path) const {
  const std::string wanted = identity(path);
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const bool has_name = path::file_name(files_[i]) == path::file_name(path);
    if (has_name && identity(files_[i]) == wanted) return i;
  }
  return std::nullopt;
}

std::vector<std::string> XacroFiles::roots_of(const std::string& path) const {
  std::vector<std::string> roots;
  const auto own = index_of(path);
  if (!own) return roots;
  for (const std::size_t one : closure({*own}, users_)) {
    if (one != *own && users_[one].empty()) roots.push_back(files_[one]);
  }
  return roots;
}

std::vector<std::string> XacroFiles::family_of(const std::string& path) const {
  const auto own = index_of(path);
  if (!own) return {path};
  std::vector<std::string> family;
  for (const std::size_t one : closure(closure({*own}, users_), includes_)) {
    family.push_back(files_[one]);
  }
  return family;
}

std::vector<std::string> XacroFiles::included_by(const std::string& path) const {
  const auto own = index_of(path);
  if (!own) return {path};
  std::vector<std::string> found;
  for (const std::size_t one : closure({*own}, includes_)) found.push_back(files_[one]);
  return found;
}

std::vector<std::string> XacroFiles::meant_by(const std::string& written,
                                              const std::string& from) const {
  std::vector<std::string> meant;
  for (const std::string& file : files_) {
    if (file != from && may_mean(written, from, file)) meant.push_back(file);
  }
  return meant;
}

XacroFiles xacro_files_around(const std::string& path, const FileReader& reader,
                              const Limits& limits, const LeftOut& is_left_out) {
  if (project_around(path).empty()) return {{path}, reader, limits};
  return {inputs_around(path, limits, is_left_out).xacro, reader, limits};
}

}  // namespace smurf
