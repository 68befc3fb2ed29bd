// SPDX-License-Identifier: BSD-3-Clause
// What smurf-load-check reports. The rows stand here because the library knows no physics engine.
#include "base/rules.hpp"

namespace smurf::rules {

constinit const Rule sml6001_engine_gives_up{
    .id = "SML6001",
    .name = "engine-gives-up",
    .severity = Severity::error,
    .summary = "ODE, or the reader of a mesh, stops or crashes on this model.",
    .why = "MARS runs the same engine in its own process and ends with it.",
    .remedy = "Look at the stage that the message names; --stages runs one alone.",
    .sources = "ODE 0.16.2, executed: failed assertions, crossing open triangle meshes."};

constinit const Rule sml6002_no_verdict{
    .id = "SML6002",
    .name = "no-verdict",
    .severity = Severity::error,
    .summary = "The check of a model has no result: ODE's solver gave up, or it took too much time "
               "or memory.",
    .why =
        "Figures of a solver that gave up say nothing, even where they look sound. A step of ODE "
        "takes time with the third power of the bodies that are connected; a model that needs "
        "seconds here does not run in real time in MARS.",
    .remedy = "Look at the joint that the finding names, or start elsewhere with --pose. Simplify "
              "collision meshes, or allow more with --time-limit and --memory-limit.",
    .sources = "ODE 0.16.2, executed; the slowest of 307 robots takes 5 s, the median 23 ms."};

// SML6101 to SML6104 and SML6106 are retired: what they found is reported under the rules of the
// linter, SML1501 and the like.
constinit const Rule sml6105_axis_zero{.id = "SML6105",
                                       .name = "ode-axis-zero",
                                       .severity = Severity::error,
                                       .summary = "A universal joint has no second axis.",
                                       .why = "MARS stops loading at such a joint.",
                                       .remedy = "Write `axis2` beside `axis`.",
                                       .sources = "MARS JointManager.cpp:82-85."};

constinit const Rule sml6107_shape_not_buildable{
    .id = "SML6107",
    .name = "shape-not-buildable",
    .severity = Severity::error,
    .summary = "ODE cannot build a collision shape.",
    .why = "ODE stops at a shape without extent; MARS leaves the whole node out.",
    .remedy = "Give the shape a positive size, or export the mesh or the image of heights again. "
              "Heights are read from PNG files.",
    .sources = "ODE 0.16.2 dCreateBox and the like; assimp 5.2; libpng 1.6."};

constinit const Rule sml6201_initial_overlap{
    .id = "SML6201",
    .name = "initial-overlap",
    .severity = Severity::warning,
    .summary = "Two collision shapes are inside each other at the start.",
    .why = "ODE pushes them apart in the first steps, with a force that has no limit; only bodies "
           "that a joint connects are left alone.",
    .remedy = "Shrink one shape, or give the two bitmasks without a common bit.",
    .sources = "15 of 307 robots; Panda 36 mm, Baxter 67 mm."};

constinit const Rule sml6301_zero_outside_limits{
    .id = "SML6301",
    .name = "zero-outside-limits",
    .severity = Severity::warning,
    .summary = "A joint cannot be at zero, or a pose has it outside its limits.",
    .why =
        "Simulators start with all joints at zero; one whose stops exclude zero is thrown to the "
        "nearest stop in the first steps. The check starts it at the nearest allowed position.",
    .remedy = "Give the model a joint pose within the limits, or start the simulation there.",
    .sources = "ODE 0.16.2, executed: all of 307 robots that move at rest have such a joint."};

constinit const Rule sml6302_moves_at_rest{
    .id = "SML6302",
    .name = "moves-at-rest",
    .severity = Severity::error,
    .summary = "A robot moves although no force acts on it.",
    .why = "Without gravity and contacts a sound robot stays within 1e-15 m of where it is; one "
           "that moves has joints that cannot be assembled.",
    .remedy = "Look at the origins of the joints above the link.",
    .sources = "ODE 0.16.2, executed: 132 of 132 sound robots move less than 5.1e-16 m."};

constinit const Rule sml6401_joint_comes_apart{
    .id = "SML6401",
    .name = "joint-comes-apart",
    .severity = Severity::error,
    .summary = "A joint does not hold the robot that hangs on it.",
    .why = "The solver cannot balance the masses and inertias around the joint: in MARS the robot "
           "trembles, drifts or falls to pieces.",
    .remedy = "Look at the masses and inertias on both sides of the joint.",
    .sources = "ODE 0.16.2, executed: sound robots stay below 0.4 mm and 6e-3 rad at 1 ms."};

constinit const Rule sml6402_energy_grows{
    .id = "SML6402",
    .name = "energy-grows",
    .severity = Severity::error,
    .summary = "A robot that hangs freely gains energy.",
    .why = "Nothing drives it, so the solver does: the simulation diverges.",
    .remedy = "Look at the inertias of the link and at the limits of the joints above it.",
    .sources = "ODE 0.16.2, executed: sound robots gain at most 2e-5 m."};

constinit const Rule sml6501_contact_explodes{
    .id = "SML6501",
    .name = "contact-explodes",
    .severity = Severity::error,
    .summary = "A robot that is dropped from a millimetre is flung away.",
    .why = "Shapes inside each other, or contacts on bodies that are far too light, push with "
           "forces that no robot survives.",
    .remedy = "Shrink the shapes that overlap, or give them bitmasks without a common bit.",
    .sources = "ODE 0.16.2, executed: sound robots gain at most 0.07 m, exploding ones 1e4 m."};

constinit const Rule sml6601_anchor_moves{
    .id = "SML6601",
    .name = "anchor-moves",
    .severity = Severity::error,
    .summary = "An anchored entity moves against what it is anchored to.",
    .why = "An anchor is rigid; one that gives way makes every pose in the scene wrong.",
    .remedy = "Look at the masses of the two models.",
    .sources = "ODE 0.16.2, executed."};

}  // namespace smurf::rules
