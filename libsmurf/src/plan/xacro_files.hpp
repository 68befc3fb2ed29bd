// SPDX-License-Identifier: BSD-3-Clause
// Which xacro files may be robots, and which are parts of others.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/found_inputs.hpp"
#include "smurf/limits.hpp"

namespace smurf {

/// Xacro files and their includes. Nothing is expanded: an include whose path has an expression
/// counts as an include of every file that the rest of the path matches, and of none without a
/// rest.
class XacroFiles {
 public:
  XacroFiles(std::vector<std::string> files, const FileReader& reader, const Limits& limits);

  const std::vector<std::string>& files() const { return files_; }
  /// The files that no other of them includes, in the same order.
  std::vector<std::string> roots() const;
  /// The roots that include a file, directly or through others; none for a root.
  std::vector<std::string> roots_of(const std::string& path) const;
  /// The file, those that include it, and all files that these include.
  std::vector<std::string> family_of(const std::string& path) const;
  /// The file and all files that it includes, directly or through others.
  std::vector<std::string> included_by(const std::string& path) const;
  /// The files that an include in the file `from` may mean.
  std::vector<std::string> meant_by(const std::string& written, const std::string& from) const;

 private:
  using Edges = std::vector<std::vector<std::size_t>>;
  static std::set<std::size_t> closure(std::set<std::size_t> from, const Edges& edges);
  std::optional<std::size_t> index_of(const std::string& path) const;

  std::vector<std::string> files_;
  Edges includes_, users_;
};

/// The xacro files in the project around a file.
XacroFiles xacro_files_around(const std::string& path, const FileReader& reader,
                              const Limits& limits, const LeftOut& is_left_out = nullptr);

}  // namespace smurf
