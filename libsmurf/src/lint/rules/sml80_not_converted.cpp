// SPDX-License-Identifier: BSD-3-Clause
// What a conversion refuses, or cannot say.
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFactsOf8002[] = {
    {&readers::mars, Effect::takes, "simulates with the annotation",
     "MARS smurf.cpp:902 (limits of the URDF are not used), MaterialData.cpp:47-118"},
};

constexpr Fact kFactsOf8004[] = {
    {&readers::gazebo, Effect::loses, "misses what its extensions add", "sdformat parser_urdf.cc"},
};

}  // namespace

extern constinit const Rule sml8001_not_expressible{
    .id = "SML8001",
    .name = "not-expressible",
    .severity = Severity::info,
    .summary = "An annotation has no counterpart in a URDF.",
    .why =
        "Programs that read the exported URDF do not get it. Examples are motor gains, sensors, bitmasks and joint pose sets.",
    .remedy = "Pass the values on in another way, or use a program that reads SMURF.",
    .sources = "The elements of URDF: urdfdom 3 and 5.1.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8002_not_requested{
    .id = "SML8002",
    .name = "not-requested",
    .severity = Severity::info,
    .summary = "An annotation differs from the URDF, and the export keeps the value of the URDF.",
    .why = "Readers of the exported URDF have the other value: the same robot behaves differently.",
    .remedy = "Export with `--apply`, which uses the values of the annotations.",
    .facts = kFactsOf8002,
    .reported_by = Tool::converters};

extern constinit const Rule sml8003_ambiguous{
    .id = "SML8003",
    .name = "ambiguous",
    .severity = Severity::info,
    .summary = "Several annotations give different values for the same part of the URDF.",
    .why = "Only one of them can be written. A simulator uses one of them, depending on its "
           "loading order.",
    .remedy = "Keep one of them.",
    .sources = "Two motors of one joint in MARS: smurf.cpp:257-270.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8004_vendor_extension{
    .id = "SML8004",
    .name = "vendor-extension",
    .severity = Severity::info,
    .summary = "An extension of the URDF is left out of the export.",
    .why = "Programs that read the extension do not find it.",
    .remedy = "Export with `--vendor keep`.",
    .facts = kFactsOf8004,
    .reported_by = Tool::converters};

extern constinit const Rule sml8005_collapsed_link{
    .id = "SML8005",
    .name = "collapsed-link",
    .severity = Severity::info,
    .summary = "A link on a fixed joint becomes part of the link that carries it.",
    .why = "Masses, shapes and sensors stay where they are, but the frame is gone: programs that "
           "look it up by name, such as tf2, do not find it.",
    .remedy = "Export with `--keep` and the name of the link or joint.",
    .sources = "sdformat and MuJoCo do the same on their own: ReduceFixedJoints, "
               "fusestatic.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8101_kept_as_text{
    .id = "SML8101",
    .name = "kept-as-text",
    .severity = Severity::info,
    .summary = "Something in a URDF or SRDF has no SMURF section.",
    .why = "urdf2smurf writes entries only where SMURF has a section for them. The rest is kept as "
           "text in the sections `urdf_extensions` and `srdf_extensions`, which SMURF simulators "
           "ignore.",
    .remedy = "Add an entry by hand where a simulator needs it.",
    .sources = "Sections and types that MARS reads: smurf.cpp:257-485, SensorManager.cpp:351.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules
