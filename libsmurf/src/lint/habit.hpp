// SPDX-License-Identifier: BSD-3-Clause
// One finding for a fault that an author or exporter repeats throughout a file.
#pragma once

#include <string>
#include <string_view>

#include "smurf/lint.hpp"

namespace smurf {

/// Collects places with the same defect, to report one finding at the first place.
class Habit {
 public:
  /// The message of the first place is shown.
  void add(Span place, std::string message);
  bool is_first() const { return count_ == 0; }
  /// Reports the finding with the number of other places: "3 more `others` in this file". Null if
  /// there are no places.
  Diagnostic* report(std::string_view others, Findings& findings) const;

 private:
  Span place_;
  std::string message_;
  std::size_t count_ = 0;
};

}  // namespace smurf
