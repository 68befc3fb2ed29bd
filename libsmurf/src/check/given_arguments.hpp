// SPDX-License-Identifier: BSD-3-Clause
// Arguments of xacro that a user gives, and that no file has.
#pragma once

#include <map>
#include <set>
#include <string>

#include "base/files/canonical_paths.hpp"
#include "check/group.hpp"
#include "check/pipeline.hpp"

namespace smurf {

/// The arguments that the files of a robot declare or use.
std::set<std::string> arguments_of(const SourceMap& sources, std::size_t first_source);

class GivenArguments {
 public:
  explicit GivenArguments(const CheckContext& context) : context_(context) {}

  /// Takes the arguments of a robot at this path. `is_expanded`: it has no others.
  void take(const std::string& path, std::size_t config, const std::set<std::string>& arguments,
            bool is_expanded);
  /// Reports each argument, of the settings or of a configuration, that no robot declares. A robot
  /// that could not be expanded may declare more of them than are known; then only an argument
  /// with a similar name is reported.
  void report(const std::map<std::string, std::string>& given, const CheckGroups& groups,
              SourceMap& sources, std::vector<Judged>& found) const;

 private:
  struct Robot {
    std::string path;
    std::size_t config = 0;
    std::set<std::string> arguments;
    bool is_expanded = true;
  };
  const CheckContext& context_;
  std::map<std::string, Robot> robots_;  ///< by identity
};

}  // namespace smurf
