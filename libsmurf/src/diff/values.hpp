// SPDX-License-Identifier: BSD-3-Clause
// Prints values and properties of differences.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "smurf/diff.hpp"

namespace smurf {

/// "upper limit" of "limit.upper".
std::string label_of(std::string_view property);

/// "0.35 kg"; "none" for an absent value.
std::string value_text(const DiffValue& value, std::string_view unit,
                       std::span<const std::string_view> parts);

/// The old and the new value as two different texts.
struct ValueTexts {
  std::string before, after;
};
ValueTexts value_texts(const Difference& difference);

/// "+14.3 %" for a changed number; otherwise empty.
std::string percentage_of(const Difference& difference);

/// "0.35 -> 0.4 kg (+14.3 %)"; of several numbers with names, only the changed ones.
std::string change_text(const Difference& difference);

}  // namespace smurf
