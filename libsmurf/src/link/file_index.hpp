// SPDX-License-Identifier: BSD-3-Clause
// Asks the file system every question only once.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"

namespace smurf {

/// One key for all names that links give to a file in one folder. Names in other folders have other
/// keys, because the file names other files relative to its folder.
std::string key_of_file(const std::string& path, const FileReader& files);

/// The first name under which each file was requested. Links may give a file thousands of names,
/// and each would be read separately.
class FirstNames {
 public:
  explicit FirstNames(const FileReader& files) : files_(files) {}
  const std::string& of(const std::string& path);

 private:
  const FileReader& files_;
  std::map<std::string, std::string> known_;   ///< by path
  std::map<std::string, std::string> by_key_;  ///< by key_of_file()
};

class FileIndex {
 public:
  explicit FileIndex(const FileReader& files) : files_(files) {}

  bool exists(const std::string& path);
  /// Names in a folder, sorted.
  const std::vector<std::string>& list(const std::string& folder);
  /// A file or folder whose path differs from `path` only in case, and can be written unchanged.
  std::optional<std::string> in_other_case(const std::string& path, int most_folders = 32);
  const FileReader& files() const { return files_; }

 private:
  /// Whether many others were missing in the same folder, and its list does not contain this one.
  /// The system would walk the whole path for each, which may have thousands of folders.
  bool is_unlisted(std::string_view path);

  const FileReader& files_;
  std::map<std::string, bool> known_;
  std::map<std::string, std::vector<std::string>> lists_;
  std::map<std::string, int, std::less<>> misses_;  ///< missing files and folders, by folder
  using Names = std::map<std::string, std::string>;
  std::map<std::string, Names> lower_;  ///< the first name of a folder, by its name in lower case
};

}  // namespace smurf
