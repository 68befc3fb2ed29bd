// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml0012_complex_key_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception", "configmaps, run"},
    {&readers::mars2, Effect::crashes, "ends with an uncaught exception", "configmaps, run"},
    {&readers::envire, Effect::crashes, "ends with an uncaught exception", "configmaps, run"},
};

}  // namespace

extern constinit const Rule sml0012_complex_key{.id = "SML0012",
                                                .name = "complex-key",
                                                .severity = Severity::error,
                                                .summary = "A list or a mapping is used as a key.",
                                                .remedy = "Use a plain text key.",
                                                .facts = kFacts};

}  // namespace smurf::rules::sml0012_complex_key_file
