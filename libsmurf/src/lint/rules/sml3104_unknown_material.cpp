// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3104_unknown_material_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_unknown(model, NameKind::material, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::ignores, "ignores the entry", "MARS smurf.cpp:333-352"},
    {&readers::phobos, Effect::ignores, "ignores the entry", "Phobos smurfrobot.py"},
};

}  // namespace

extern constinit const Rule sml3104_unknown_material{
    .id = "SML3104",
    .name = "unknown-material",
    .severity = Severity::error,
    .summary = "An annotation names a material that the URDF does not have.",
    .remedy = "Correct the name, or define the material in the URDF.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3104_unknown_material_file
