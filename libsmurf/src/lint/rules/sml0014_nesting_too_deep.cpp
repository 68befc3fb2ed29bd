// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml0014_nesting_too_deep{
    .id = "SML0014",
    .name = "nesting-too-deep",
    .severity = Severity::error,
    .summary = "Lists, mappings or elements are nested deeper than the limit.",
    .why =
        "yaml-cpp gives up at 250 to 500 levels, tinyxml2 at 99, and urdfdom overflows its stack "
        "at 50,000; no robot needs such a depth.",
    .remedy = "Flatten the file.",
    .sources = "yaml-cpp 0.7, tinyxml2 9.0 and urdfdom, executed."};

}  // namespace smurf::rules
