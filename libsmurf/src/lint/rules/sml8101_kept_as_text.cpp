// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8101_kept_as_text_file {

extern constinit const Rule sml8101_kept_as_text{
    .id = "SML8101",
    .name = "kept-as-text",
    .severity = Severity::info,
    .summary = "Something in a URDF or SRDF has no SMURF section.",
    .why = "urdf2smurf writes entries only where SMURF has a section for them. The rest is kept as "
           "text in the sections `urdf_extensions` and `srdf_extensions`, which SMURF simulators "
           "ignore.",
    .remedy = "Add an entry by hand where a simulator needs it.",
    .sources = "Sections and types that MARS reads: smurf.cpp:257-485, SensorManager.cpp:351.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8101_kept_as_text_file
