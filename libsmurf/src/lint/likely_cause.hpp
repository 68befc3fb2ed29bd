// SPDX-License-Identifier: BSD-3-Clause
// Which number is wrong when an inertial and the shapes of its link disagree, and by which factor.
#pragma once

#include <string>

#include "lint/body.hpp"

namespace smurf {

enum class Culprit : std::uint8_t { unknown, mass, inertia, mass_and_inertia, shape };

struct Cause {
  Culprit culprit = Culprit::unknown;
  std::string question;  ///< "is it in kg mm2?"; empty if unknown
  double inertia = 1;    ///< the factor that corrects the inertia
};
/// The mistake that explains mass and inertia best; unknown if none does.
Cause likely_cause(const LinkedModel& model, const urdf::Link& link, const Body& body,
                   const Extent& extent);

}  // namespace smurf
