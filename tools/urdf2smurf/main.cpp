// SPDX-License-Identifier: BSD-3-Clause
// urdf2smurf: a SMURF model around a URDF, checked before it is written.
#include <algorithm>
#include <span>

#include "base/counted.hpp"
#include "base/path.hpp"
#include "base/rules.hpp"
#include "common/converter.hpp"
#include "common/copy_files.hpp"
#include "common/process.hpp"
#include "render/printable.hpp"
#include "smurf/convert.hpp"
#include "smurf/result_losses.hpp"
#include "smurf/write.hpp"

using namespace smurf;
using namespace smurf::tools;

namespace {

constexpr std::string_view kTool = "urdf2smurf";

struct Options {
  ConverterOptions common;
  std::string urdf;
  std::string name;
  std::string srdf;
  bool in_place = false;
  bool flat = false;
  MotorChoice motors = MotorChoice::declared;
  SmurfStyle style = SmurfStyle::mars;
  bool copies_meshes = false;
  bool overwrite = false;
  bool dry_run = false;
};

std::vector<Option> own_options(Options& options) {
  std::vector<Option> own = {
      {.name = "in-place",
       .help =
           "Leave the URDF where it is and write the SMURF files beside it, or to the folder of "
           "-o. For a xacro file, also write the URDF there.",
       .set = set_flag(options.in_place)},
      {.name = "flat",
       .help = "Write all files into one folder, not into smurf/ and urdf/.",
       .set = set_flag(options.flat)},
      {.name = "name",
       .metavar = "NAME",
       .help =
           "Set the name of the files; the default is the name of the URDF file, or that of the "
           "robot when the file is called model.urdf or robot.urdf, or is standard input.",
       .set = set_text(options.name)},
      {.name = "motors",
       .metavar = "WHICH",
       .help = "Choose the joints that get a motor. declared (the default): joints of "
               "transmissions and ros2_control, and joints that mimic them; all; none.",
       .values = {"declared", "all", "none"},
       .set = choose<MotorChoice>(options.motors, {{"declared", MotorChoice::declared},
                                                   {"all", MotorChoice::all},
                                                   {"none", MotorChoice::none}})},
      {.name = "style",
       .metavar = "WHICH",
       .help = "Choose the form of sections that MARS and Phobos 2 name differently: as mars reads "
               "them (the default), or as phobos writes them.",
       .values = {"mars", "phobos"},
       .set = choose<SmurfStyle>(options.style,
                                 {{"mars", SmurfStyle::mars}, {"phobos", SmurfStyle::phobos}})},
      {.name = "srdf",
       .metavar = "FILE",
       .help = "Read named joint positions from an SRDF, and keep its text.",
       .set = set_text(options.srdf)},
      {.name = "copy-meshes",
       .help =
           "Copy the meshes and textures into meshes/ and textures/ of the folder, and refer to "
           "the copies. Files outside of the project are copied only with --allow-outside.",
       .set = set_flag(options.copies_meshes)},
      {.name = "force",
       .help = "Convert despite errors, as long as the URDF can be read.",
       .set = set_flag(options.common.force)},
      {.name = "overwrite",
       .help = "Replace files that exist.",
       .set = set_flag(options.overwrite)},
      {.name = "dry-run",
       .help = "Run all checks, write nothing; list the files on standard output.",
       .set = set_flag(options.dry_run)}};
  for (Option& option : own) option.group = "Conversion";
  return own;
}

Command make_command(Options& options) {
  Command command;
  command.name = kTool;
  command.summary =
      "Makes a SMURF model around a URDF: motors from transmissions and ros2_control, sensors from "
      "Gazebo sensors, materials from colours.";
  command.operands = "URDF [NAME:=VALUE]...";
  command.details =
      "Writes DIR/smurf/NAME.smurf, DIR/smurf/NAME_*.yml and DIR/urdf/NAME.urdf. When it fails, "
      "it writes none of them. The URDF is kept complete; parts without a section in SMURF are "
      "kept as text, so nothing is lost. URDF is a file or a folder with one URDF. A URDF is "
      "refused when its links and joints do not form a valid robot, or when a value cannot be "
      "read; its other errors are counted, and smurf-lint shows them. A .xacro file is expanded "
      "first, with the arguments NAME:=VALUE; the model lists the URDF that is made of it.";
  command.options = converter_options(options.common, "Write into the folder DIR.");
  for (Option& option : command.options) {
    if (option.name == "output") option.metavar = "DIR";
  }
  for (Option& option : own_options(options)) command.options.push_back(std::move(option));
  command.set_operand = take_one_operand(options.urdf, options.common.xacro);
  command.examples = {
      {"urdf2smurf robot.urdf -o robot", "Make a folder with the layout of Phobos:"},
      {"urdf2smurf robot.urdf --copy-meshes -o robot", "Copy the meshes into the folder:"},
      {"urdf2smurf robot.urdf --in-place", "Put the SMURF files beside the URDF:"},
      {"urdf2smurf robot.urdf.xacro side:=left -o robot", "Make a model of a xacro file:"},
      {"python3 make_robot.py | urdf2smurf - --name robot -o robot",
       "Read the URDF from another program:"}};
  return command;
}

/// An error message about the combination of options; empty if there is none.
std::string problem_of(const Options& options) {
  if (options.in_place && options.flat) return "--flat and --in-place exclude each other";
  if (options.in_place && options.copies_meshes) {
    return "--copy-meshes and --in-place exclude each other: the URDF stays as it is";
  }
  if (options.in_place && options.urdf == "-") return "--in-place needs a file, not standard input";
  if (!options.in_place && options.common.output.empty()) {
    return "say where to write with -o DIR, or use --in-place";
  }
  if (options.common.output == "-")
    return "a model consists of several files, so -o must name a folder";
  if (options.name.find('/') != std::string::npos || options.name == "." || options.name == "..") {
    return "--name is a file name without a folder";
  }
  return {};
}

/// Gazebo calls every robot model.urdf, so a file of that name does not tell robots apart.
bool is_general(std::string_view stem) {
  const std::string name = path::to_lower(stem);
  return name == "model" || name == "robot";
}

std::string file_name_of(const Options& options, const LinkedModel& model) {
  if (!options.name.empty()) return options.name;
  const bool has_file = options.urdf != "-" || !options.common.stdin_filename.empty();
  std::string stem(has_file ? path::stem(model.urdf_path) : "robot");
  const bool is_xacro = xacro::is_xacro_file(model.urdf_path);
  if (is_xacro && path::to_lower(stem).ends_with(".urdf")) stem = path::stem(stem);
  const bool is_named = model.robot && model.robot->name && !model.robot->name->empty();
  return render::safe_file_name(is_general(stem) && is_named ? *model.robot->name : stem);
}

/// Everything that will be written.
struct Plan {
  std::string folder;
  NewModel made;
  std::vector<TextFile> texts;
  AssetCopies copies;
  std::vector<std::string> outputs;
};

struct Verification {
  std::string problem;           ///< why the model must not be written; empty if it may be
  std::size_t dead_motors = 0;   ///< joints without a limit of speed or effort, such as wheels
  std::size_t wrong_mimics = 0;  ///< motors that follow one of another kind of command
  std::size_t for_mars = 0;      ///< errors of the URDF that occur only in models
};

bool has_rule(std::span<const Diagnostic> findings, const Rule& rule) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const Diagnostic& one) { return one.rule == &rule; });
}

