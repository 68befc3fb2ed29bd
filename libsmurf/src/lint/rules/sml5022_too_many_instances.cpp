// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5022_too_many_instances_file {

extern constinit const Rule sml5022_too_many_instances{
    .id = "SML5022",
    .name = "too-many-instances",
    .severity = Severity::error,
    .summary = "A scene expands to more entities, or to more text, than the limit.",
    .why = "Scenes that include others several times grow exponentially with their depth, and a "
           "large model is written out for each entity.",
    .remedy = "Split the scene, or raise the limit (docs/limits.md).",
    .sources = "Limit of these tools."};

}  // namespace smurf::rules::sml5022_too_many_instances_file
