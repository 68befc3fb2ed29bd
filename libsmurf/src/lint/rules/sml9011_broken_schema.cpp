// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml9011_broken_schema_file {

extern constinit const Rule sml9011_broken_schema{
    .id = "SML9011",
    .name = "broken-schema",
    .severity = Severity::error,
    .summary = "A schema of your own cannot be used.",
    .why =
        "It is not a JSON Schema (draft-07), or applying it could take forever. It is not used for checks.",
    .remedy = "Correct the schema at this place. References lead to "
              "`#/definitions/NAME` of the same file.",
    .sources = "JSON Schema draft-07; limits of these tools."};

}  // namespace smurf::rules::sml9011_broken_schema_file
