// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8002_not_requested_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "simulates with the annotation",
     "MARS smurf.cpp:902 (limits of the URDF are not used), MaterialData.cpp:47-118"},
};

}  // namespace

extern constinit const Rule sml8002_not_requested{
    .id = "SML8002",
    .name = "not-requested",
    .severity = Severity::info,
    .summary = "An annotation differs from the URDF, and the export keeps the value of the URDF.",
    .why = "Readers of the exported URDF have the other value: the same robot behaves differently.",
    .remedy = "Export with `--apply`, which uses the values of the annotations.",
    .facts = kFacts,
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8002_not_requested_file
