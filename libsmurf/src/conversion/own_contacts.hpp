// SPDX-License-Identifier: BSD-3-Clause
// Which links of a robot must not touch each other: pairs that its SRDF disables, and pairs that
// overlap at the start.
#pragma once

#include <map>

#include "conversion/robot_srdf.hpp"
#include "smurf/conversion.hpp"

namespace smurf {

using SrdfsOfRobots = std::map<const LinkedModel*, RobotSrdf>;

/// The contacts of the robots with an entry in `srdfs`. Reports what is left out, and pairs that
/// overlap at the start.
OwnContacts own_contacts(const SceneRequest& request, const LinkedScene& scene,
                         const FlatScene& flat, const SrdfsOfRobots& srdfs, DiagnosticSink& losses);

}  // namespace smurf
