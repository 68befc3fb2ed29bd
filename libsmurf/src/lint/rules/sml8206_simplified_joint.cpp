// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8206_simplified_joint_file {

extern constinit const Rule sml8206_simplified_joint{
    .id = "SML8206",
    .name = "simplified-joint",
    .severity = Severity::warning,
    .summary = "A joint is written as a simpler one.",
    .why = "The joint moves differently than in the model.",
    .remedy = "Use joints that the format has.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8206_simplified_joint_file
