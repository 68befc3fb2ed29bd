// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0005_unsupported_encoding_file {

namespace {

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses the file",
     "urdfdom, sdformat, MuJoCo and Bullet, run"},
};

}  // namespace

extern constinit const Rule sml0005_unsupported_encoding{
    .id = "SML0005",
    .name = "unsupported-encoding",
    .severity = Severity::error,
    .summary = "A file is encoded in UTF-16 or UTF-32.",
    .remedy = "Save the file as UTF-8.",
    .facts = kFacts};

}  // namespace smurf::rules::sml0005_unsupported_encoding_file
