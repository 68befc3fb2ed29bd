// SPDX-License-Identifier: BSD-3-Clause
// Inertias whose moments belong to other axes.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "smurf/linked.hpp"

namespace smurf {

class ModelAnswers;

/// An order of x, y and z other than the written one.
struct AxisOrder {
  std::array<std::size_t, 3> axes;
  std::string_view words;  ///< "x and y are swapped"
};
/// The order in which the moments of a link fit its shapes, if they do not fit as they are. Null if
/// there is none, or if the shapes are open or unknown.
const AxisOrder* likely_axis_order(const LinkedModel& model, const urdf::Link& link,
                                   ModelAnswers& answers);

}  // namespace smurf
