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
    .summary = "An entry or a main file lacks a key without which it means nothing.",
    .why =
        "MARS reads an absent key as 0 or the empty text: a motor without joint drives joint 0, "
        "an entry without name matches nothing, a main file without `files` has no URDF and MARS "
        "dereferences the null model; Phobos stops with a KeyError.",
    .remedy = "Add the key.",
    .sources = "configmaps (run); MARS smurf.cpp:264, 988-998; Phobos representation.py:2399."};

constinit const Rule sml4005_misspelt_key{
    .id = "SML4005",
    .name = "misspelt-key",
    .severity = Severity::warning,
    .summary = "A key that no reader knows is nearly one that they know.",
    .why = "Every reader looks keys up by their exact names: a misspelt one is carried along, and "
           "the value it was to replace stays as it was.",
    .remedy = "Correct the key. Keys of your own are welcome; name them less alike.",
    .sources = "configmaps (run); MARS MotorData.cpp, NodeData.cpp:98-286, JointData.cpp:89-164."};

constinit const Rule sml4006_number_notation{
    .id = "SML4006",
    .name = "number-notation",
    .severity = Severity::error,
    .summary = "A number is written in a notation that MARS reads as another number.",
    .why = "MARS reads whole numbers with scanf's %d, which stops at the first character that is "
           "no digit: `1e3` is 1, `0x10` is 0. Other numbers may have exponents, but `0o17` is 0.",
    .remedy = "Write plain decimal digits.",
    .sources = "configmaps ConfigAtom.hpp:335-386 (run)."};

constinit const Rule sml4008_incomplete_value{
    .id = "SML4008",
    .name = "incomplete-value",
    .severity = Severity::warning,
    .summary = "A value is there in part only.",
    .why = "MARS reads what is absent as 0 or the empty text: a colour without `g` has no green, a "
           "quaternion without `w` turns by half a turn, an empty name matches nothing, and a "
           "motor without position stays out of the joint pose.",
    .remedy = "Write the whole value.",
    .sources = "mars_utils Color.cpp:28-34 (run); configmaps (run): an absent key reads as 0."};

constinit const Rule sml4007_yaml_version{
    .id = "SML4007",
    .name = "yaml-version",
    .severity = Severity::warning,
    .summary = "A value means something else to readers of YAML 1.1, such as Phobos.",
    .why = "PyYAML follows YAML 1.1: `1e-5` and `-.5` are texts, `010` is 8, `on` and `no` are "
           "booleans, `12:30` is 750. yaml-cpp and configmaps (MARS) read what is written.",
    .remedy = "Write numbers with a point and a sign in the exponent (1.0e-5), and quote texts.",
    .sources = "PyYAML 6.0 resolver.py (run); configmaps ConfigAtom.hpp:335-386 (run)."};

}  // namespace smurf::rules
