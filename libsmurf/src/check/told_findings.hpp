// SPDX-License-Identifier: BSD-3-Clause
// Findings in files that several robots have around them, such as launch files.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "smurf/diagnostic.hpp"

namespace smurf {

class ToldFindings {
 public:
  /// Removes the findings in these files, by identity, that another robot had, too.
  template <class FileOf>
  void leave_new(const std::set<std::string>& files, const FileOf& file_of,
                 std::vector<Diagnostic>& found) {
    if (files.empty()) return;
    std::erase_if(found, [&](const Diagnostic& one) {
      const std::string file = file_of(one);
      return files.contains(file) &&
             !told_.emplace(file, one.rule, one.span.begin, one.message).second;
    });
  }

 private:
  std::set<std::tuple<std::string, const Rule*, std::uint32_t, std::string>> told_;
};

}  // namespace smurf
