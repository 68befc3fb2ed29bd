// SPDX-License-Identifier: BSD-3-Clause
// Reads standard input and the other inputs that a user names.
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
#include "smurf/plan.hpp"

namespace smurf::tools {

/// Reads standard input into `files` under the name `filename`. If that is "" and the text is XML,
/// chooses a name. Returns the name; reports an error and returns none if this fails.
std::optional<std::string> read_standard_input(std::string_view tool, const std::string& filename,
                                               const Limits& limits, MemoryFiles& files);

/// The path to load for a path of the user: itself, or the main file of an archive. Reports an
/// error and returns none if it cannot be read.
std::optional<std::string> find_main_file(std::string_view tool, const std::string& path,
                                          const FileReader& files);

/// The only file of a kind in a folder, for the first of these kinds that occurs. Reports an error
/// and returns none if there are several files of that kind, or no file of any kind.
std::optional<std::string> find_only_input(std::string_view tool, const std::string& folder,
                                           std::span<const InputKind> kinds, const Limits& limits);

/// The current folder. Reports an error if it no longer exists.
std::optional<std::string> current_folder(std::string_view tool);

/// Wraps a reader and remembers the files that were read or found, and the file of standard input,
/// because no output may replace an input.
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
  /// True for any name of the file.
  bool contains(const std::string& path) const;
  /// The paths that were asked for, whether they exist or not: a missing mesh may be added.
  const std::set<std::string>& asked() const { return asked_; }

 private:
  void note(const std::string& path) const;

  using Identity = std::pair<std::uint64_t, std::uint64_t>;  ///< device and inode

  const FileReader& behind_;
  mutable std::mutex mutex_;
  mutable std::set<std::string> read_;  ///< whose identities are not known yet
  mutable std::set<Identity> known_;
  mutable std::set<std::string> asked_;
};

/// Reports an error and returns false if one of these files was read. "" and "-" are not files.
bool keeps_inputs(std::string_view tool, const InputFiles& inputs,
                  std::span<const std::string> outputs);

}  // namespace smurf::tools
