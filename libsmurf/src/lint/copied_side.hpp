// SPDX-License-Identifier: BSD-3-Clause
// Inertials that were copied from one side of a robot to the other, and not mirrored.
#pragma once

#include <cstddef>
#include <optional>

#include "lint/model_answers.hpp"
#include "smurf/urdf.hpp"

namespace smurf {

struct CopiedSide {
  std::size_t axis = 0;    ///< of the links, along which their shapes are mirrored
  bool is_center = false;  ///< the centre of mass is the same; otherwise, the signs of products are
};

/// Two links with readable masses: whether their shapes are mirrored, while the centre of mass or
/// the products of one side are those of the other one, with the same signs.
std::optional<CopiedSide> copied_side(const urdf::Link& left, const urdf::Link& right,
                                      ModelAnswers& answers);

}  // namespace smurf
