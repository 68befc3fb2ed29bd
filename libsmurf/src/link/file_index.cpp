// SPDX-License-Identifier: BSD-3-Clause
#include "link/file_index.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "base/text/utf8.hpp"

namespace smurf {

std::string key_of_file(const std::string& path, const FileReader& files) {
  // No path has a zero byte.
  return files.identity(std::string(path::parent(path))) + '\0' + files.identity(path);
}

const std::string& FirstNames::of(const std::string& path) {
  const auto [known, is_new] = known_.try_emplace(path);
  if (is_new) known->second = by_key_.try_emplace(key_of_file(path, files_), path).first->second;
  return known->second;
}

bool FileIndex::exists(const std::string& path) {
  const auto [place, is_new] = known_.try_emplace(path);
  if (!is_new) return place->second;
  const std::string_view folder = path::parent(path);
  if (is_unlisted(folder) || is_unlisted(path)) return false;
  place->second = files_.is_file(path);
  if (!place->second) ++misses_[std::string(folder)];
  return place->second;
}

const std::vector<std::string>& FileIndex::list(const std::string& folder) {
  const auto [place, is_new] = lists_.try_emplace(folder);
  if (!is_new || is_unlisted(folder)) return place->second;
  place->second = files_.list(folder);
  if (place->second.empty()) ++misses_[std::string(path::parent(folder))];
  return place->second;
}

/// Hidden names may exist without being listed.
bool FileIndex::is_unlisted(std::string_view path) {
  constexpr int kFewMisses = 20;
  const std::string_view name = path::file_name(path);
  if (name.empty() || name.starts_with('.')) return false;
  const auto misses = misses_.find(path::parent(path));
  if (misses == misses_.end() || misses->second < kFewMisses) return false;
  const std::vector<std::string>& names = list(misses->first);
  return !std::binary_search(names.begin(), names.end(), name);
}

std::optional<std::string> FileIndex::in_other_case(const std::string& path, int most_folders) {
  if (path.size() > path::kLongest) return std::nullopt;
  std::string folder(path::parent(path));
  if (list(folder).empty()) {
    if (folder.empty() || folder == "/" || most_folders == 0) return std::nullopt;
    const auto other = in_other_case(folder, most_folders - 1);
    if (!other) return std::nullopt;
    folder = *other;
  }
  const auto [names, is_new] = lower_.try_emplace(folder);
  if (is_new) {
    for (const std::string& name : list(folder)) {
      if (utf8::is_printable(name)) names->second.try_emplace(path::to_lower(name), name);
    }
  }
  const auto found = names->second.find(path::to_lower(path::file_name(path)));
  if (found == names->second.end()) return std::nullopt;
  return path::join(folder, found->second);
}

}  // namespace smurf
