// SPDX-License-Identifier: BSD-3-Clause
// smurfs-flatten: a scene as instances in the world frame.
#include <algorithm>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "common/cli/browser.hpp"
#include "common/cli/process.hpp"
#include "common/cli/shared_options.hpp"
#include "common/convert/collision_options.hpp"
#include "common/convert/converter.hpp"
#include "common/convert/copy_files.hpp"
#include "common/files/file_set.hpp"
#include "plan/repository.hpp"
#include "render/printable.hpp"
#include "smurf/conversion.hpp"
#include "smurf/dialect.hpp"
#include "smurf/result_losses.hpp"
#include "smurf/write_scene.hpp"
#include "smurfs-flatten/chain.hpp"
#include "smurfs-flatten/compare_dialects.hpp"
#include "smurfs-flatten/formats.hpp"
#include "smurfs-flatten/motion_options.hpp"

using namespace smurf;
using namespace smurf::tools;

namespace {

constexpr std::string_view kTool = "smurfs-flatten";

struct Options {
  ConverterOptions common;
  std::string scene;
  std::string format;  ///< empty: json
  std::string format_help;
  std::string dialect = "spec";
  std::string dialect_help;
  std::string ground_help;
  std::string base;
  MotorOptions motors;
  std::string motors_help;
  SelfCollision self_collision = SelfCollision::as_usual;
  bool excludes_overlaps = false;
  CollisionRequest collisions;
  std::string srdf;
  std::string controllers;
  bool compare_dialects = false;
  std::string form;
  std::string explained;
  std::string assets;  ///< folder
  std::string loss_report;
  bool ground = false;
  bool overwrite = false;
  bool links = false;
  bool strict = false;
  bool opens = false;
};

/// "sdf, sdf1.6, mjcf": the formats that have something.
std::string formats_with(bool SceneFormat::*what) {
  std::string names;
  for (const SceneFormat* format : scene_formats()) {
    if (format->*what) names += (names.empty() ? "" : ", ") + std::string(format->name);
  }
  return names;
}

std::vector<std::string_view> dialect_names() {
  std::vector<std::string_view> names;
  for (const Dialect* dialect : dialects()) names.push_back(dialect->name);
  return names;
}

std::string dialect_help() {
  std::string help = "Read the scene as this reader does.";
  for (const Dialect* dialect : dialects()) {
    help += " " + std::string(dialect->name) + ": " + std::string(dialect->help) +
            (dialect == dialects().front() ? " (default)." : ".");
  }
  return help;
}

void add_options(Command& command, Options& options) {
  options.format_help = format_help();
  options.dialect_help = dialect_help();
  options.ground_help = "Add a floor at z = 0 that is not in the scene (" +
                        formats_with(&SceneFormat::has_ground) + ").";
  const auto add = [&](Option option) {
    option.group = "Conversion";
    command.options.push_back(std::move(option));
  };
  add({.name = "format",
       .metavar = "FORMAT",
       .help = options.format_help,
       .values = format_names(),
       .hint = format_hint,
       .help_page = formats_page,
       .set = set_text(options.format)});
  add({.name = "form",
       .metavar = "FORM",
       .help = "Choose how models are written. reference: the result names their files; expand: it "
               "contains them. Formats that support both expand by default, which loses less.",
       .values = {"reference", "expand"},
       .set = set_text(options.form)});
  add({.name = "ground", .help = options.ground_help, .set = set_flag(options.ground)});
  add({.name = "base",
       .metavar = "BASE",
       .help =
           "Choose what becomes of models that the scene does not anchor. fixed: they are fixed "
           "to the world; floating: they move freely. By default, they move freely, except "
           "for those whose root is called `world` in formats for simulators.",
       .values = {"fixed", "floating"},
       .set = set_text(options.base)});
  options.motors_help =
      "Choose what the motors are commanded with, and give one to each joint without a motor (" +
      formats_with(&SceneFormat::has_motors) +
      "). auto: a position, unless the model or a controller says otherwise. By default, motors are as "
      "in the model and its controllers.";
  for (Option& option : motor_options(options.motors, options.controllers, options.motors_help)) {
    add(std::move(option));
  }
  for (Option& option :
       contact_options(options.self_collision, options.srdf, options.excludes_overlaps)) {
    add(std::move(option));
  }
  add(collision_option(options.collisions));
  add({.name = "links",
       .help = "Write the world pose of every link as well.",
       .set = set_flag(options.links)});
  add({.name = "dialect",
       .metavar = "NAME",
       .help = options.dialect_help,
       .values = dialect_names(),
       .set = set_text(options.dialect)});
  add({.name = "compare-dialects",
       .help =
           "Print a table of the entities whose pose differs between dialects; with --format json, "
           "as JSON.",
       .set = set_flag(options.compare_dialects)});
  add({.name = "copy-assets",
       .metavar = "DIR",
       .help =
           "Copy the meshes, textures and heightmaps that the result names into DIR, and refer to "
           "the copies.",
       .set = set_text(options.assets)});
  add({.name = "overwrite",
       .help = "With --copy-assets: replace files that exist.",
       .set = set_flag(options.overwrite)});
  add({.name = "explain-pose",
       .metavar = "NAME",
       .help =
           "Print the chain of transforms from the world to an instance, in the chosen dialect.",
       .set = set_text(options.explained)});
  add({.name = "force",
       .help = "Write the scene despite errors, as long as every pose is known.",
       .set = set_flag(options.common.force)});
  add({.name = "loss-report",
       .metavar = "FILE",
       .help = "List everything that the format cannot express in FILE, as JSON.",
       .set = set_text(options.loss_report)});
  add({.name = "fail-on-loss",
       .help = "Refuse to write when the format cannot express something.",
       .set = set_flag(options.strict)});
  command.options.push_back(open_option(options.opens));
}

Command make_command(Options& options) {
  Command command;
  command.name = kTool;
  command.summary =
      "Converts a robot or a scene for MuJoCo, Gazebo, Drake, Isaac Sim and others; every entity, "
      "also of nested scenes, gets its pose in the world.";
  command.operands = "SCENE [NAME:=VALUE]...";
  command.details =
      "SCENE is a .smurfs or .smurfa file, a .zsmurfs archive with a scene, a drawing (.svg) "
      "whose groups are entities, an SDF with a world, or a folder with one scene; another .sdf, a "
      ".smurf, .urdf, .xacro or .mjcf counts as a scene of one model; NAME:=VALUE is an argument of "
      "the .xacro. Poses are those of the "
      "URDF root links, in metres and unit "
      "quaternions; the pose of a parent link depends on the joint pose of its entity. A scene "
      "is refused when a pose is unknown; other errors of its models are counted, and smurf-lint "
      "shows them.";
  command.options = converter_options(
      options.common, "Write the result to FILE; without it, or with '-', to standard output.");
  add_options(command, options);
  command.set_operand = take_one_operand(options.scene, options.common.xacro);
  command.examples = {
      {"smurfs-flatten arm.urdf --format mjcf -o arm.xml", "Convert a robot for MuJoCo:"},
      {"smurfs-flatten scene.smurfs -o scene.sdf", "Convert a scene for Gazebo:"},
      {"smurfs-flatten scene.smurfs -o scene.json", "Expand a scene:"},
      {"smurfs-flatten scene.smurfs --links | jq '.instances[0].links'",
       "Print the poses of all links:"},
      {"smurfs-flatten scene.smurfs --explain-pose cell/Table", "Show where a pose comes from:"},
      {"smurfs-flatten scene.smurfs --compare-dialects",
       "Show where programs disagree about poses:"}};
  return command;
}

/// The format to write: "sdf" for "scene.sdf". If the extension does not tell it, reports this and
/// returns null.
const SceneFormat* choose_format(const Options& options) {
  if (!options.format.empty()) return find_scene_format(options.format);
  if (options.opens && path::extension(options.common.output).empty())
    return find_scene_format("html");
  const std::string extension = path::to_lower(path::extension(options.common.output));
  // Tables and chains are texts under any name.
  const bool is_text = options.compare_dialects || !options.explained.empty();
  if (extension.empty() || is_text) return find_scene_format("json");
  if (extension == ".world") return find_scene_format("sdf");
  if (const SceneFormat* format = find_scene_format(extension.substr(1))) return format;
  complain(kTool,
           "no format has the extension '" + extension + "'; " + std::string(advice_on(extension)));
  return nullptr;
}

/// Standard output counts as the current folder.
std::string output_folder(const Options& options) {
  const std::string& output = options.common.output;
  const bool to_stdout = output.empty() || output == "-";
  return to_stdout ? "." : std::string(path::parent(output));
}

int explain_instance(const LinkedScene& scene, const SourceMap& sources, const Options& options) {
  const auto instance = find_instance(scene, options.explained);
  if (!instance) {
    std::vector<std::string_view> known;
    for (const Instance& each : scene.instances) known.push_back(each.path);
    const auto inner = std::find_if(known.begin(), known.end(), [&](std::string_view path) {
      return path.starts_with(options.explained + "/");
    });
    if (inner != known.end()) {
      complain(kTool, "'" + options.explained +
                          "' is an included scene; name one of its entities, such as '" +
                          std::string(*inner) + "'");
      return kFailed;
    }
    complain(kTool, "the scene has no instance '" + options.explained + "'" +
                        other_instances(options.explained, known));
    return kFailed;
  }
  const Dialect& dialect = *find_dialect(options.dialect);
  const EntityReading reading = dialect.read(scene).entities[to_size(*instance)];
  if (!reading.X_WE) {
    complain(kTool, "'" + options.explained + "' is not in the scene of the dialect " +
                        options.dialect + ", which " + reading.note);
    return kFailed;
  }
  std::optional<std::string> text = describe_chain(scene, sources, *instance, dialect);
  if (!text) {
    complain(kTool, "more than " + std::to_string(kMostSteps) + " transforms lead to '" +
                        options.explained + "', too many to show");
    return kFailed;
  }
  if (!reading.note.empty()) *text += options.dialect + " " + render::escape(reading.note) + "\n";
  return write_output(kTool, options.common.output, *text) ? kDone : kFailed;
}

/// Reports options that exclude each other, and returns false.
bool check_options(const Options& options) {
  const bool is_page = options.format.empty() || options.format == "html";
  if (options.opens && (!is_page || options.compare_dialects || !options.explained.empty())) {
    complain(kTool, "--open shows the page of --format html");
    return false;
  }
  const bool is_scene = options.format == "smurfs";
  if (!options.assets.empty() && (is_scene || options.form == "reference")) {
    complain(kTool, std::string("--copy-assets copies the files that models name, and ") +
                        (is_scene ? "a result of the format smurfs names models only"
                                  : "needs --form expand"));
    return false;
  }
  if (options.dialect == "spec" || !options.compare_dialects) return true;
  complain(kTool, "--compare-dialects cannot be combined with --dialect " + options.dialect);
  return false;
}

bool wants_json(const Options& options) {
  return options.format == "json" || path::extension(options.common.output) == ".json";
}

/// The form to write; if the format does not support it, reports this and returns none.
std::optional<SceneForm> choose_form(const SceneFormat& format, const std::string& asked) {
  if (asked.empty()) return usual_form(format);
  const SceneForm form = asked == "expand" ? SceneForm::expand : SceneForm::reference;
  if (has_form(format, form)) return form;
  complain(kTool, "the format " + std::string(format.name) + " has no form '" + asked + "'");
  return std::nullopt;
}

/// Beside the output, of its name: cell.dmd.yaml has cell_models/. None for standard output.
std::string model_folder(const std::string& output) {
  if (output.empty() || output == "-") return {};
  const std::string_view file = path::file_name(output);
  return std::string(file.substr(0, file.find('.', 1))) + "_models";
}

SceneRequest request_of(const Options& options, const SceneFormat& format, SceneForm form,
                        const std::string& current) {
  SceneRequest request{.format = format,
                       .form = form,
                       .dialect = *find_dialect(options.dialect),
                       .ground = options.ground,
                       .motors = options.motors,
                       .self_collision = options.self_collision,
                       .excludes_overlaps = options.excludes_overlaps,
                       .srdf = options.srdf,
                       .controllers = options.controllers,
                       .links = options.links,
                       .assets = options.assets,
                       .output_folder = output_folder(options),
                       .current_folder = current,
                       .model_folder = model_folder(options.common.output),
                       .packages = options.common.packages,
                       .force = options.common.force,
                       .collisions = options.collisions};
  if (!options.base.empty()) {
    request.base = options.base == "fixed" ? BaseChoice::fixed : BaseChoice::floating;
  }
  return request;
}

/// What options need of a format that it does not have; "" if it has everything.
std::string unmet_need(const Options& options, const SceneFormat& format, SceneForm form) {
  const MotorOptions& motors = options.motors;
  const bool asks_for_motors = !options.controllers.empty() ||
                               motors.kind != MotorKind::as_written || !motors.kp.empty() ||
                               !motors.kv.empty();
  const struct {
    bool is_asked;
    std::string_view words;
    bool SceneFormat::*has;
    bool in_expanded_form = true;
  } needs[] = {
      {options.ground, "--ground needs", &SceneFormat::has_ground},
      {asks_for_motors, "--actuator, --kp, --kv and --controllers need", &SceneFormat::has_motors,
       false},
      {!motors.armature.empty(), "--armature needs", &SceneFormat::has_armatures, false},
      {options.self_collision != SelfCollision::as_usual, "--self-collision needs",
       &SceneFormat::has_contacts},
      {!options.srdf.empty() || options.excludes_overlaps, "--srdf and --exclude-overlaps need",
       &SceneFormat::has_link_pairs},
      {options.collisions.changes_something(), "--collision needs", &SceneFormat::has_collisions}};
  const bool is_expanded = form == SceneForm::expand || !format.has_expanded_form;
  for (const auto& need : needs) {
    if (!need.is_asked) continue;
    const std::string words(need.words);
    if (!(format.*need.has)) return words + " one of the formats " + formats_with(need.has);
    if (need.in_expanded_form && !is_expanded) return words + " --form expand";
  }
  return {};
}

/// What the reader of the written file needs besides it, and what it loses.
std::vector<std::string> remarks_on(const SceneFormat& format, const Options& options,
                                    const SceneResult& result) {
  const std::string& output = options.common.output;
  const std::string title(format.reader != nullptr ? format.reader->title : "");
  const bool replaces = options.collisions.changes_something();
  std::vector<std::string> remarks =
      smurf::tools::remarks_on(result.collisions, result.new_meshes.size(),
                               path::join(path::parent(output), options.collisions.folder));
  if (!result.models.empty() && !replaces) {
    const auto count_of = [&](std::string_view extension) {
      return static_cast<std::size_t>(
          std::count_if(result.models.begin(), result.models.end(), [&](const TextFile& file) {
            return path::extension(file.path) == extension;
          }));
    };
    const std::size_t meshes = count_of(".obj");
    remarks.push_back(
        "copied for " + title +
        ", which does not load the originals: " + counted(count_of(".urdf"), "model") +
        (meshes > 0 ? " with " + counted(meshes, "mesh", "meshes") + " as .obj" : "") + " to " +
        path::join(path::parent(output), model_folder(output)));
  }
  if (!result.lost_by_reader.empty())
    remarks.push_back(title + " " + first_of(result.lost_by_reader));
  if (format.remark.empty()) return remarks;
  constexpr std::string_view kFolder = "FOLDER";
  std::string remark(format.remark);
  const std::string folder(path::parent(output));
  remark.replace(remark.find(kFolder), kFolder.size(), folder.empty() ? "." : folder);
  remarks.push_back(std::move(remark));
  return remarks;
}

/// The models and meshes that are made for the result.
std::vector<OutputFile> made_files(const Options& options, const SceneResult& result) {
  std::vector<OutputFile> files = output_files(output_folder(options), result.models);
  for (OutputFile& mesh : output_files(output_folder(options), result.new_meshes))
    files.push_back(std::move(mesh));
  return files;
}

/// Writes the result and its copies, says so, and opens the page.
ExitCode write_result(const Conversion& conversion, const LoadedScene& loaded,
                      const Options& options, const SceneFormat& format,
                      const SceneResult& result) {
  std::string output = options.common.output;
  const auto write = [&] {
    if (!options.opens || (!output.empty() && output != "-")) {
      return write_output(kTool, output, result.text);
    }
    output = write_temporary_page(kTool, "scene", result.text);
    return !output.empty();
  };
  const auto copy = [&] {
    return copy_files(kTool, result.copies, conversion.files(), options.common.limits,
                      options.overwrite, write);
  };
  if (!write_files(kTool, made_files(options, result), true, copy)) return kFailed;
  if (output.empty() || output == "-" || options.compare_dialects) return kDone;
  const bool copies_nothing = !options.assets.empty() && result.copies.empty();
  conversion.tell_written(output + ": " + counted(loaded.scene.instances.size(), "instance") +
                              " of " + counted(loaded.scene.models.size(), "model") +
                              (result.has_falling_robots ? "; robots fall, see --ground" : "") +
                              (copies_nothing ? "; it names no files to copy" : ""),
                          remarks_on(format, options, result));
  return options.opens && !show_page(kTool, output) ? kFailed : kDone;
}

}  // namespace

