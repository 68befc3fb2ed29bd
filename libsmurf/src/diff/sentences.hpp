// SPDX-License-Identifier: BSD-3-Clause
// The words of differences in reports for people: shortened, with control characters made visible.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "smurf/diff.hpp"

namespace smurf {

std::string shown_name(std::string_view name);
std::string shown_value(std::string_view value);

/// "visual 2 of link hand"; for renamed things, with the old name.
std::string subject_of(const Difference& difference);

/// "upper limit": the changed property.
std::string label_in(const Difference& difference);

/// "arm.urdf:12"; empty if there is no such place.
std::string place_text(const std::optional<Span>& place, const SourceMap& sources);

}  // namespace smurf
