// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5034_old_scene_file_missing_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "makes no node without its heights",
     "MARS NodeManager.cpp:208-211", when(cases::kHeights)},
    {&readers::mars, Effect::loses, "shows the node without its mesh",
     "MARS gui_helper_functions.cpp:384", when(cases::kSeen)},
    {&readers::mars, Effect::crashes, "ends with an exception on a missing mesh",
     "MARS gui_helper_functions.cpp:278-280, NodeManager.cpp:184"},
};

}  // namespace

extern constinit const Rule sml5034_old_scene_file_missing{
    .id = "SML5034",
    .name = "old-scene-file-missing",
    .severity = Severity::error,
    .summary = "A node of an old MARS scene names a mesh or a heightmap that does not exist.",
    .remedy = "Correct the path; it is relative to the folder of the old scene.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5034_old_scene_file_missing_file