/// Checks the model before it is written: read again, it must be the same robot, without new
/// errors.
Verification verify(const LinkedModel& source, std::span<const Diagnostic> known, const Plan& plan,
                    const Options& options, bool source_is_sound) {
  // Without limits, because the result may be larger than the source, which the user chose.
  Limits limits = options.common.limits;
  for (const LimitInfo& info : kLimits) {
    limits.*info.value = std::max(limits.*info.value, Limits{}.*info.value);
  }
  Session session(limits);
  for (const TextFile& file : plan.texts) {
    session.set_text(path::join(plan.folder, file.path), file.text);
  }
  CheckSettings settings;
  settings.is_isolated = true;
  settings.opens_meshes = false;
  settings.packages = options.common.packages;
  LoadedModel written =
      session.load_model(path::join(plan.folder, plan.texts.back().path), settings);
  const LinkedModel& result = written.model;
  if (!result.robot) return {"the result cannot be read again; this is a defect of this tool"};
  const Proof proof = compare_models(source, result);
  if (!proof.holds()) return {"the resulting robot differs: " + proof.difference};
  Verification verification;
  if (!source_is_sound) return verification;
  for (const Diagnostic& diagnostic : session.check(written).diagnostics) {
    verification.wrong_mimics += diagnostic.rule == &rules::sml3208_mimic_not_by_position;
    if (diagnostic.severity != Severity::error) continue;
    // Problems of MARS with the URDF are reported to the author, but are not faults of the added
    // files.
    if (written.sources->path(diagnostic.span.source).ends_with(".urdf")) {
      // Copies of meshes do not exist yet, and files missing in the source are already reported.
      if (diagnostic.rule == &rules::sml1604_mesh_missing) continue;
      verification.for_mars += !has_rule(known, *diagnostic.rule);
      continue;
    }
    if (diagnostic.rule == &rules::sml4103_dead_motor) {
      ++verification.dead_motors;
      continue;
    }
    // Collisions for MARS, links for Phobos.
    if (diagnostic.rule == &rules::sml3103_unknown_collision &&
        options.style == SmurfStyle::phobos) {
      continue;
    }
    // Values are those of the URDF, which has no rule against a factor of 0 or 1e308.
    const bool is_about_value = !diagnostic.rule->id.starts_with("SML00");
    return {std::string("the result would have an error") +
            (is_about_value ? "" : ", which is a defect of this tool") + ": " +
            std::string(diagnostic.rule->id) + " " + diagnostic.message +
            (is_about_value ? "; correct the value in the URDF" : "")};
  }
  return verification;
}

