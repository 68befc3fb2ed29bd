// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8004_vendor_extension_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "misses what its extensions add", "sdformat parser_urdf.cc"},
};

}  // namespace

extern constinit const Rule sml8004_vendor_extension{
    .id = "SML8004",
    .name = "vendor-extension",
    .severity = Severity::info,
    .summary = "An extension of the URDF is left out of the export.",
    .why = "Programs that read the extension do not find it.",
    .remedy = "Export with `--vendor keep`.",
    .facts = kFacts,
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8004_vendor_extension_file
