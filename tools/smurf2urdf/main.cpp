// SPDX-License-Identifier: BSD-3-Clause
// smurf2urdf: the plain URDF of a SMURF model, checked before it is written.
#include <algorithm>

#include "base/files/path.hpp"
#include "base/findings/limits.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "common/cli/process.hpp"
#include "common/convert/collision_options.hpp"
#include "common/convert/converter.hpp"
#include "smurf/conversion.hpp"
#include "smurf/result_losses.hpp"
#include "smurf2urdf/options.hpp"

using namespace smurf;
using namespace smurf::tools;

namespace {

constexpr std::string_view kTool = "smurf2urdf";

/// The figures of the comparison, one per line.
std::string describe(const UrdfProof& verification) {
  const Proof& proof = verification.comparison;
  const auto line = [](std::string_view what, double figure, std::string_view unit) {
    return std::string(what) + format_rounded(figure) + std::string(unit) + "\n";
  };
  std::string text = "compared " + std::to_string(proof.links) + " links at " +
                     std::to_string(proof.joint_positions) + " joint positions\n";
  text += line("  largest distance of a link  ", proof.position, " m");
  text += line("  largest angle of a link     ", proof.angle, " rad");
  text += line("  total mass                  ", proof.mass, " relative");
  text += line("  centre of mass              ", proof.center_of_mass, " m");
  text += line("  inertia                     ", proof.inertia, " relative");
  text += line("  joint limits                ", proof.limits, " relative");
  const auto verdict = [](bool accepts) { return accepts ? "accepts\n" : "refuses\n"; };
  text += std::string("  tinyxml2                    ") + verdict(verification.tinyxml2_accepts);
  text += "  urdfdom                     ";
  if (!verification.urdfdom.was_asked) return text + "not asked\n";
  return text + verdict(verification.urdfdom.accepts);
}

/// Writes the URDF, and the SRDF if it is requested: both or none.
bool write_result(const ExportOptions& options, const UrdfResult& result,
                  const LinkedModel& model) {
  const std::string& output = options.common.output;
  const std::string& urdf = result.text;
  const bool to_stdout = output.empty() || output == "-";
  std::vector<OutputFile> files = output_files(options.conversion.output_folder, result.meshes);
  for (OutputFile& mesh : output_files(options.conversion.output_folder, result.new_meshes))
    files.push_back(std::move(mesh));
  std::optional<std::string> srdf;
  if (!options.srdf.empty()) {
    const std::uint64_t most = options.common.limits.srdf_bytes;
    srdf = export_srdf(model, options.conversion.prefix, most);
    if (!srdf) {
      complain(kTool, "so many pairs of links of '" + options.model +
                          "' never collide that the SRDF would have more than " +
                          std::to_string(most) + " bytes; " + raise_limit("srdf-bytes") +
                          "; nothing was written");
      return false;
    }
    files.push_back(named_by_user(options.srdf, *srdf));
    if (!to_stdout) files.push_back(named_by_user(output, urdf));
  }
  const auto write = [&] { return (srdf && !to_stdout) || write_output(kTool, output, urdf); };
  return write_files(kTool, files, true, write);
}

bool is_file(const std::string& output) { return !output.empty() && output != "-"; }

std::string file_name(const std::string& output) {
  return is_file(output) ? std::string(path::file_name(output)) : "robot.urdf";
}

/// Beside the output, of its name: arm.urdf has arm_meshes/. None for standard output.
std::string mesh_folder(const std::string& output) {
  if (!is_file(output)) return {};
  const std::string file(path::file_name(output));
  return file.substr(0, file.size() - path::extension(file).size()) + "_meshes";
}

std::size_t copied_meshes(const UrdfResult& result) {
  return static_cast<std::size_t>(
      std::count_if(result.meshes.begin(), result.meshes.end(),
                    [](const TextFile& file) { return file.path.ends_with(".obj"); }));
}

/// The expansion of a xacro file, as `xacro` prints it.
ExitCode write_expansion(const ExportOptions& options, Conversion& conversion) {
  auto loaded = conversion.load_xacro(options.model);
  if (!loaded || !conversion.keeps_inputs({options.common.output})) return kFailed;
  const ExitCode verdict = conversion.report(*loaded, loaded->found.take());
  if (verdict == kFailed) return verdict;
  if (!loaded->expansion.is_complete) return conversion.refuse(conversion.why());
  if (verdict != kDone && !options.common.force) {
    return conversion.refuse(conversion.why() + "; see --force");
  }
  if (options.dry_run) return kDone;
  const std::string_view urdf = loaded->sources->text(loaded->expansion.source);
  return write_output(kTool, options.common.output, urdf) ? kDone : kFailed;
}

}  // namespace

