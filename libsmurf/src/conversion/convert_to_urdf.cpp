// SPDX-License-Identifier: BSD-3-Clause
// Checks a model, exports its URDF, and proves that it is the same robot.
#include <algorithm>
#include <utility>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/did_you_mean.hpp"
#include "conversion/mesh_copies.hpp"
#include "conversion/reader_verdict.hpp"
#include "conversion/refusal.hpp"
#include "conversion/replaced_collisions.hpp"
#include "smurf/confine.hpp"
#include "smurf/conversion.hpp"
#include "smurf/load.hpp"
#include "smurf/result_losses.hpp"

namespace smurf {
namespace {

/// The nearest folder above the URDF with a package.xml; without one, the folder above urdf/, as in
/// Phobos.
std::string package_folder(const LinkedModel& model, const UrdfRequest& request,
                           const std::string& current) {
  const auto given = request.packages.find(request.options.package_name);
  if (given != request.packages.end()) return path::join(current, given->second);
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

/// A URDF read on its own.
struct Plain {
  SourceMap sources;
  DiagnosticSink sink;
  LinkedModel model;

  Plain(std::string_view urdf, const Limits& limits) {
    MemoryFiles files;
    files.add("plain.urdf", std::string(urdf));
    LoadContext context{sources, files, sink, limits, {}};
    model = load_model("plain.urdf", context);
  }

  /// If options change mimics, all joints are compared as independent joints.
  void forget_mimics() {
    if (!model.robot) return;
    for (urdf::Joint& joint : model.robot->joints) joint.mimic.reset();
  }
};

Proof compare(const LinkedModel& model, const SourceMap& sources, Plain& plain,
              const UrdfExport& options, const Limits& limits) {
  if (!options.apply.mimic) return compare_models(model, plain.model, proof_scope(options));
  Plain source(sources.text(model.robot->document.source), limits);
  source.model.annotations.materials = model.annotations.materials;
  source.forget_mimics();
  plain.forget_mimics();
  return compare_models(source.model, plain.model, proof_scope(options));
}

/// A prefix of the result that nothing declares; "" if there is none. Other rules than SML1002
/// report elements of xacro and of XInclude.
std::string undeclared_prefix(const Plain& plain, std::string_view urdf) {
  for (const Diagnostic& one : plain.sink.diagnostics()) {
    if (one.rule != &rules::sml1002_xml_undeclared_prefix) continue;
    return std::string(plain.sources.text(one.span));
  }
  for (const std::string_view prefix : {"xacro", "xi"}) {
    if (urdf.find("xmlns:" + std::string(prefix)) != urdf.npos) continue;
    for (const xml::Element& element : plain.model.robot->document.elements) {
      const std::string_view name = element.name();
      if (name.starts_with(prefix) && name.substr(prefix.size()).starts_with(':')) {
        return std::string(prefix);
      }
    }
  }
  return {};
}

/// Why readers of strict XML refuse the result; "" if they do not.
std::string fault_in_text(const Plain& plain, std::string_view urdf) {
  const std::string fault = why_strict_readers_refuse(plain.model, urdf);
  if (!fault.empty()) return "the result would not be XML: " + fault;
  const std::string prefix = undeclared_prefix(plain, urdf);
  if (prefix.empty()) return {};
  return "XML readers with namespaces, such as browsers, refuse the result, because the prefix `" +
         prefix + "` is not declared; declare it, `<robot xmlns:" + prefix +
         "=\"...\">`, or remove such elements";
}

/// Reads the result again and compares it with its source. `fault` becomes what readers of strict
/// XML refuse.
Refusal reread(const LinkedModel& model, const SourceMap& sources, const UrdfExport& options,
               const UrdfRequest& request, const Limits& limits, UrdfResult& result,
               std::string& fault) {
  UrdfProof& proof = *result.proof;
  Plain plain(result.text, limits);
  if (!plain.model.robot) return {"the result cannot be read again; this is a defect of this tool"};
  proof.links = plain.model.robot->links.size();
  proof.joints = plain.model.robot->joints.size();
  if (request.referees.tinyxml2 != nullptr) {
    proof.tinyxml2_accepts =
        request.referees.tinyxml2(plain.model.robot->document, plain.sources, plain.sink);
    if (!proof.tinyxml2_accepts) return {"tinyxml2: " + plain.sink.diagnostics().back().message};
  }
  fault = fault_in_text(plain, result.text);
  proof.comparison = compare(model, sources, plain, options, limits);
  if (proof.comparison.holds()) return {};
  return {"the exported robot differs: " + proof.comparison.difference};
}

/// Proves the result, also by urdfdom, which crashes on some texts. What was read again is freed
/// before, because urdfdom needs twice as much memory.
Refusal prove(const LinkedModel& model, const SourceMap& sources, const UrdfExport& options,
              const UrdfRequest& request, const Limits& limits, bool may_ask_urdfdom,
              UrdfResult& result) {
  UrdfProof& proof = result.proof.emplace();
  std::string fault;
  if (Refusal refusal = reread(model, sources, options, request, limits, result, fault)) {
    return refusal;
  }
  // urdfdom before 5.1 refuses every version but 1.0.
  const bool is_known = options.version.empty() || options.version == "1.0";
  if (may_ask_urdfdom && is_known && request.referees.urdfdom != nullptr) {
    proof.urdfdom = request.referees.urdfdom(result.text);
    if (proof.urdfdom.was_asked && !proof.urdfdom.accepts) {
      const std::string& words = proof.urdfdom.messages;
      return {"urdfdom refuses the result: " + words.substr(0, words.find('\n'))};
    }
  }
  if (fault.empty() || request.force) return {};
  return {"cannot be converted: " + fault, Refusal::Cause::result, true};
}

/// The path of a file of the result.
std::string in_output(const UrdfExport& options, const std::string& file) {
  return path::normalize(
      path::join(path::join(options.current_folder, options.output_folder), file));
}

/// Asks the reader that the result is for, with the copies of meshes in place.
Refusal judge(const FileReader& files, const UrdfRequest& request, const UrdfExport& wanted,
              const Limits& limits, UrdfResult& result) {
  MemoryFiles with_result(&files);
  const std::string file = in_output(wanted, request.file_name);
  with_result.add(file, result.text);
  for (const std::vector<TextFile>* meshes : {&result.meshes, &result.new_meshes}) {
    for (const TextFile& mesh : *meshes) with_result.add(in_output(wanted, mesh.path), mesh.text);
  }
  ReaderVerdict verdict = verdict_on(file, *request.reader, with_result, limits, request.packages);
  const std::string title(request.reader->title);
  result.lost_by_reader = std::move(verdict.lost);
  if (verdict.refused.empty()) return {};
  if (request.force) {
    result.lost_by_reader.insert(result.lost_by_reader.begin(), verdict.refused.begin(),
                                 verdict.refused.end());
    return {};
  }
  const std::string advice = request.mesh_folder.empty()
                                 ? "; with -o FILE, meshes are copied to formats that it reads"
                                 : "";
  return {"cannot be converted: " + title + " " + first_of(verdict.refused) + advice,
          Refusal::Cause::result, true};
}

/// Writes and proves the URDF. `files` also has the new meshes of collisions.
void write(const LoadedModel& loaded, const UrdfRequest& request, UrdfExport& wanted,
           const FileReader& files, const Limits& limits, bool may_ask, DiagnosticSink& losses,
           UrdfResult& result) {
  const LinkedModel& model = loaded.model;
  if (wanted.mesh_uri == MeshUri::package && wanted.package_folder.empty()) {
    wanted.package_folder = package_folder(model, request, wanted.current_folder);
  }
  result.refusal = {problem_of(model, wanted), Refusal::Cause::options};
  if (result.refusal) return;
  if (request.reader != nullptr && !request.mesh_folder.empty()) {
    MeshCopies copies = copies_for(*request.reader, model, files, limits);
    for (const auto& [mesh, copy] : copies.names) {
      wanted.mesh_copies.emplace(mesh, path::join(request.mesh_folder, copy));
    }
    result.meshes = std::move(copies.files);
    for (TextFile& mesh : result.meshes) mesh.path = path::join(request.mesh_folder, mesh.path);
  }
  report_losses(model, wanted, losses);
  result.text = export_urdf(model, *loaded.sources, wanted, losses);
  result.refusal = prove(model, *loaded.sources, wanted, request, limits, may_ask, result);
  if (!result.refusal && request.reader != nullptr) {
    result.refusal = judge(files, request, wanted, limits, result);
  }
}

}  // namespace

UrdfResult convert_to_urdf(Session& session, LoadedModel& loaded, const UrdfRequest& request) {
  const LinkedModel& model = loaded.model;
  UrdfExport wanted = request.options;
  if (wanted.current_folder.empty()) wanted.current_folder = folder_of_process();
  UrdfResult result;
  result.report = session.check(loaded);
  const std::vector<Diagnostic> found = result.report.diagnostics;
  result.refusal = refusal_for(found, request.force, [&](const Diagnostic& finding) {
    return loss_in_urdf(finding, model, wanted);
  });
  if (!model.robot) {
    if (!result.refusal) result.refusal = {"has no URDF", Refusal::Cause::findings};
    result.refusal.can_be_forced = false;
  }
  if (result.refusal) return result;
  const DiagnosticSink before = loaded.found;
  ReplacedCollisions replaced(session, loaded, request.collisions,
                              {.output_folder = wanted.output_folder,
                               .current_folder = wanted.current_folder,
                               .makes_names = true,
                               .has_capsules = false});
  LinkedModel* const models[] = {&loaded.model};
  result.refusal = replaced.apply(models);
  if (result.refusal) return result;
  result.new_meshes = replaced.take_meshes();
  DiagnosticSink losses;
  write(loaded, request, wanted, replaced.files(), session.limits(), may_ask_urdfdom(found), losses,
        result);
  std::vector<Diagnostic> lost = replaced.placed(losses.take());
  replaced.restore();
  result.collisions = replaced.take_collisions();
  result.losses = session.settle(loaded, std::move(lost));
  // Its findings are those of loading, and what became of the collisions.
  if (request.collisions.changes_something()) result.report = session.check(loaded);
  loaded.found = before;
  return result;
}

}  // namespace smurf
