// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml8208_not_in_dialect{
    .id = "SML8208",
    .name = "not-in-dialect",
    .severity = Severity::warning,
    .summary = "The reader whose dialect was asked for does not load an entity.",
    .why = "The result holds what that reader shows, and it does not show this.",
    .remedy = "Use --dialect spec, or change the entity so that the reader takes it; "
              "--compare-dialects shows what the readers make of it.",
    .sources = "smurfs-flatten; MARS SMURFLoader.cpp, MarsSceneLoader.cpp, Phobos multiple.py.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules
