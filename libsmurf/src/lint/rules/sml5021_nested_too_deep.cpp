// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5021_nested_too_deep_file {

extern constinit const Rule sml5021_nested_too_deep{
    .id = "SML5021",
    .name = "nested-too-deep",
    .severity = Severity::error,
    .summary = "Scenes are nested deeper than the limit.",
    .why = "Readers recurse once per level and a hostile file could exhaust their stack.",
    .remedy = "Include the inner scenes directly.",
    .sources = "Limit of these tools."};

}  // namespace smurf::rules::sml5021_nested_too_deep_file
