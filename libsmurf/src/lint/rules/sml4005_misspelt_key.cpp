// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml4005_misspelt_key{
    .id = "SML4005",
    .name = "misspelt-key",
    .severity = Severity::warning,
    .summary = "A key that no reader knows is nearly one that they know.",
    .why = "Every reader looks keys up by their exact names: a misspelt one is carried along, and "
           "the value it was to replace stays as it was.",
    .remedy = "Correct the key. Keys of your own are welcome; name them less alike.",
    .sources = "configmaps (run); MARS MotorData.cpp, NodeData.cpp:98-286, JointData.cpp:89-164."};

}  // namespace smurf::rules
