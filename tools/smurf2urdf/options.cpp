// SPDX-License-Identifier: BSD-3-Clause
#include "smurf2urdf/options.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "common/convert/collision_options.hpp"

namespace smurf::tools {
namespace {

Setter set_apply(AppliedAnnotations& apply) {
  return [&apply](std::string_view value) -> std::optional<std::string> {
    constexpr std::string_view kKnown[] = {"materials", "limits", "dynamics", "mimic", "all"};
    for (const std::string_view item : split_items(value)) {
      if (std::find(std::begin(kKnown), std::end(kKnown), item) == std::end(kKnown)) {
        return none_of(item, kKnown);
      }
      const bool is_all = item == "all";
      apply.materials |= is_all || item == "materials";
      apply.limits |= is_all || item == "limits";
      apply.dynamics |= is_all || item == "dynamics";
      apply.mimic |= is_all || item == "mimic";
    }
    return std::nullopt;
  };
}

Setter append_items(std::vector<std::string>& list) {
  return [&list](std::string_view value) -> std::optional<std::string> {
    for (const std::string_view item : split_items(value)) list.emplace_back(item);
    return std::nullopt;
  };
}

/// The options of each preset.
struct Preset {
  std::string_view name;
  std::string_view options;
  void (*set)(UrdfExport& wanted);
};

constexpr Preset kPresets[] = {
    // Comments break spawners that pass the URDF as a parameter.
    {"ros2", "--apply limits,mimic --actuation ros2_control --comments strip",
     [](UrdfExport& wanted) {
       wanted.apply.limits = wanted.apply.mimic = true;
       wanted.actuation = Actuation::ros2_control;
       wanted.strips_comments = true;
     }},
    {"gazebo", "--apply all --sensors gazebo --comments strip",
     [](UrdfExport& wanted) {
       wanted.apply = {true, true, true, true};
       wanted.adds_gazebo_sensors = true;
       wanted.strips_comments = true;
     }},
    // These three readers cannot resolve package addresses without further settings.
    {"mujoco", "--apply limits,dynamics,materials --mesh-uri relative --settings mujoco",
     [](UrdfExport& wanted) {
       wanted.apply.limits = wanted.apply.dynamics = wanted.apply.materials = true;
       wanted.mesh_uri = MeshUri::relative;
       wanted.adds_mujoco_settings = true;
     }},
    {"pybullet", "--apply limits,dynamics,materials --mesh-uri relative",
     [](UrdfExport& wanted) {
       wanted.apply.limits = wanted.apply.dynamics = wanted.apply.materials = true;
       wanted.mesh_uri = MeshUri::relative;
     }},
    {"drake", "--apply all --mesh-uri relative --actuation transmission",
     [](UrdfExport& wanted) {
       wanted.apply = {true, true, true, true};
       wanted.mesh_uri = MeshUri::relative;
       wanted.actuation = Actuation::transmission;
     }},
};

std::vector<std::string_view> preset_names() {
  std::vector<std::string_view> names;
  for (const Preset& preset : kPresets) names.push_back(preset.name);
  return names;
}

/// Programs of ROS 2 are many, and urdfdom, which they use, is always asked.
Setter set_preset(ExportOptions& options) {
  return [&options](std::string_view value) -> std::optional<std::string> {
    for (const Preset& preset : kPresets) {
      if (preset.name != value) continue;
      preset.set(options.conversion);
      options.reader = value == "ros2" ? nullptr : find_target(value);
    }
    return std::nullopt;
  };
}

std::vector<Option> content_options(UrdfExport& wanted) {
  return {
      {.name = "apply",
       .metavar = "LIST",
       .help = "Replace these values of the URDF by annotations, comma-separated: materials "
               "(colours, textures), limits (of motors: effort, speed, range), dynamics "
               "(damping, friction), mimic (of motors), all.",
       .set = set_apply(wanted.apply)},
      {.name = "actuation",
       .metavar = "FORM",
       .help = "Write motors as ros2_control or transmission (of ros_control), for joints that "
               "no extension of the URDF drives yet.",
       .values = {"none", "ros2_control", "transmission"},
       .set = choose<Actuation>(wanted.actuation, {{"none", Actuation::none},
                                                   {"ros2_control", Actuation::ros2_control},
                                                   {"transmission", Actuation::transmission}})},
      {.name = "sensors",
       .metavar = "FORM",
       .help = "Write sensors as Gazebo sensors, where Gazebo has the type; the default is none.",
       .values = {"none", "gazebo"},
       .set = choose<bool>(wanted.adds_gazebo_sensors, {{"none", false}, {"gazebo", true}})},
      {.name = "settings",
       .metavar = "READER",
       .help = "Add settings for one reader. mujoco: settings with which MuJoCo finds meshes "
               "outside of the folder of the URDF. The default is none.",
       .values = {"none", "mujoco"},
       .set = choose<bool>(wanted.adds_mujoco_settings, {{"none", false}, {"mujoco", true}})},
      {.name = "collapse-fixed",
       .help = "Merge each link on a fixed joint into its parent link, with its shapes, mass and "
               "sensors. A link is kept when an extension refers to the "
               "link itself (its frame, a plugin, its own friction).",
       .set = set_flag(wanted.collapses_fixed)},
      {.name = "keep",
       .metavar = "NAMES",
       .help = "Keep these links or joints with --collapse-fixed; separate them by commas.",
       .set = append_items(wanted.keep)},
      {.name = "prefix",
       .metavar = "TEXT",
       .help = "Put TEXT before the names of links, joints, materials and transmissions, and "
               "before all references to them; a link `world` keeps its name.",
       .set = set_text(wanted.prefix)},
      {.name = "base",
       .metavar = "HOW",
       .help = "Keep the root as it is (as-is, the default), or add a link `world` above it with "
               "a fixed or floating joint.",
       .values = {"as-is", "fixed", "floating"},
       .set = choose<BaseJoint>(wanted.base, {{"as-is", BaseJoint::as_is},
                                              {"fixed", BaseJoint::fixed},
                                              {"floating", BaseJoint::floating}})}};
}

std::vector<Option> form_options(UrdfExport& wanted) {
  return {
      {.name = "mesh-uri",
       .metavar = "FORM",
       .help = "Write mesh and texture paths in this form: relative, package (with "
               "--package-name), absolute, file, keep. By default, relative paths are adapted to "
               "the output folder, and other paths are kept.",
       .values = {"relative", "package", "absolute", "file", "keep"},
       .set = choose<MeshUri>(wanted.mesh_uri, {{"relative", MeshUri::relative},
                                                {"package", MeshUri::package},
                                                {"absolute", MeshUri::absolute},
                                                {"file", MeshUri::file},
                                                {"keep", MeshUri::keep}})},
      {.name = "package-name",
       .metavar = "NAME",
       .help = "Set the package for --mesh-uri package. The folder of the package is the DIR "
               "of --package NAME=DIR; otherwise, it is the nearest folder above the URDF with a "
               "package.xml, or else the folder above urdf/.",
       .set = set_text(wanted.package_name)},
      {.name = "vendor",
       .metavar = "HOW",
       .help = "keep (the default) or strip elements that URDF does not define: gazebo, "
               "transmission, ros2_control and others.",
       .values = {"keep", "strip"},
       .set = choose<bool>(wanted.strips_extensions, {{"keep", false}, {"strip", true}})},
      {.name = "comments",
       .metavar = "HOW",
       .help = "keep (the default) or strip.",
       .values = {"keep", "strip"},
       .set = choose<bool>(wanted.strips_comments, {{"keep", false}, {"strip", true}})},
      {.name = "canonical",
       .help =
           "Rewrite the URDF in a canonical form: links and joints in the order of the tree, attributes in "
           "a fixed order, the shortest numbers, no comments.",
       .set = set_flag(wanted.is_canonical)},
      {.name = "urdf-version",
       .metavar = "VERSION",
       .help = "Set the version of the URDF: 1.0, 1.1 or 1.2. In 1.0, capsules become "
               "cylinders with spheres, and quaternions become rpy; limits of acceleration and "
               "jerk need 1.2.",
       .values = {"1.0", "1.1", "1.2"},
       .set = set_text(wanted.version)}};
}

std::vector<Option> run_options(ExportOptions& options) {
  return {{.name = "preset",
           .metavar = "READER",
           .help =
               "Set the options that a reader needs: ros2, gazebo, mujoco, pybullet, drake. Later "
               "options override them. The result must load there: meshes that the reader does "
               "not read are copied as OBJ to FILE_meshes/ beside the output.",
           .values = preset_names(),
           .set = set_preset(options)},
          {.name = "show-preset",
           .metavar = "READER",
           .help = "Print the options of a preset, and exit.",
           .values = preset_names(),
           .set = set_text(options.shown_preset)},
          {.name = "srdf",
           .metavar = "FILE",
           .help = "Write an SRDF as well: joint pose sets as group states, and pairs of links "
                   "that do not collide, from bitmasks and the tree.",
           .set = set_text(options.srdf)},
          {.name = "loss-report",
           .metavar = "FILE",
           .help = "List everything that the URDF cannot express in FILE, as JSON.",
           .set = set_text(options.loss_report)},
          {.name = "fail-on-loss",
           .help = "Refuse to write when something would be lost.",
           .set = set_flag(options.fails_on_loss)},
          {.name = "force",
           .help = "Export despite errors, as long as the model can be read.",
           .set = set_flag(options.common.force)},
          {.name = "prove",
           .help = "Print the comparison with the source on standard error.",
           .set = set_flag(options.prove)},
          {.name = "dry-run",
           .help = "Run all checks, write nothing.",
           .set = set_flag(options.dry_run)}};
}

void add(Command& command, std::string_view group, std::vector<Option> options) {
  for (Option& option : options) {
    option.group = group;
    command.options.push_back(std::move(option));
  }
}

}  // namespace

std::string preset_text(std::string_view name) {
  for (const Preset& preset : kPresets) {
    if (preset.name == name) return std::string(preset.options) + "\n";
  }
  return {};
}

Command make_command(ExportOptions& options) {
  Command command;
  command.name = "smurf2urdf";
  command.summary =
      "Exports the URDF of a SMURF model byte for byte. Only mesh paths that would not resolve "
      "from the output folder change.";
  command.operands = "MODEL [NAME:=VALUE...]";
  command.details =
      "MODEL is a .smurf or .urdf file, or a folder with one of them. The result is read again and "
      "compared with the source before it is written: urdfdom must accept it, and all link poses, "
      "masses, inertias and limits must be equal, except limits that an option changes. A model is "
      "refused when its URDF does not load, or when the options need a value that is wrong; its "
      "other errors are counted, and smurf-lint shows them. A .xacro file is expanded first, with the "
      "arguments NAME:=VALUE; without other options, its expansion is the result.";
  command.options = converter_options(options.common, "Write the URDF to FILE; without it, or with "
                                                      "'-', to standard output.");
  add(command, "Conversion", run_options(options));
  add(command, "Content", content_options(options.conversion));
  add(command, "Content", {collision_option(options.collisions)});
  add(command, "Form", form_options(options.conversion));
  command.set_operand = take_one_operand(options.model, options.common.xacro);
  command.examples = {
      {"smurf2urdf robot.smurf -o robot.urdf", "Export a model:"},
      {"smurf2urdf robot.smurf | check_urdf /dev/stdin", "Pass the URDF to another program:"},
      {"smurf2urdf robot.smurf --apply all --loss-report lost.json -o robot.urdf",
       "Apply the values of the annotations, and list what is lost:"},
      {"smurf2urdf robot.urdf.xacro name:=left -o robot.urdf", "Expand a xacro file:"},
      {"smurf2urdf robot.smurf --collapse-fixed --keep camera -o robot.urdf",
       "Merge links on fixed joints, except one:"}};
  return command;
}

bool is_plain(const ExportOptions& options) {
  const UrdfExport& wanted = options.conversion;
  const AppliedAnnotations& apply = wanted.apply;
  const bool has_changes = apply.materials || apply.limits || apply.dynamics || apply.mimic ||
                           wanted.adds_gazebo_sensors || wanted.adds_mujoco_settings ||
                           wanted.strips_extensions || wanted.strips_comments ||
                           wanted.collapses_fixed || wanted.is_canonical;
  return !has_changes && wanted.mesh_uri == MeshUri::rebase &&
         wanted.actuation == Actuation::none && wanted.prefix.empty() &&
         wanted.base == BaseJoint::as_is && wanted.version.empty() && options.srdf.empty() &&
         options.loss_report.empty() && !options.prove && !options.fails_on_loss &&
         !options.collisions.changes_something();
}

std::string problem_of(ExportOptions& options) {
  UrdfExport& wanted = options.conversion;
  if (wanted.mesh_uri == MeshUri::package && wanted.package_name.empty()) {
    return "--mesh-uri package needs --package-name";
  }
  if (wanted.mesh_uri != MeshUri::package && !wanted.package_name.empty()) {
    return "--package-name needs --mesh-uri package";
  }
  if (!wanted.keep.empty() && !wanted.collapses_fixed) return "--keep needs --collapse-fixed";
  const std::string& output = options.common.output;
  if (!options.srdf.empty() && wanted.collapses_fixed) {
    return "--srdf and --collapse-fixed exclude each other: the links of the SRDF would be gone";
  }
  if (options.srdf == "-" || (!options.srdf.empty() && options.srdf == output)) {
    return "--srdf needs a separate file";
  }
  wanted.has_srdf = !options.srdf.empty();
  if (wanted.adds_mujoco_settings) {
    options.common.targets = {find_target("mujoco")};
    if (options.reader == nullptr) options.reader = find_target("mujoco");
  }
  const bool to_stdout = output.empty() || output == "-";
  // Standard output counts as the current folder.
  wanted.output_folder = to_stdout ? "." : std::string(path::parent(output));
  return {};
}

}  // namespace smurf::tools