/// Finds the copies in `folder` and their paths, so that the model can name them.
AssetCopies plan_copies(const LinkedModel& model, const std::string& folder,
                        const FileReader& files, const Limits& limits, UrdfImport& import) {
  std::set<std::string> sources;
  for (const MeshReference& mesh : model.meshes) {
    sources.insert(path::join(import.current_folder, mesh.path));
  }
  CopyPlan plan(files, limits, import.current_folder, folder, std::move(sources));
  for (const MeshReference& mesh : model.meshes) {
    if (mesh.path.empty()) continue;
    const auto copy = plan.copy_of(mesh.path, mesh.is_texture ? "textures" : "meshes");
    if (copy) import.copies.emplace(mesh.path, *copy);
  }
  return plan.take();
}

/// "3 materials, 7 joints", by sections.
std::string describe(const NewModel& made, const AssetCopies& copies) {
  std::string text;
  const auto add = [&](std::size_t number, std::string noun) {
    std::replace(noun.begin(), noun.end(), '_', ' ');
    if (noun.ends_with('s')) noun.pop_back();
    text += (text.empty() ? "" : ", ") + counted(number, noun);
  };
  for (const NewFile& file : made.files) add(file.section.children.size(), file.suffix);
  if (!copies.empty()) add(copies.size(), "copied file");
  return text;
}

/// Remarks about missing motors: without motors, or with motors without speed or effort, a robot
/// does not move.
std::string remark_on_motors(const NewModel& made, MotorChoice choice, std::size_t dead_motors) {
  if (dead_motors > 0) {
    return counted(dead_motors, "motor value") +
           " missing, which MARS reads as 0 (SML4103): the joints have no `velocity` or `effort`";
  }
  const bool has_motors = std::any_of(made.files.begin(), made.files.end(),
                                      [](const NewFile& file) { return file.suffix == "motors"; });
  if (has_motors || choice == MotorChoice::none) return {};
  if (choice == MotorChoice::all) return "no motors: the robot has no movable joint";
  return "no motors: no transmission or ros2_control of the URDF drives a joint; see --motors all";
}

/// "wrote 4 files to kuka/: 2 materials, 7 joints", and the remarks below it.
void tell(const Conversion& conversion, const std::string& folder, std::size_t files,
          const std::string& content, std::span<const std::string> remarks) {
  const bool is_here = folder.empty();
  std::string text = counted(files, "file") + " to " + (is_here ? "this folder" : folder);
  if (!is_here && !folder.ends_with('/')) text += "/";
  if (!content.empty()) text += ": " + content;
  conversion.tell_written(text, remarks);
}

/// Counts the mesh paths that MARS cannot open, because it does not resolve `package://`.
std::size_t count_uris(const LinkedModel& model, const Options& options,
                       const AssetCopies& copies) {
  if (!copies.empty()) return 0;
  return static_cast<std::size_t>(
      std::count_if(model.meshes.begin(), model.meshes.end(), [&](const MeshReference& mesh) {
        const bool is_uri = mesh.filename.find("://") != std::string::npos;
        return is_uri && (options.in_place || mesh.path.empty() || !mesh.exists);
      }));
}

Plan make_plan(const Options& options, const std::string& current, const LoadedModel& loaded,
               const xml::Document* srdf, DiagnosticSink& found, const Conversion& conversion) {
  const LinkedModel& model = loaded.model;
  Plan plan;
  plan.folder = !options.common.output.empty() ? options.common.output
                                               : std::string(path::parent(model.urdf_path));
  if (model.robot) {
    UrdfImport import{.name = file_name_of(options, model),
                      .output_folder = plan.folder,
                      .current_folder = current,
                      .layout = options.in_place ? SmurfLayout::in_place
                                : options.flat   ? SmurfLayout::flat
                                                 : SmurfLayout::phobos,
                      .motors = options.motors,
                      .style = options.style,
                      .srdf = srdf};
    if (options.copies_meshes) {
      plan.copies =
          plan_copies(model, plan.folder, conversion.files(), options.common.limits, import);
    }
    plan.made = import_urdf(model, *loaded.sources, import, found);
    plan.texts = write_smurf(plan.made);
  }
  plan.outputs = places_of(plan.copies, conversion.inputs());
  for (const TextFile& file : plan.texts) {
    plan.outputs.push_back(path::join(plan.folder, file.path));
  }
  return plan;
}

