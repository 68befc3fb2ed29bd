// SPDX-License-Identifier: BSD-3-Clause
// Which links of a robot must not touch each other: pairs that its SRDF disables, and pairs that
// overlap at the start.
#pragma once

#include "smurf/conversion.hpp"

namespace smurf {

/// The contacts of a scene. Reports what is left out, and pairs that overlap at the start.
OwnContacts own_contacts(const SceneRequest& request, const LinkedScene& scene,
                         const FlatScene& flat, const FileReader& files, const Limits& limits,
                         DiagnosticSink& losses);

}  // namespace smurf
