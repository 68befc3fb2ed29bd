// SPDX-License-Identifier: BSD-3-Clause
// The findings about shapes and values, reported by keys.cpp and the readers of sections and
// scenes.
#include "base/rules.hpp"

namespace smurf::rules {

constinit const Rule sml4001_wrong_type{
    .id = "SML4001",
    .name = "wrong-type",
    .severity = Severity::error,
    .summary = "A key holds a value of the wrong kind.",
    .why =
        "MARS keeps every scalar as text and reads uninitialised memory when it is not the number "
        "or boolean it needs (`yes`, `abc`, `.inf`); a list where it needs a mapping, or the "
        "reverse, is an uncaught exception.",
    .remedy = "Write the kind of value that the message names; `smurf-lint --explain` of the key's "
              "section and the schemas list them.",
    .sources =
        "configmaps ConfigAtom.hpp:83-91 and 335-386, MaterialData.cpp:53-80, Color.cpp:28-34 "
        "(run)."};

constinit const Rule sml4002_unknown_value{
    .id = "SML4002",
    .name = "unknown-value",
    .severity = Severity::error,
    .summary = "A key holds a word that is not one of its values.",
    .why =
        "MARS compares these words literally; an unknown one leaves the object undefined or stops "
        "the loading of everything that follows.",
    .remedy = "Use one of the known values; they are case-sensitive.",
    .sources = "MARS NodeData.cpp:98-286, JointData.cpp:89-164."};

constinit const Rule sml4003_out_of_range{
    .id = "SML4003",
    .name = "out-of-range",
    .severity = Severity::error,
    .summary = "A number lies outside what its key allows.",
    .why = "MARS takes the number as it is: a negative effort, size or rate is read as another "
           "number (unsigned keys wrap around) or makes the physics engine refuse the object.",
    .remedy = "Write a number within the bounds of the message.",
    .sources = "configmaps ConfigAtom.hpp:335-386 (run: -1 is read as 18446744073709551615)."};

constinit const Rule sml4004_missing_key{
    .id = "SML4004",
    .name = "missing-key",
    .severity = Severity::error,
    .summary = "An entry lacks a key without which it means nothing.",
    .why = "MARS reads an absent key as 0 or the empty text: a motor without joint drives joint 0, "
           "an entry without name matches nothing; Phobos stops with a KeyError.",
    .remedy = "Add the key.",
    .sources = "configmaps (run); MARS smurf.cpp:264; Phobos representation.py:2399."};

}  // namespace smurf::rules
