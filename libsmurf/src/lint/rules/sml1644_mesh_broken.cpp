// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <vector>

#include "base/files/standard_input.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/uncertain.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1644_mesh_broken_file {
namespace {

constexpr Circumstance kEmptyCollada{"empty COLLADA"};
constexpr Circumstance kEmptyObj{"empty OBJ"};

Diagnostic& report(const MeshReference& reference, std::string_view what, Findings& findings) {
  Diagnostic& diagnostic =
      findings.report(reference.span, (reference.is_texture ? "the texture" : "the mesh") +
                                          std::string(" cannot be read: ") + std::string(what));
  if (reference.is_texture) diagnostic.severity = Severity::warning;
  return diagnostic;
}

/// " (line 3)". Most defects of a glTF have no place.
std::string place(const MeshFile& file, std::uint32_t line, std::uint64_t offset) {
  if (line > 0) return " (line " + std::to_string(line) + ")";
  if (offset == 0 && file.facts.format == MeshFormat::gltf) return "";
  return " (byte " + std::to_string(offset) + ")";
}

/// The first file with points of the mesh that cannot be read.
const MeshDependency* lost_buffer(const MeshFile& file) {
  for (const MeshDependency& one : file.lost) {
    if (one.kind == MeshDependency::Kind::buffer) return &one;
  }
  return nullptr;
}

/// True when the file, or a buffer that it names, lies outside of the project.
bool is_outside(const MeshFile& file) {
  const MeshDependency* buffer = lost_buffer(file);
  if (buffer != nullptr && buffer->is_denied) return true;
  return file.status == ReadStatus::denied &&
         file.reason.find("--allow-outside") != std::string::npos;
}

/// SML1607 and SML1610 are about such paths.
bool is_absolute(std::string_view filename) {
  return filename.starts_with("/") || filename.starts_with("file:///");
}

/// These files may be sound, and all of them have the same cause.
void report_outside(const std::vector<Span>& places, bool is_standard_input, Findings& findings) {
  if (places.empty()) return;
  const bool is_one = places.size() == 1;
  // The same text for all robots of a repository, whatever their numbers of meshes.
  const char* message = is_one ? "the mesh was not looked at: it lies outside of the project"
                               : "meshes were not looked at: they lie outside of the project";
  Diagnostic& diagnostic = findings.report(places.front(), message);
  if (!is_one) diagnostic.caret = "the first of " + std::to_string(places.size());
  diagnostic.severity = Severity::warning;
  diagnostic.when(kUncertain);
  diagnostic.help("add `--allow-outside` to check " + std::string(is_one ? "it" : "them") +
                  (is_standard_input ? "; or, if the URDF belongs into another folder, add "
                                       "`--stdin-filename FOLDER/robot.urdf`"
                                     : ""));
}

void check(const LinkedModel& model, Findings& findings) {
  std::set<const MeshFile*> seen;
  std::vector<Span> outside;
  // A mesh is reported once. Some readers drop visuals.
  for (const MeshReference* one : collisions_first(model)) {
    const MeshReference& reference = *one;
    const MeshFile* file = reference.file;
    if (file == nullptr || !seen.insert(file).second) continue;
    const MeshFacts& facts = file->facts;
    if (has_other_format(reference)) continue;
    if (file->status == ReadStatus::too_large) {
      Diagnostic& diagnostic = findings.report(reference.span, "the mesh " + file->reason +
                                                                   ", too many to be checked here");
      diagnostic.severity = Severity::warning;
      diagnostic.help(raise_limit("mesh-bytes"));
    } else if (is_outside(*file)) {
      if (!is_absolute(reference.filename)) outside.push_back(reference.span);
    } else if (file->status != ReadStatus::ok) {
      report(reference, file->reason, findings);
    } else if (facts.bytes == 0) {
      report(reference, "the file is empty", findings);
    } else if (const MeshDependency* buffer = lost_buffer(*file)) {
      report(reference,
             "its buffer " + quoted(buffer->filename) + " does not exist" +
                 place(*file, buffer->line, buffer->offset),
             findings);
    } else if (facts.defect && facts.format != MeshFormat::bobj) {
      report(reference, facts.defect->what + place(*file, facts.defect->line, facts.defect->offset),
             findings);
    } else if (facts.format != MeshFormat::unknown && facts.format != MeshFormat::lfs_pointer &&
               !facts.defect && facts.unread.empty() && facts.triangles == 0) {
      Diagnostic& diagnostic = report(reference, "it contains no triangle", findings);
      if (facts.format == MeshFormat::collada) diagnostic.when(kEmptyCollada);
      if (facts.format == MeshFormat::obj) diagnostic.when(kEmptyObj);
    }
  }
  report_outside(outside, is_standard_input(model.urdf_path), findings);
}

/// Of a mesh that was not looked at.
constexpr std::string_view kMayRefuse = "refuses the file if the mesh is damaged";
constexpr std::string_view kMayLose = "has no such shape if the mesh is damaged";

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::loses, "opens the mesh of a visual only to draw it", kRun,
     at("visual")},
    {&readers::ros, Effect::loses, kMayLose, "assimp STLLoader.cpp", when(kUncertain)},
    {&readers::dart, Effect::refuses, kMayRefuse, kRun, when(kUncertain)},
    {&readers::mujoco, Effect::refuses, kMayRefuse, kRun, when(kUncertain)},
    {&readers::gazebo, Effect::loses, kMayLose, kRun, when(kUncertain)},
    {&readers::phobos, Effect::loses, kMayLose, kRun, when(kUncertain)},
    {&readers::pybullet, Effect::loses, "builds the link without the shape", kRun},
    {&readers::ros, Effect::loses, "RViz and MoveIt show the link without it",
     "assimp STLLoader.cpp"},
    {&readers::dart, Effect::loses, "makes a shape without triangles", kRun, when(kEmptyCollada)},
    {&readers::mujoco, Effect::changes, "makes the hull of the points", kRun, when(kEmptyObj)},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
    gazebo_without_mesh(),
    {&readers::phobos, Effect::loses, "keeps a mesh that it cannot open", kRun},
    {&readers::pinocchio, Effect::refuses, "cannot load the mesh, and refuses the shapes", kRun},
};

}  // namespace

extern constinit const Rule sml1644_mesh_broken{
    .id = "SML1644",
    .name = "mesh-broken",
    .severity = Severity::error,
    .summary =
        "A mesh file is cut short, damaged or empty, or a buffer of a glTF is missing or too "
        "short.",
    .remedy = "Restore the file, or export it again.",
    .sources = "Bullet LoadMeshFromSTL.h and assimp STLLoader.cpp compare the size with the count.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1644_mesh_broken_file
