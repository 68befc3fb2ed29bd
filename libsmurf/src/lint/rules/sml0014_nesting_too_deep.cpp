// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0014_nesting_too_deep_file {

extern constinit const Rule sml0014_nesting_too_deep{
    .id = "SML0014",
    .name = "nesting-too-deep",
    .severity = Severity::error,
    .summary = "Lists, mappings or elements are nested deeper than the limit.",
    .why =
        "Each parser gives up at another depth, and some overflow their stack; no robot needs such "
        "a depth.",
    .remedy = "Flatten the file.",
    .sources =
        "yaml-cpp 0.7 (250 to 500 levels), tinyxml2 9.0 (99) and urdfdom (overflows at 50,000), "
        "executed."};

}  // namespace smurf::rules::sml0014_nesting_too_deep_file
