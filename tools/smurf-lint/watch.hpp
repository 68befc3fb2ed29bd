// SPDX-License-Identifier: BSD-3-Clause
// Checks again whenever a file has changed.
#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "common/command.hpp"
#include "smurf-lint/options.hpp"
#include "smurf/file_reader.hpp"

namespace smurf::tools {

/// Wraps a reader and remembers the paths that were asked for, whether they exist or not: a mesh
/// that is missing may be added.
class SeenFiles final : public FileReader {
 public:
  explicit SeenFiles(const FileReader& behind) : behind_(behind) {}

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override {
    return behind_.list(folder);
  }
  bool is_denied(const std::string& path) const override { return behind_.is_denied(path); }
  std::string identity(const std::string& path) const override { return behind_.identity(path); }

  const std::set<std::string>& paths() const { return paths_; }

 private:
  void add(const std::string& path) const;

  const FileReader& behind_;
  mutable std::mutex mutex_;
  mutable std::set<std::string> paths_;
};

/// Checks once, and adds the paths that were asked for.
using WatchedCheck = std::function<ExitCode(std::set<std::string>& seen)>;

/// Checks at once, and again after each change of a seen file and when a named folder contains
/// other robots, until Ctrl-C; then returns kDone.
ExitCode watch(const LintOptions& options, const WatchedCheck& check);

}  // namespace smurf::tools
