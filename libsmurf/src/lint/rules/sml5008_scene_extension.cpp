// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5008_scene_extension_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "reads nothing and reports success",
     "MARS SMURFLoader.cpp:405-411"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml5008_scene_extension{
    .id = "SML5008",
    .name = "scene-extension",
    .severity = Severity::error,
    .summary = "An entity of type smurfs or smurfa names a file with another extension.",
    .remedy = "Rename the scene file, or correct `type`.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5008_scene_extension_file