int smurfs_flatten_main(int argc, char** argv) {
  prepare_process();
  Options options;
  options.common.has_loss_report = true;
  if (const auto code = parse_command_line(make_command(options), argc, argv)) return *code;

  const SceneFormat* chosen = choose_format(options);
  if (chosen == nullptr || !check_options(options)) return kFailed;
  const SceneFormat& format = *chosen;
  if (const std::string_view why = format.obstacle ? format.obstacle() : ""; !why.empty()) {
    complain(kTool,
             "the format " + std::string(format.name) + " cannot be written: " + std::string(why));
    return kFailed;
  }
  const std::optional<SceneForm> form = choose_form(format, options.form);
  if (!form) return kFailed;
  if (const std::string unmet = unmet_need(options, format, *form); !unmet.empty()) {
    complain(kTool, unmet);
    return kFailed;
  }
  complete(options.collisions, kTool, options.common);
  const auto current = current_folder(kTool);
  if (!current) return kFailed;
  Conversion conversion(kTool, options.common,
                        {InputKind::scene, InputKind::model, InputKind::urdf});
  auto loaded = conversion.load_scene(options.scene);
  if (!loaded) return conversion.fail();
  const bool has_file = !options.controllers.empty() && options.controllers != kNoControllers;
  if (has_file && !conversion.allow(options.controllers)) return conversion.fail();
  if (!options.srdf.empty() && !conversion.load_srdf(options.srdf, *loaded)) {
    return conversion.fail();
  }
  SceneResult result;
  if (options.compare_dialects || !options.explained.empty()) {
    SceneCheck check = check_scene(conversion.session(), *loaded, options.common.force);
    result.report = std::move(check.report);
    result.refusal = std::move(check.refusal);
  } else {
    result =
        convert_scene(conversion.session(), *loaded, request_of(options, format, *form, *current));
  }
  std::vector<std::string> copies = places_of(result.copies, conversion.inputs());
  for (const OutputFile& file : made_files(options, result)) {
    copies.push_back(path::join(file.folder, file.path));
  }
  if (!conversion.keeps_inputs({options.common.output, options.loss_report})) return kFailed;
  if (!keeps_inputs(kTool, conversion.inputs(), copies)) return kFailed;
  const auto loss_of = [&](const Diagnostic& finding) {
    return loss_in_scene(finding, loaded->scene, *loaded->sources);
  };
  const ExitCode verdict = conversion.report(result.report, loss_of, result.refusal);
  if (verdict == kFailed) return kFailed;
  if (result.refusal) return conversion.refuse(result.refusal);
  if (verdict != kDone && !options.common.force) {
    return conversion.refuse(conversion.why() + "; see --force");
  }
  if (!options.explained.empty()) {
    return explain_instance(loaded->scene, *loaded->sources, options);
  }
  if (options.compare_dialects) {
    result.text = compare_dialects(loaded->scene, *loaded->sources, wants_json(options));
  }
  if (!conversion.write_losses(result.losses, options.loss_report)) return kFailed;
  if (options.strict && !result.losses.empty()) return conversion.refuse("has losses");
  return write_result(conversion, *loaded, options, format, result);
}
