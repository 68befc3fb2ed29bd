// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml4005_misspelt_key{
    .id = "SML4005",
    .name = "misspelt-key",
    .severity = Severity::warning,
    .summary = "A key unknown to all readers resembles a known one.",
    .why = "Every reader looks keys up by their exact names: a misspelt one has no effect.",
    .remedy = "Correct the key, or give a custom key a name that differs more.",
    .sources = "configmaps (run); MARS MotorData.cpp, NodeData.cpp:98-286, JointData.cpp:89-164."};

}  // namespace smurf::rules
