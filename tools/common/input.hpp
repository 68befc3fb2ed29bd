// SPDX-License-Identifier: BSD-3-Clause
// Standard input and the other inputs that a user names.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"

namespace smurf::tools {

/// Reads standard input into `files` under the name `filename`, or under one made up when that is
/// "" and the text is XML. Returns the name; complains and returns none when it cannot.
std::optional<std::string> read_standard_input(std::string_view tool, const std::string& filename,
                                               const Limits& limits, MemoryFiles& files);

/// Why the user's path cannot be checked: "No such file or directory", "is not a regular file".
/// None when it can be read.
std::optional<std::string> why_unreadable(const std::string& path, const FileReader& files);

/// What is loaded for the user's path: itself, or what an archive holds. Complains and returns none
/// when it cannot be read.
std::optional<std::string> find_main_file(std::string_view tool, const std::string& path,
                                          const FileReader& files);

/// Where the run was started. Complains when that folder is gone.
std::optional<std::string> current_folder(std::string_view tool);

/// In front of a reader: remembers the files of the machine that were read or found, and what
/// standard input is, since no output may take the place of an input.
class InputFiles final : public FileReader {
 public:
  explicit InputFiles(const FileReader& behind);

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override {
    return behind_.list(folder);
  }
  bool is_denied(const std::string& path) const override { return behind_.is_denied(path); }
  std::string identity(const std::string& path) const override { return behind_.identity(path); }

  void add(const std::string& path) const;
  /// By whatever name.
  bool contains(const std::string& path) const;

 private:
  using Identity = std::pair<std::uint64_t, std::uint64_t>;  ///< device and inode

  const FileReader& behind_;
  mutable std::mutex mutex_;
  mutable std::set<Identity> known_;
};

/// Complains when one of the files to write ("" and "-": none) was read.
bool keeps_inputs(std::string_view tool, const InputFiles& inputs,
                  std::span<const std::string> outputs);

/// Shared by the whole run, so that each path is looked up once.
const CanonicalPaths& canonical_paths();
/// Equal for two spellings of one file; links are resolved.
std::string identity(const std::string& path);
/// The same, but what is denied has the identity of its name.
std::string identity(const std::string& path, const FileReader& files);

}  // namespace smurf::tools