int smurf2urdf_main(int argc, char** argv) {
  prepare_process();
  ExportOptions options;
  options.common.has_loss_report = true;
  if (const auto code = parse_command_line(make_command(options), argc, argv)) return *code;
  if (!options.shown_preset.empty()) {
    return write_output(kTool, {}, preset_text(options.shown_preset)) ? kDone : kFailed;
  }
  if (const std::string problem = problem_of(options); !problem.empty()) {
    complain(kTool, problem);
    return kFailed;
  }
  const auto current = current_folder(kTool);
  if (!current) return kFailed;
  options.conversion.current_folder = *current;
  complete(options.collisions, kTool, options.common);

  Conversion conversion(kTool, options.common, {InputKind::model, InputKind::urdf});
  if (xacro::is_xacro_file(options.model) && is_plain(options)) {
    return write_expansion(options, conversion);
  }
  auto loaded = conversion.load_model(options.model);
  if (!loaded) return conversion.fail();
  const LinkedModel& model = loaded->model;
  if (!conversion.keeps_inputs({options.common.output, options.srdf, options.loss_report})) {
    return kFailed;
  }
  const UrdfExport& wanted = options.conversion;
  const UrdfResult result = convert_to_urdf(conversion.session(), *loaded,
                                            {.options = wanted,
                                             .packages = options.common.packages,
                                             .force = options.common.force,
                                             .referees = all_referees(),
                                             .reader = options.reader,
                                             .mesh_folder = mesh_folder(options.common.output),
                                             .file_name = file_name(options.common.output),
                                             .collisions = options.collisions});
  const auto loss_of = [&](const Diagnostic& finding) {
    return loss_in_urdf(finding, model, wanted);
  };
  const Refusal& refusal = result.refusal;
  const ExitCode verdict = conversion.report(result.report, loss_of, refusal);
  if (verdict == kFailed) return kFailed;
  if (refusal && refusal.cause == Refusal::Cause::findings) return conversion.refuse(refusal);
  if (verdict != kDone && !options.common.force) {
    return conversion.refuse(conversion.why() + "; see --force");
  }
  if (options.prove && result.proof) write_error(describe(*result.proof));
  if (refusal) return conversion.refuse(refusal);
  if (!conversion.write_losses(result.losses, options.loss_report)) return kFailed;
  if (options.fails_on_loss && !result.losses.empty()) {
    return conversion.refuse_losses(result.losses);
  }
  if (options.dry_run) return kDone;
  if (!write_result(options, result, model)) return kFailed;
  const std::string& output = options.common.output;
  if (output.empty() || output == "-") return kDone;
  const std::string text = output + ": " + counted(result.proof->links, "link") + ", " +
                           counted(result.proof->joints, "joint");
  std::string lost = count_by_section(result.losses);
  if (!lost.empty()) {
    lost = "not in it: " + lost;
    if (options.loss_report.empty()) lost += ", see --loss-report";
  }
  std::vector<std::string> remarks =
      remarks_on(result.collisions, result.new_meshes.size(),
                 path::join(wanted.output_folder, options.collisions.folder));
  if (!lost.empty()) remarks.push_back(lost);
  if (!result.meshes.empty()) {
    remarks.push_back("copied as OBJ: " + counted(copied_meshes(result), "mesh", "meshes") +
                      " to " + path::join(wanted.output_folder, mesh_folder(output)));
  }
  if (!result.lost_by_reader.empty()) {
    remarks.push_back(std::string(options.reader->title) + " " + first_of(result.lost_by_reader));
  }
  conversion.tell_written(text, remarks);
  return kDone;
}
