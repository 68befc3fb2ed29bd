// SPDX-License-Identifier: BSD-3-Clause
// urdf2smurf: a SMURF model around a URDF, checked before it is written.
#include <algorithm>
#include <span>

#include "base/files/path.hpp"
#include "base/text/counted.hpp"
#include "common/cli/process.hpp"
#include "common/convert/converter.hpp"
#include "common/convert/copy_files.hpp"
#include "render/printable.hpp"
#include "smurf/conversion.hpp"
#include "smurf/result_losses.hpp"

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

/// Where the model is written.
std::string folder_of(const Options& options, const LinkedModel& model) {
  const std::string& output = options.common.output;
  return output.empty() ? std::string(path::parent(model.urdf_path)) : output;
}

SmurfRequest request_of(const Options& options, const std::string& folder,
                        const std::string& current, const xml::Document* srdf) {
  return {.options = {.name = options.name,
                      .output_folder = folder,
                      .current_folder = current,
                      .layout = options.in_place ? SmurfLayout::in_place
                                : options.flat   ? SmurfLayout::flat
                                                 : SmurfLayout::phobos,
                      .motors = options.motors,
                      .style = options.style,
                      .srdf = srdf},
          .has_file = options.urdf != "-" || !options.common.stdin_filename.empty(),
          .packages = options.common.packages,
          .copies_meshes = options.copies_meshes,
          .force = options.common.force};
}

ExitCode write_names(const std::vector<std::string>& outputs) {
  std::string names;
  for (const std::string& output : outputs) names += render::escape(output) + "\n";
  return write_output(kTool, {}, names) ? kDone : kFailed;
}

bool write_files_of(const SmurfResult& result, const std::string& folder, const Options& options,
                    const Conversion& conversion) {
  std::vector<OutputFile> written;
  for (const TextFile& file : result.texts) written.push_back({folder, file.path, file.text});
  return copy_files(kTool, result.copies, conversion.files(), options.common.limits,
                    options.overwrite,
                    [&] { return write_files(kTool, written, options.overwrite); });
}

/// Reasons why the robot may not behave as expected.
std::vector<std::string> remarks_on(const LinkedModel& model, const SmurfResult& result,
                                    const std::string& folder, const Options& options) {
  std::vector<std::string> remarks;
  const auto add = [&](std::string remark) { remarks.push_back(std::move(remark)); };
  const std::string on_motors = remark_on_motors(result.made, options.motors, result.dead_motors);
  if (!on_motors.empty()) add(on_motors);
  if (result.wrong_mimics > 0) {
    add(counted(result.wrong_mimics, "motor") +
        " will not mimic as in the URDF, because MARS can do that by position only (SML3208)");
  }
  if (const std::size_t uris = count_uris(model, options, result.copies); uris > 0) {
    add(counted(uris, "mesh path") + (uris == 1 ? " stays a URI" : " stay URIs") +
        ", which MARS does not open: " +
        (options.in_place ? "--in-place does not change the URDF" : "no file was found"));
  }
  if (model.language == Language::xacro) {
    add(path::join(folder, result.made.urdf_path) + " was generated: after a change in " +
        model.urdf_path + ", run urdf2smurf again");
  }
  if (result.for_mars > 0) {
    add("MARS reads the URDF differently (" + counted(result.for_mars, "error") +
        "): see smurf-lint " + path::join(folder, result.texts.back().path));
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
    srdf = conversion.load_srdf(options.srdf, *loaded);
    if (!srdf) return conversion.fail();
  }
  const std::string folder = folder_of(options, model);
  const SmurfResult result =
      convert_to_smurf(conversion.session(), *loaded,
                       request_of(options, folder, *current, srdf ? &*srdf : nullptr));
  std::vector<std::string> outputs = places_of(result.copies, conversion.inputs());
  for (const TextFile& file : result.texts) outputs.push_back(path::join(folder, file.path));
  if (!options.dry_run && !conversion.keeps_inputs(outputs)) return kFailed;
  const Refusal& refusal = result.refusal;
  const ExitCode verdict = conversion.report(result.report, loss_in_model, refusal);
  if (verdict == kFailed) return kFailed;
  if (refusal && refusal.cause == Refusal::Cause::findings) return conversion.refuse(refusal);
  if (verdict != kDone && !options.common.force) {
    return conversion.refuse(conversion.why() + "; see --force");
  }
  if (refusal) return conversion.refuse(refusal);
  if (options.dry_run) return write_names(outputs);
  if (!write_files_of(result, folder, options, conversion)) return kFailed;
  tell(conversion, folder, outputs.size(), describe(result.made, result.copies),
       remarks_on(model, result, folder, options));
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
