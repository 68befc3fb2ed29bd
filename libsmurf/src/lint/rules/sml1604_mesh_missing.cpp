// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <set>

#include "base/path.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules {
namespace {

/// A package of which nothing is found is one finding however many files it should hold, and no
/// error: it may lie elsewhere.
void report_package(const std::vector<const MeshReference*>& uses, std::string_view package,
                    Findings& findings) {
  const std::string name(package);
  Diagnostic& diagnostic =
      findings.report(uses.front()->span, "cannot find any file of the package " + quoted(package));
  diagnostic.caret = "in no folder above the URDF";
  diagnostic.severity = Severity::warning;
  diagnostic.construct = "package";
  if (uses.size() > 1) {
    diagnostic.notes.push_back("the URDF names " + std::to_string(uses.size()) + " files of it");
  }
  diagnostic.help = "name its folder: `--package " + name + "=DIR`";
}

void report_file(const MeshReference& mesh, std::size_t lost_beside, Findings& findings) {
  Diagnostic& diagnostic =
      findings.report(mesh.span, std::string(mesh.is_texture ? "texture" : "mesh") +
                                     " file not found: " + quoted(mesh.filename));
  diagnostic.construct = mesh.is_texture ? "texture" : "mesh";
  if (mesh.path.empty()) {
    diagnostic.caret = "in no folder above the URDF";
  } else if (mesh.path != mesh.filename) {
    diagnostic.caret = "resolved to " + quoted(mesh.path);
  }
  if (lost_beside > 0) {
    const std::string others =
        lost_beside == 1 ? "nor is the other file"
                         : "nor is any of the " + std::to_string(lost_beside) + " other files";
    diagnostic.notes.push_back(others + " that the URDF names in this folder");
  }
  if (mesh.is_texture) diagnostic.severity = Severity::warning;
}

void check(const LinkedModel& model, Findings& findings) {
  std::set<std::string_view> found;  // packages and folders of which something is there
  for (const MeshReference& mesh : model.meshes) {
    if (!mesh.exists) continue;
    found.insert(package_of(mesh.filename));
    found.insert(path::parent(mesh.path));
  }
  std::map<std::string_view, std::vector<const MeshReference*>> lost_packages;
  std::map<std::string_view, std::vector<const MeshReference*>> lost_folders;
  std::set<std::string_view> seen;
  for (const MeshReference& mesh : model.meshes) {
    if (path_fault(mesh) != PathFault::missing || !seen.insert(mesh.filename).second) continue;
    const std::string_view package = package_of(mesh.filename);
    const std::string_view folder = path::parent(mesh.path);
    if (mesh.path.empty()) {
      if (found.contains(package))
        report_file(mesh, 0, findings);
      else
        lost_packages[package].push_back(&mesh);
    } else if (found.contains(folder)) {
      report_file(mesh, 0, findings);
    } else {
      lost_folders[folder].push_back(&mesh);
    }
  }
  for (const auto& [package, uses] : lost_packages) report_package(uses, package, findings);
  for (const auto& [folder, uses] : lost_folders) {
    report_file(*uses.front(), uses.size() - 1, findings);
  }
}

}  // namespace

extern constinit const Rule sml1604_mesh_missing{
    .id = "SML1604",
    .name = "mesh-missing",
    .severity = Severity::error,
    .summary = "A mesh or texture file does not exist.",
    .why = "Bullet loses the whole robot, Drake, MuJoCo, Pinocchio and DART refuse the file or "
           "the body; urdfdom and sdformat do not look.",
    .remedy =
        "Correct the path (relative to the URDF), add the file, or name the package's folder with "
        "`--package NAME=DIR`.",
    .sources = "Bullet, MuJoCo 3.14, DART 6.12 and urdfdom 3.0.1, executed.",
    .check_model = check};

}  // namespace smurf::rules