ExitCode write_names(const Plan& plan) {
  std::string names;
  for (const std::string& output : plan.outputs) names += render::escape(output) + "\n";
  return write_output(kTool, {}, names) ? kDone : kFailed;
}

bool write_plan(const Plan& plan, const Options& options, const Conversion& conversion) {
  std::vector<OutputFile> written;
  for (const TextFile& file : plan.texts) written.push_back({plan.folder, file.path, file.text});
  return copy_files(kTool, plan.copies, conversion.files(), options.common.limits,
                    options.overwrite,
                    [&] { return write_files(kTool, written, options.overwrite); });
}

/// Reasons why the robot may not behave as expected.
std::vector<std::string> remarks_on(const LinkedModel& model, const Plan& plan,
                                    const Options& options, const Verification& verification) {
  std::vector<std::string> remarks;
  const auto add = [&](std::string remark) { remarks.push_back(std::move(remark)); };
  const std::string on_motors =
      remark_on_motors(plan.made, options.motors, verification.dead_motors);
  if (!on_motors.empty()) add(on_motors);
  if (verification.wrong_mimics > 0) {
    add(counted(verification.wrong_mimics, "motor") +
        " will not mimic as in the URDF, because MARS can do that by position only (SML3208)");
  }
  if (const std::size_t uris = count_uris(model, options, plan.copies); uris > 0) {
    add(counted(uris, "mesh path") + (uris == 1 ? " stays a URI" : " stay URIs") +
        ", which MARS does not open: " +
        (options.in_place ? "--in-place does not change the URDF" : "no file was found"));
  }
  if (xacro::is_xacro_file(model.urdf_path)) {
    add(path::join(plan.folder, plan.made.urdf_path) + " was generated: after a change in " +
        model.urdf_path + ", run urdf2smurf again");
  }
  if (verification.for_mars > 0) {
    add("MARS reads the URDF differently (" + counted(verification.for_mars, "error") +
        "): see smurf-lint " + path::join(plan.folder, plan.texts.back().path));
  }
  return remarks;
}

ExitCode convert(Conversion& conversion, const Options& options) {
  const auto current = current_folder(kTool);
  if (!current) return kFailed;
  auto loaded = conversion.load_model(options.urdf);
  if (!loaded) return conversion.fail();
  const LinkedModel& model = loaded->model;
  if (model.urdf_path.empty() || model.has_main) {
    complain(kTool, "'" + options.urdf + "' is not a URDF");
    return kFailed;
  }
  std::optional<xml::Document> srdf;
  if (!options.srdf.empty()) {
    srdf = conversion.load_xml(options.srdf, *loaded);
    if (!srdf) return conversion.fail();
  }
  const Plan plan =
      make_plan(options, *current, *loaded, srdf ? &*srdf : nullptr, loaded->found, conversion);
  if (!options.dry_run && !conversion.keeps_inputs(plan.outputs)) return kFailed;
  const Report report = conversion.session().check(*loaded);
  const ExitCode verdict = conversion.report(report, loss_in_model);
  if (verdict == kFailed) return kFailed;
  if (!model.robot) return conversion.refuse(conversion.why());
  if (verdict != kDone && !options.common.force) {
    return conversion.refuse(conversion.why() + "; see --force");
  }
  const Verification verification =
      verify(model, report.diagnostics, plan, options, verdict == kDone);
  if (!verification.problem.empty()) return conversion.refuse(verification.problem);
  if (options.dry_run) return write_names(plan);
  if (!write_plan(plan, options, conversion)) return kFailed;
  tell(conversion, plan.folder, plan.outputs.size(), describe(plan.made, plan.copies),
       remarks_on(model, plan, options, verification));
  return kDone;
}

}  // namespace

int urdf2smurf_main(int argc, char** argv) {
  prepare_process();
  Options options;
  if (const auto code = parse_command_line(make_command(options), argc, argv)) return *code;
  if (const std::string problem = problem_of(options); !problem.empty()) {
    complain(kTool, problem);
    return kFailed;
  }
  Conversion conversion(kTool, options.common, {InputKind::urdf});
  return convert(conversion, options);
}
