// SPDX-License-Identifier: BSD-3-Clause
// smurf2urdf: the plain URDF of a SMURF model, checked before it is written.
#include "base/counted.hpp"
#include "base/limits.hpp"
#include "base/path.hpp"
#include "common/converter.hpp"
#include "common/process.hpp"
#include "smurf/confine.hpp"
#include "smurf/convert.hpp"
#include "smurf/result_losses.hpp"

#include "smurf2urdf/options.hpp"
#include "smurf2urdf/verify.hpp"

using namespace smurf;
using namespace smurf::tools;

namespace {

constexpr std::string_view kTool = "smurf2urdf";

/// The nearest folder above the URDF with a package.xml; without one, the folder above urdf/, as in
/// Phobos.
std::string package_folder(const LinkedModel& model, const Options& options) {
  const auto given = options.common.packages.find(options.conversion.package_name);
  const std::string& current = options.conversion.current_folder;
  if (given != options.common.packages.end()) return path::join(current, given->second);
  const DiskFiles disk;
  const std::string urdf_folder(path::parent(path::join(current, model.urdf_path)));
  for (std::string folder = urdf_folder; !is_shared_folder(folder);
       folder = path::join(folder, "..")) {
    if (disk.is_file(path::join(folder, "package.xml"))) return folder;
  }
  return path::join(urdf_folder, "..");
}

/// The reason why the options cannot be applied to this model; "" if they can.
std::string problem_of(const LinkedModel& model, const UrdfExport& options) {
  if (options.base != BaseJoint::as_is) {
    if (model.tree.roots.size() != 1) return "has no single root for --base";
    if (model.link_names.contains("world")) return "has a link `world` already; leave --base out";
  }
  if (options.mesh_uri == MeshUri::package) {
    for (const MeshReference& mesh : model.meshes) {
      const std::string target = path::join(options.current_folder, mesh.path);
      if (!mesh.exists || !path::relative(target, options.package_folder).starts_with("..")) {
        continue;
      }
      return "uses '" + mesh.filename + "', which is outside of the package's folder '" +
             options.package_folder + "'; see --package";
    }
  }
  for (const std::string& name : options.keep) {
    if (!model.link_names.contains(name) && !model.joint_names.contains(name)) {
      return "has no link or joint `" + name + "` to keep" +
             did_you_mean(name, model.link_names.names());
    }
  }
  return {};
}

/// Writes the URDF, and the SRDF if it is requested: both or none.
bool write_result(const Options& options, const std::string& urdf, const LinkedModel& model) {
  const std::string& output = options.common.output;
  if (options.srdf.empty()) return write_output(kTool, output, urdf);
  const std::uint64_t most = options.common.limits.srdf_bytes;
  auto srdf = export_srdf(model, options.conversion.prefix, most);
  if (!srdf) {
    complain(kTool, "so many pairs of links of '" + options.model +
                        "' never collide that the SRDF would have more than " +
                        std::to_string(most) + " bytes; " + raise_limit("srdf-bytes") +
                        "; nothing was written");
    return false;
  }
  std::vector<OutputFile> files = {named_by_user(options.srdf, std::move(*srdf))};
  const bool to_stdout = output.empty() || output == "-";
  if (!to_stdout) files.push_back(named_by_user(output, urdf));
  return write_files(kTool, files, true) && (!to_stdout || write_output(kTool, output, urdf));
}

/// The expansion of a xacro file, as `xacro` prints it.
ExitCode write_expansion(const Options& options, Conversion& conversion) {
  auto loaded = conversion.load_xacro(options.model);
  if (!loaded || !conversion.keeps_inputs({options.common.output})) return kFailed;
  const ExitCode verdict = conversion.report(*loaded, loaded->found.take());
  if (verdict == kFailed) return verdict;
  if (!loaded->expansion.is_complete) return conversion.refuse(conversion.why());
  if (verdict != kDone && !options.common.force) {
    return conversion.refuse(conversion.why() + "; see --force");
  }
  if (options.dry_run) return kDone;
  const std::string urdf(loaded->sources->text(loaded->expansion.source));
  return write_output(kTool, options.common.output, urdf) ? kDone : kFailed;
}

}  // namespace

int smurf2urdf_main(int argc, char** argv) {
  prepare_process();
  Options options;
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

  Conversion conversion(kTool, options.common, {InputKind::model, InputKind::urdf});
  if (xacro::is_xacro_file(options.model) && is_plain(options)) {
    return write_expansion(options, conversion);
  }
  auto loaded = conversion.load_model(options.model);
  if (!loaded) return conversion.fail();
  const LinkedModel& model = loaded->model;
  const SourceMap& sources = *loaded->sources;
  if (!conversion.keeps_inputs({options.common.output, options.srdf, options.loss_report})) {
    return kFailed;
  }
  UrdfExport& wanted = options.conversion;
  const ExitCode verdict = conversion.report(
      *loaded, [&](const Diagnostic& finding) { return loss_in_urdf(finding, model, wanted); });
  if (verdict == kFailed) return kFailed;
  if (!model.robot) {
    return conversion.refuse(verdict == kDone ? "has no URDF" : conversion.why());
  }
  if (verdict != kDone && !options.common.force) {
    return conversion.refuse(conversion.why() + "; see --force");
  }

  if (wanted.mesh_uri == MeshUri::package) wanted.package_folder = package_folder(model, options);
  if (const std::string problem = problem_of(model, wanted); !problem.empty()) {
    return conversion.refuse(problem);
  }
  DiagnosticSink losses;
  report_losses(model, wanted, losses);
  const std::string urdf = export_urdf(model, sources, wanted, losses);
  const Verification verification =
      verify(model, sources, urdf, wanted, may_ask_urdfdom(conversion.findings()));
  if (options.prove) write_error(describe(verification));
  if (!verification.holds()) return conversion.refuse(verification.problem);
  if (!verification.strict_fault.empty() && !options.common.force) {
    return conversion.refuse("cannot be converted: the result would not be XML: " +
                             verification.strict_fault + "; see --force");
  }
  if (!conversion.report_losses(*loaded, losses.take(), options.loss_report,
                                options.fails_on_loss)) {
    return options.fails_on_loss ? conversion.refuse("has losses") : kFailed;
  }
  if (options.dry_run) return kDone;
  if (!write_result(options, urdf, model)) return kFailed;
  const std::string& output = options.common.output;
  if (output.empty() || output == "-") return kDone;
  const std::string text = output + ": " + counted(verification.links, "link") + ", " +
                           counted(verification.joints, "joint");
  std::string lost;
  if (!conversion.lost().empty()) {
    lost = "not in it: " + conversion.lost();
    if (options.loss_report.empty()) lost += ", see --loss-report";
  }
  conversion.tell_written(text, std::span(&lost, lost.empty() ? 0 : 1));
  return kDone;
}
