// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8212_chosen_value_file {

extern constinit const Rule sml8212_chosen_value{
    .id = "SML8212",
    .name = "chosen-value",
    .severity = Severity::info,
    .summary = "The result has a value that is not in the source, because its readers need one.",
    .why =
        "A moving link without mass, or a scene without gravity and step, is read differently by "
        "each simulator.",
    .remedy = "Write the value into the model or the scene.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8212_chosen_value_file
