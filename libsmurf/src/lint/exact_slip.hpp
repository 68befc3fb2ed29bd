// SPDX-License-Identifier: BSD-3-Clause
// A possible tensor that is exactly that of the shapes after a known mistake is undone.
#pragma once

#include <optional>
#include <string>

#include "link/possible_inertia.hpp"
#include "smurf/linked.hpp"

namespace smurf {

class ModelAnswers;

struct ExactSlip {
  Tensor tensor{};      ///< as meant, in the frame of the inertial
  std::string message;  ///< after "the inertia of link `a` fits its shape "
  std::string help;
  double off = 0;  ///< how far the written tensor is from that of the shapes, as a part of it
};
/// None if the tensor fits as written, or after no mistake, or if the shapes are open or unknown.
std::optional<ExactSlip> exact_slip(const urdf::Link& link, ModelAnswers& answers);

}  // namespace smurf
