// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5002_rotation_length_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "reads no rotation from a list of another length; ends with an uncaught exception on a "
     "mapping without all of w, x, y, z",
     "MARS SimEntity.cpp:405-431, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml5002_rotation_length{
    .id = "SML5002",
    .name = "rotation-length",
    .severity = Severity::error,
    .summary = "A rotation does not have one, three or four numbers.",
    .remedy =
        "Write one number (degrees about z), three (degrees about the fixed axes x, y, z), or a "
        "quaternion w, x, y, z.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5002_rotation_length_file
