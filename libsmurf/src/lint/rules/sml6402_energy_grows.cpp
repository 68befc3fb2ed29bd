// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6402_energy_grows_file {

extern constinit const Rule sml6402_energy_grows{
    .id = "SML6402",
    .name = "energy-grows",
    .severity = Severity::error,
    .summary = "A robot that hangs freely gains energy.",
    .why =
        "No motor drives the robot, so the energy comes from numerical errors: the simulation diverges.",
    .remedy = "Look at the inertias of the link and at the limits of the joints above it.",
    .sources = "ODE 0.16.2, executed: sound robots gain at most 2e-5 m.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6402_energy_grows_file
