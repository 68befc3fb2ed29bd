// SPDX-License-Identifier: BSD-3-Clause
// What an output of smurfs-flatten cannot keep.
#include "base/findings/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml8201_lost_entity{
    .id = "SML8201",
    .name = "lost-entity",
    .severity = Severity::warning,
    .summary = "An entity of the scene cannot be written in the format.",
    .why = "Only the plug-in of the type knows how to build the entity.",
    .remedy = "Use a model or a primitive instead, or the format json, which keeps all keys.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8202_lost_joint_pose{
    .id = "SML8202",
    .name = "lost-joint-pose",
    .severity = Severity::warning,
    .summary = "The joints of a model start at zero instead of in their named pose.",
    .why = "The format cannot store the initial position of a joint.",
    .remedy = "Choose a form or format that has it: SDF with --form expand, MJCF, Drake "
              "directives, JSON.",
    .sources = "SDFormat 1.9 joint.sdf; URDF has no such element.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8203_lost_anchor{
    .id = "SML8203",
    .name = "lost-anchor",
    .severity = Severity::warning,
    .summary = "The anchor of an entity cannot be written in the format.",
    .why = "The entity is no longer fixed: it falls, or moves on its own.",
    .remedy = "Choose --form expand, or a format that joins models.",
    .sources = "SDFormat 1.9 world.sdf has no joints; MuJoCo 3 drops bodies inside attach (run).",
    .reported_by = Tool::converters};

extern constinit const Rule sml8204_lost_world_setting{
    .id = "SML8204",
    .name = "lost-world-setting",
    .severity = Severity::warning,
    .summary = "A setting of the world cannot be written in the format.",
    .why = "The simulator uses its own value.",
    .remedy = "Set it in the simulator.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8205_lost_shape{
    .id = "SML8205",
    .name = "lost-shape",
    .severity = Severity::warning,
    .summary = "A shape cannot be written in the format.",
    .why = "The shape is missing in the result: nothing is drawn, and nothing collides.",
    .remedy = "Add the file, convert the mesh, or use a shape that the format has.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8206_simplified_joint{
    .id = "SML8206",
    .name = "simplified-joint",
    .severity = Severity::warning,
    .summary = "A joint is written as a simpler one.",
    .why = "The joint moves differently than in the model.",
    .remedy = "Use joints that the format has.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8207_lost_annotations{
    .id = "SML8207",
    .name = "lost-annotations",
    .severity = Severity::info,
    .summary = "Annotations, or keys of an entity, have no place in the format.",
    .why =
        "Motors, sensors and similar annotations are specific to SMURF; other simulators keep them in other files.",
    .remedy = "Set them up in the simulator.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8208_not_in_dialect{
    .id = "SML8208",
    .name = "not-in-dialect",
    .severity = Severity::warning,
    .summary = "The reader of the chosen dialect does not load an entity.",
    .why = "The result contains only what that reader loads.",
    .remedy =
        "Use --dialect spec, or change the entity so that the reader loads it; --compare-dialects shows where each reader places it.",
    .sources = "smurfs-flatten; MARS SMURFLoader.cpp, MarsSceneLoader.cpp, Phobos multiple.py.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8209_old_nodes_stand_still{
    .id = "SML8209",
    .name = "old-nodes-stand-still",
    .severity = Severity::warning,
    .summary = "Movable nodes of a scene of MARS before SMURF are written as shapes that stand "
               "still.",
    .why =
        "Old scenes connect nodes by joints and groups, and often give densities as masses. Only shapes and poses are converted.",
    .remedy = "Make a SMURF model of everything that has to move.",
    .sources = "MARS NodeData.cpp:98-286, Load.cpp:228-268.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8210_file_in_archive{
    .id = "SML8210",
    .name = "file-in-archive",
    .severity = Severity::warning,
    .summary = "The result names a file that lies in an archive.",
    .why =
        "Only these tools read .zsmurf and .zsmurfs archives in place; a simulator finds no file "
        "at such a path.",
    .remedy = "Copy the files with --copy-assets DIR, or unpack the archive.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8211_lost_part{
    .id = "SML8211",
    .name = "lost-part",
    .severity = Severity::warning,
    .summary =
        "A part of a model or of an entity is not in the result, or is written as something else.",
    .why =
        "The simulator does not get what the format cannot express, such as velocity limits of joints or plug-ins in `<gazebo>` elements.",
    .remedy =
        "Set it up in the simulator, or choose a format that keeps it; docs/scene-formats.md has "
        "the table.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8212_chosen_value{
    .id = "SML8212",
    .name = "chosen-value",
    .severity = Severity::info,
    .summary = "The result has a value that is not in the source, because its readers need one.",
    .why =
        "A moving link without mass, or a scene without gravity and step, is read differently by "
        "each simulator.",
    .remedy = "Write the value into the model or the scene.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

extern constinit const Rule sml8213_replaced_collision{
    .id = "SML8213",
    .name = "replaced-collision",
    .severity = Severity::info,
    .summary = "The collision meshes have other shapes in the result, as `--collision` asks.",
    .why =
        "Convex parts, hulls, boxes and capsules are faster than meshes and more robust, but they "
        "are larger or smaller than the mesh. Masses and inertias stay those of the mesh.",
    .remedy =
        "Choose other shapes with `--collision` for the links whose volume changes too much, such "
        "as `--collision hull --collision 'finger_*=parts'`.",
    .sources = "smurfs-flatten, smurf2urdf.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules
