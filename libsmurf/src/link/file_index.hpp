// SPDX-License-Identifier: BSD-3-Clause
// Asks the file system each question once.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "smurf/file_reader.hpp"

namespace smurf {

class FileIndex {
 public:
  explicit FileIndex(const FileReader& files) : files_(files) {}

  bool exists(const std::string& path);
  /// Names in a folder, sorted.
  const std::vector<std::string>& list(const std::string& folder);
  /// A file or folder whose path differs from `path` only in case.
  std::optional<std::string> in_other_case(const std::string& path, int most_folders = 32);
  const FileReader& files() const { return files_; }

 private:
  const FileReader& files_;
  std::map<std::string, bool> known_;
  std::map<std::string, std::vector<std::string>> lists_;
};

}  // namespace smurf
