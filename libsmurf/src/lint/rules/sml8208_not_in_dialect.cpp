// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8208_not_in_dialect_file {

extern constinit const Rule sml8208_not_in_dialect{
    .id = "SML8208",
    .name = "not-in-dialect",
    .severity = Severity::warning,
    .summary = "The reader of the chosen dialect does not load an entity.",
    .why = "The result contains only what that reader loads.",
    .remedy =
        "Use --dialect spec, or change the entity so that the reader loads it; --compare-dialects shows where each reader places it.",
    .sources = "smurfs-flatten; MARS SMURFLoader.cpp, MarsSceneLoader.cpp, Phobos multiple.py.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8208_not_in_dialect_file
