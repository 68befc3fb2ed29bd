// SPDX-License-Identifier: BSD-3-Clause
// Compares the properties of two versions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diff/match.hpp"
#include "diff/properties.hpp"
#include "diff/renames.hpp"
#include "smurf/diff.hpp"

namespace smurf {

/// Compares the contents of files. Reads each file once.
class FileContents {
 public:
  explicit FileContents(const DiffOptions& options) : options_(options) {}
  bool are_same(const std::string& a, const std::string& b);
  /// The reason why two files are different.
  std::string_view difference(const std::string& a, const std::string& b);

 private:
  const std::string& digest(const std::string& path);

  const DiffOptions& options_;
  std::map<std::string, std::string> digests_;  ///< by path; "": unreadable
};

/// The differences of all things, in the order of the new version, followed by removed things.
std::vector<Difference> compare(const Things& before, const Things& after, const Matching& matching,
                                const Renames& renames, const DiffOptions& options,
                                FileContents& contents);

}  // namespace smurf
