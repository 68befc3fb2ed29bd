// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml5020_cyclic_include_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "reads it again and again until the growing path cannot be opened, and ends with an "
     "uncaught exception",
     "MARS SMURFLoader.cpp:350-380, run"},
    {&readers::phobos, Effect::refuses, "stops with a RecursionError", "Phobos multiple.py:28-33"},
};

}  // namespace

extern constinit const Rule sml5020_cyclic_include{
    .id = "SML5020",
    .name = "cyclic-include",
    .severity = Severity::error,
    .summary = "A scene includes itself, directly or through others.",
    .remedy = "Remove one include from the cycle; the notes name its files.",
    .facts = kFacts};

}  // namespace smurf::rules::sml5020_cyclic_include_file
