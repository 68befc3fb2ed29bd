// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5305_path_from_working_folder_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "looks in the folder where the program was started",
     "MARS SMURFLoader.cpp:484-488"},
};

}  // namespace

extern constinit const Rule sml5305_path_from_working_folder{
    .id = "SML5305",
    .name = "path-from-working-folder",
    .severity = Severity::warning,
    .summary = "A path of `environment` is relative to the folder where the simulation is started.",
    .why = "The folder in which the program is started decides which files it finds.",
    .remedy =
        "Put the sky box beside the scene. For the other paths, use absolute paths or always start "
        "in the same folder.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5305_path_from_working_folder_file
