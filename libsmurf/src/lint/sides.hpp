// SPDX-License-Identifier: BSD-3-Clause
// Links and joints whose names differ only in a side or a number.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// The name of the other side: "right_arm" for "left_arm", "FR_hip" for "FL_hip". Empty
/// if the name has no word for the left, or several words for sides.
std::vector<std::string> right_names_of(std::string_view left);

/// Pairs of indices of a left and a right name.
std::vector<std::pair<std::size_t, std::size_t>>
pairs_of_sides(const std::vector<std::string_view>& names);

/// Groups of at least three names that are equal but for sides, places and numbers: the wheels of a
/// robot. In the order of the first of each.
std::vector<std::vector<std::size_t>> siblings_of(const std::vector<std::string_view>& names);

/// Whether one of the links, by index, is below another one. Such links are no sides and no
/// siblings: `link_l` and `link_r` of an arm are its lower part and a rotation.
bool has_chain(const LinkedModel& model, std::span<const std::size_t> links);

/// Whether two values of sides are equal but for rounding and a fraction. rad or m.
bool are_near(double a, double b, double tolerance);
/// Whether two joints have the same bounds, which must be set.
bool have_same_bounds(const urdf::Limit& a, const urdf::Limit& b, double tolerance);
/// Whether they have them with the opposite sign, which an axis in the opposite sense needs.
bool have_turned_bounds(const urdf::Limit& a, const urdf::Limit& b, double tolerance);

}  // namespace smurf
