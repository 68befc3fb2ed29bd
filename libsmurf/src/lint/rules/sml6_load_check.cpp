// SPDX-License-Identifier: BSD-3-Clause
// What smurf-load-check finds by building a robot and moving it.
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFactsOf6001[] = {
    {&readers::mars, Effect::crashes, "runs ODE in its own process, and ends with it",
     "ODE 0.16.2, run"},
};

constexpr Fact kFactsOf6105[] = {
    {&readers::mars, Effect::refuses, "stops loading at the joint", "MARS JointManager.cpp:82-85"},
};

constexpr Fact kFactsOf6107[] = {
    {&readers::mars, Effect::loses, "leaves the whole node out", "MARS NodePhysics.cpp:626-634"},
};

}  // namespace

extern constinit const Rule sml6001_engine_gives_up{
    .id = "SML6001",
    .name = "engine-gives-up",
    .severity = Severity::error,
    .summary = "ODE, or the reader of a mesh, stops or crashes on this model.",
    .remedy = "Look at the stage that the message names; --stages runs only that stage.",
    .sources = "ODE 0.16.2, executed: failed assertions, crossing open triangle meshes.",
    .facts = kFactsOf6001,
    .reported_by = Tool::load_check};

extern constinit const Rule sml6002_no_verdict{
    .id = "SML6002",
    .name = "no-verdict",
    .severity = Severity::error,
    .summary =
        "The check of a model has no result: ODE's solver gave up, or it took too much time or "
        "memory.",
    .why = "Figures of a solver that gave up are meaningless, even where they look plausible. The "
           "time for a step of ODE grows with the third power of the number of connected bodies; a "
           "model that needs seconds here is not simulated in real time.",
    .remedy = "Look at the joint that the finding names, or start in another position with --pose. "
              "Simplify collision meshes, or allow more with --time-limit and --memory-limit.",
    .sources = "ODE 0.16.2, executed; the slowest of 307 robots takes 5 s, the median 23 ms.",
    .reported_by = Tool::load_check};

extern constinit const Rule sml6105_axis_zero{.id = "SML6105",
                                              .name = "ode-axis-zero",
                                              .severity = Severity::error,
                                              .summary = "A universal joint has no second axis.",
                                              .remedy = "Write `axis2` beside `axis`.",
                                              .facts = kFactsOf6105,
                                              .reported_by = Tool::load_check};

extern constinit const Rule sml6107_shape_not_buildable{
    .id = "SML6107",
    .name = "shape-not-buildable",
    .severity = Severity::error,
    .summary = "ODE cannot build a collision shape.",
    .why = "ODE stops at a shape without extent.",
    .remedy =
        "Give the shape a positive size, or export the mesh or the heightmap again. Heightmaps are "
        "read from PNG files.",
    .sources = "ODE 0.16.2 dCreateBox and its siblings; assimp 5.2; libpng 1.6.",
    .facts = kFactsOf6107,
    .reported_by = Tool::load_check};

extern constinit const Rule sml6201_initial_overlap{
    .id = "SML6201",
    .name = "initial-overlap",
    .severity = Severity::warning,
    .summary = "Two collision shapes overlap at the start.",
    .why = "ODE pushes them apart in the first steps, with a force that has no limit; only bodies "
           "that a joint connects are left alone.",
    .remedy = "Shrink one shape, or give the two bitmasks that share no bit.",
    .sources = "15 of 307 robots; Panda 36 mm, Baxter 67 mm.",
    .reported_by = Tool::load_check};

extern constinit const Rule sml6301_zero_outside_limits{
    .id = "SML6301",
    .name = "zero-outside-limits",
    .severity = Severity::warning,
    .summary = "The zero position of a joint, or its position in a pose, is outside its limits.",
    .why =
        "Simulators start with all joints at zero. A joint whose limits exclude zero is thrown to the nearest limit in the first steps. The check starts it at the nearest allowed position.",
    .remedy = "Give the model a joint pose within the limits, or start the simulation there.",
    .sources = "ODE 0.16.2, executed on 307 robots: all that move at rest have such a joint.",
    .reported_by = Tool::load_check};

extern constinit const Rule sml6302_moves_at_rest{
    .id = "SML6302",
    .name = "moves-at-rest",
    .severity = Severity::error,
    .summary = "A robot moves although no force acts on it.",
    .why = "Without gravity and contacts, a sound robot stays within 1e-15 m of its position; a "
           "robot that moves has joints that do not fit together.",
    .remedy = "Look at the origins of the joints above the link.",
    .sources = "ODE 0.16.2, executed: 132 of 132 sound robots move less than 5.1e-16 m.",
    .reported_by = Tool::load_check};

extern constinit const Rule sml6401_joint_comes_apart{
    .id = "SML6401",
    .name = "joint-comes-apart",
    .severity = Severity::error,
    .summary = "A joint comes apart under the weight of the robot.",
    .why = "The solver cannot balance the masses and inertias around the joint: the robot "
           "trembles, drifts or falls to pieces.",
    .remedy = "Look at the masses and inertias on both sides of the joint.",
    .sources = "ODE 0.16.2, executed: sound robots stay below 0.4 mm and 6e-3 rad at 1 ms.",
    .reported_by = Tool::load_check};

extern constinit const Rule sml6402_energy_grows{
    .id = "SML6402",
    .name = "energy-grows",
    .severity = Severity::error,
    .summary = "A robot that hangs freely gains energy.",
    .why =
        "No motor drives the robot, so the energy comes from numerical errors: the simulation diverges.",
    .remedy = "Look at the inertias of the link and at the limits of the joints above it.",
    .sources = "ODE 0.16.2, executed: sound robots gain at most 2e-5 m.",
    .reported_by = Tool::load_check};

extern constinit const Rule sml6501_contact_explodes{
    .id = "SML6501",
    .name = "contact-explodes",
    .severity = Severity::error,
    .summary = "A robot that is dropped from a height of 1 mm is flung away.",
    .why =
        "Shapes inside each other, or contacts on bodies that are far too light, push the robot away with extreme forces.",
    .remedy = "Shrink the shapes that overlap, or give them bitmasks that share no bit.",
    .sources = "ODE 0.16.2, executed: sound robots gain at most 0.07 m, exploding ones 1e4 m.",
    .reported_by = Tool::load_check};

extern constinit const Rule sml6601_anchor_moves{
    .id = "SML6601",
    .name = "anchor-moves",
    .severity = Severity::error,
    .summary = "An anchored entity moves relative to its anchor.",
    .why = "An anchor that gives way makes every pose in the scene wrong.",
    .remedy = "Look at the masses of the two models.",
    .sources = "ODE 0.16.2, executed.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules
