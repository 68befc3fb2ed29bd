// SPDX-License-Identifier: BSD-3-Clause
// Makes a SMURF model around a URDF, and proves that it is the same robot.
#include <algorithm>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "conversion/refusal.hpp"
#include "render/printable.hpp"
#include "smurf/conversion.hpp"
#include "smurf/result_losses.hpp"
#include "smurf/write.hpp"

namespace smurf {
namespace {

/// The name of the URDF file. Gazebo calls every robot model.urdf, so a file of that name does not
/// tell robots apart.
std::string usual_name(const LinkedModel& model, bool has_file) {
  std::string stem(has_file ? path::stem(model.urdf_path) : "robot");
  const bool is_xacro = model.language == Language::xacro;
  if (is_xacro && path::to_lower(stem).ends_with(".urdf")) stem = path::stem(stem);
  const std::string lower = path::to_lower(stem);
  const bool is_general = lower == "model" || lower == "robot";
  const bool is_named = model.robot->name && !model.robot->name->empty();
  return render::safe_file_name(is_general && is_named ? *model.robot->name : stem);
}

/// Finds the copies in the output folder and their paths, so that the model can name them.
AssetCopies plan_copies(const LinkedModel& model, const FileReader& files, const Limits& limits,
                        UrdfImport& import) {
  std::set<std::string> sources;
  for (const MeshReference& mesh : model.meshes) {
    sources.insert(path::join(import.current_folder, mesh.path));
  }
  CopyPlan plan(files, limits, import.current_folder, import.output_folder, std::move(sources));
  for (const MeshReference& mesh : model.meshes) {
    if (mesh.path.empty()) continue;
    const auto copy = plan.copy_of(mesh.path, mesh.is_texture ? "textures" : "meshes");
    if (copy) import.copies.emplace(mesh.path, *copy);
  }
  return plan.take();
}

bool has_rule(std::span<const Diagnostic> findings, const Rule& rule) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const Diagnostic& one) { return one.rule == &rule; });
}

/// Counts the errors that belong to the URDF, or to choices of its author; refuses the result
/// because of others.
Refusal judge_result(std::span<const Diagnostic> findings, const SourceMap& sources,
                     const UrdfImport& import, SmurfResult& result) {
  for (const Diagnostic& finding : findings) {
    result.wrong_mimics += finding.rule == &rules::sml3208_mimic_not_by_position;
    if (finding.severity != Severity::error) continue;
    // Problems of MARS with the URDF are reported to the author, but are not faults of the added
    // files.
    if (sources.path(finding.span.source).ends_with(".urdf")) {
      // Copies of meshes do not exist yet, and files missing in the source are already reported.
      if (finding.rule == &rules::sml1604_mesh_missing) continue;
      result.for_mars += !has_rule(result.report.diagnostics, *finding.rule);
      continue;
    }
    if (finding.rule == &rules::sml4103_dead_motor) {
      ++result.dead_motors;
      continue;
    }
    // Collisions for MARS, links for Phobos.
    if (finding.rule == &rules::sml3103_unknown_collision && import.style == SmurfStyle::phobos) {
      continue;
    }
    // Values are those of the URDF, which has no rule against a factor of 0 or 1e308.
    const bool is_about_value = !finding.rule->id.starts_with("SML00");
    return {std::string("the result would have an error") +
            (is_about_value ? "" : ", which is a defect of this tool") + ": " +
            std::string(finding.rule->id) + " " + finding.message +
            (is_about_value ? "; correct the value in the URDF" : "")};
  }
  return {};
}

/// Checks the model before it is written: read again, it must be the same robot, without new
/// errors.
Refusal verify(const LinkedModel& source, const Limits& given, const SmurfRequest& request,
               bool source_is_sound, SmurfResult& result) {
  // Without limits, because the result may be larger than the source, which the user chose.
  Limits limits = given;
  for (const LimitInfo& info : kLimits) {
    limits.*info.value = std::max(limits.*info.value, Limits{}.*info.value);
  }
  Session session(limits);
  const std::string& folder = request.options.output_folder;
  for (const TextFile& file : result.texts) {
    session.set_text(path::join(folder, file.path), file.text);
  }
  CheckSettings settings;
  settings.is_isolated = true;
  settings.opens_meshes = false;
  settings.packages = request.packages;
  LoadedModel written = session.load_model(path::join(folder, result.texts.back().path), settings);
  if (!written.model.robot) {
    return {"the result cannot be read again; this is a defect of this tool"};
  }
  const Proof proof = compare_models(source, written.model);
  if (!proof.holds()) return {"the resulting robot differs: " + proof.difference};
  if (!source_is_sound) return {};
  return judge_result(session.check(written).diagnostics, *written.sources, request.options,
                      result);
}

}  // namespace

SmurfResult convert_to_smurf(Session& session, LoadedModel& loaded, const SmurfRequest& request) {
  const LinkedModel& model = loaded.model;
  SmurfResult result;
  DiagnosticSink before = loaded.found;
  if (model.robot) {
    UrdfImport import = request.options;
    if (import.current_folder.empty()) import.current_folder = folder_of_process();
    if (import.name.empty()) import.name = usual_name(model, request.has_file);
    if (request.copies_meshes) {
      result.copies = plan_copies(model, session.files(), session.limits(), import);
    }
    result.made = import_urdf(model, *loaded.sources, import, loaded.found);
    result.texts = write_smurf(result.made);
  }
  result.report = session.check(loaded);
  loaded.found = std::move(before);
  const std::string why = why_not_converted(result.report.diagnostics, loss_in_model);
  if (!model.robot || (!why.empty() && !request.force)) {
    result.refusal = {why, Refusal::Cause::findings, model.robot.has_value()};
    return result;
  }
  result.refusal = verify(model, session.limits(), request, why.empty(), result);
  return result;
}

}  // namespace smurf
