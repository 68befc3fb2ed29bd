// SPDX-License-Identifier: BSD-3-Clause
// The words that settings consist of.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"

namespace smurf {

inline std::string listed(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + quoted(name);
  return list;
}

inline std::optional<Severity> to_severity(std::string_view word) {
  for (const Severity severity : {Severity::error, Severity::warning, Severity::info}) {
    if (to_string(severity) == word) return severity;
  }
  return std::nullopt;
}

}  // namespace smurf
