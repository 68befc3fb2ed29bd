// SPDX-License-Identifier: BSD-3-Clause
// The expected report of a rule's bad case. It lies in the repository, where tests write it; the
// cases themselves are read where scripts/fixtures lays them out.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace smurf::test {

/// The path of `bad.expected.txt` for the folder of a rule ("SML3101-unknown-joint"), wherever it
/// lies below fixtures/rules; empty if there is none.
inline std::filesystem::path expected_report(const std::string& name) {
  namespace fs = std::filesystem;
  static const std::map<std::string, fs::path> folders = [] {
    std::map<std::string, fs::path> found;
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(SMURF_ROOT "/fixtures/rules")) {
      const std::string folder = entry.path().filename().string();
      if (entry.is_directory() && folder.starts_with("SML")) found.emplace(folder, entry.path());
    }
    return found;
  }();
  const auto folder = folders.find(name);
  return folder == folders.end() ? fs::path{} : folder->second / "bad.expected.txt";
}

}  // namespace smurf::test
