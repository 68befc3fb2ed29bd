// SPDX-License-Identifier: BSD-3-Clause
#include "lint/habit.hpp"

#include <utility>

namespace smurf {

void Habit::add(Span place, std::string message) {
  if (count_++ > 0) return;
  place_ = place;
  message_ = std::move(message);
}

Diagnostic* Habit::report(std::string_view others, Findings& findings) const {
  if (count_ == 0) return nullptr;
  Diagnostic& diagnostic = findings.report(place_, message_);
  if (count_ > 1) {
    if (count_ == 2) others.remove_suffix(1);  // "1 more such name"
    diagnostic.note(std::to_string(count_ - 1) + " more " + std::string(others) + " in this file");
  }
  return &diagnostic;
}

}  // namespace smurf
