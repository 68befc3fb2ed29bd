// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "link/mujoco_compiler.hpp"
#include "link/packages.hpp"
#include "lint/geometry_queries.hpp"
#include "lint/mesh_queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1604_mesh_missing_file {
namespace {

constexpr Circumstance kFoundByMars{"found by mars"};
constexpr Circumstance kMesh{"mesh"};
constexpr Circumstance kFolder{"folder"};
constexpr Circumstance kAbove{"found from above"};
constexpr Circumstance kTexture{"texture"};
constexpr Circumstance kShortUri{"file: without a host"};

/// Whether a folder on the way to the URDF has this name, as far as the path is written.
bool lies_in(const LinkedModel& model, std::string_view name) {
  const std::string folders = "/" + std::string(path::parent(model.urdf_path)) + "/";
  return !name.empty() && folders.find("/" + std::string(name) + "/") != std::string::npos;
}

std::string why_not_found(const LinkedModel& model, std::string_view package) {
  return lies_in(model, package)
             ? "the folder " + quoted(package) + " above the URDF does not contain it"
             : "in no folder above the URDF";
}

/// A package without any file on this machine is one finding, and not an error: it may be
/// elsewhere.
void report_package(const std::vector<const MeshReference*>& uses, std::string_view package,
                    const LinkedModel& model, Findings& findings) {
  const std::string name(package);
  Diagnostic& diagnostic =
      findings.report(uses.front()->span, "cannot find any file of the package " + quoted(package));
  const bool is_here = lies_in(model, package);
  diagnostic.caret = why_not_found(model, package);
  diagnostic.severity = Severity::warning;
  diagnostic.when(cases::kLostPackage);
  if (uses.size() > 1) {
    diagnostic.note("the URDF names " + std::to_string(uses.size()) + " files of it");
  }
  diagnostic.help(is_here ? "add the files, or name another folder: `--package " + name + "=DIR`"
                          : "name its folder: `--package " + name + "=DIR`");
}

/// Whether the path leads to a file from a folder above the URDF, where Bullet looks, too.
bool is_found_from_above(const MeshReference& mesh, const LinkedModel& model) {
  if (mesh.meant.empty()) return false;
  const std::string folder(path::parent(model.urdf_path));
  const std::string meant = path::join(folder, mesh.meant);
  std::string above = folder;
  for (std::size_t level = 0; level < kFoldersAbove; ++level) {
    above = path::join(above, "..");
    if (path::join(above, mesh.filename) == meant) return true;
  }
  return false;
}

/// Whether the similar file is that of another link, and more than a misspelling away: `right_hip`
/// and `right_thigh` are two parts.
bool is_of_another_part(const MeshReference& mesh, const LinkedModel& model) {
  constexpr int kMisspelling = 2;
  const bool is_used =
      std::any_of(model.meshes.begin(), model.meshes.end(), [&](const MeshReference& other) {
        return other.exists && other.filename == mesh.meant;
      });
  return is_used && edit_distance(path::file_name(mesh.filename), path::file_name(mesh.meant),
                                  kMisspelling) > kMisspelling;
}

/// Suggests another file in all places that name the missing one.
void suggest(const MeshReference& mesh, const LinkedModel& model, Diagnostic& diagnostic) {
  if (is_of_another_part(mesh, model)) return;
  const bool is_beside = path::parent(mesh.meant) == path::parent(mesh.filename);
  diagnostic.help("did you mean " + quoted(is_beside ? path::file_name(mesh.meant) : mesh.meant) +
                  "?");
  PathUses uses{mesh.filename, {}};
  for (const MeshReference& other : model.meshes) {
    if (other.filename == mesh.filename) uses.references.push_back(&other);
  }
  diagnostic.fixes.push_back(rewrite(uses, mesh.meant, Applicability::unsafe));
}

/// "file:arm.stl"; a second slash would begin the name of a host.
bool is_uri_without_host(std::string_view filename) {
  return filename.starts_with("file:") && !filename.starts_with("file://");
}

bool names_folder(const MeshReference& mesh) {
  const bool is_file = mesh.filename.ends_with('/') && mesh.filename.starts_with(mesh.meant) &&
                       !mesh.meant.empty();  // `arm.stl/`
  return !is_file && is_one_of(path::file_name(mesh.filename), {"", ".", ".."});
}

void report_file(const MeshReference& mesh, const LinkedModel& model, std::size_t lost_beside,
                 Findings& findings) {
  Diagnostic& diagnostic =
      findings.report(mesh.span, std::string(mesh.is_texture ? "texture" : "mesh") +
                                     " file not found: " + quoted(mesh.filename));
  diagnostic.when(mesh.is_texture ? kTexture : kMesh);
  if (names_folder(mesh)) diagnostic.when(kFolder);
  if (mesh.path.empty()) {
    diagnostic.caret = why_not_found(model, package_of(mesh.filename));
  } else if (mesh.path != mesh.filename) {
    diagnostic.caret = "resolved to " + quoted(mesh.path);
  }
  if (lost_beside > 0) {
    const std::string others =
        lost_beside == 1 ? "the other file" : "the " + std::to_string(lost_beside) + " other files";
    diagnostic.note(others + " that the URDF names in this folder" +
                    (lost_beside == 1 ? " is" : " are") + " missing, too");
  }
  // Its package was found, or it has none.
  if (!mesh.path.empty()) diagnostic.help("add the file, or correct the path");
  if (path_fault(mesh) == PathFault::found_by_mars_only) {
    diagnostic.when(kFoundByMars);
    diagnostic.note("MARS, from the .smurf, finds " + quoted(mesh.mars_path));
    diagnostic.help(mesh.mars_path.ends_with(".bobj")
                        ? "add the mesh itself; only MARS reads .bobj"
                        : "keep the URDF and the .smurf in folders side by side");
  }
  if (!mesh.meant.empty()) suggest(mesh, model, diagnostic);
  if (is_found_from_above(mesh, model)) diagnostic.when(kAbove);
  if (is_uri_without_host(mesh.filename)) diagnostic.when(kShortUri);
  if (mesh.is_texture) diagnostic.severity = Severity::warning;
}

void check(const LinkedModel& model, Findings& findings) {
  std::set<std::string_view> found;  // packages and folders with at least one existing file
  for (const MeshReference& mesh : model.meshes) {
    if (!mesh.exists) continue;
    found.insert(package_of(mesh.filename));
    found.insert(path::parent(mesh.path));
  }
  using Uses = std::vector<const MeshReference*>;
  std::map<std::string_view, Uses> lost_packages;
  // Bullet finds some of the files of a folder, and refuses the robot for the others.
  std::map<std::tuple<std::string_view, PathFault, bool>, Uses> lost_folders;
  std::set<std::string_view> seen;
  for (const MeshReference* mesh : collisions_first(model)) {
    const PathFault fault = path_fault(*mesh);
    if (fault != PathFault::missing && fault != PathFault::found_by_mars_only) continue;
    if (!seen.insert(mesh->filename).second) continue;
    const std::string_view package = package_of(mesh->filename);
    const std::string_view folder = path::parent(mesh->path);
    if (mesh->path.empty() && !found.contains(package)) {
      lost_packages[package].push_back(mesh);
    } else if (mesh->path.empty() || found.contains(folder)) {
      report_file(*mesh, model, 0, findings);
    } else {
      lost_folders[{folder, fault, is_found_from_above(*mesh, model)}].push_back(mesh);
    }
  }
  for (const auto& [package, uses] : lost_packages) report_package(uses, package, model, findings);
  for (const auto& [folder, uses] : lost_folders) {
    report_file(*uses.front(), model, uses.size() - 1, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::loses, "looks for the package in other folders",
     "package folders depend on the machine", when(cases::kLostPackage)},
    {&readers::mars, Effect::takes, "finds it from the folder of the .smurf",
     "MARS smurf.cpp:1080-1113", when(kFoundByMars)},
    kMarsWithoutCollision,
    mars_without_mesh(at("visual")),
    {&readers::phobos, Effect::refuses, "stops with an IOError", "Phobos a613e31, run",
     when(kTexture)},
    {&readers::phobos, Effect::refuses,
     "looks in the folder above urdf/ only, and stops with an exception", "Phobos a613e31, run",
     when(cases::kLostPackage)},
    {&readers::phobos, Effect::loses, "keeps a mesh that it cannot open", kRun, when(kMesh)},
    {&readers::pybullet, Effect::takes, "looks in the folders above the URDF, too", kRun,
     when(kAbove)},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot",
     "Bullet UrdfFindMeshFile.h, run", when(kMesh)},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot",
     "Bullet UrdfFindMeshFile.h, run", when(cases::kLostPackage)},
    ros_without_mesh(when(kMesh)),
    gazebo_without_mesh(when(kMesh)),
    {&readers::dart, Effect::refuses, "reads it as a URI, and refuses the file", "6.20.0, run",
     when(kShortUri)},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun,
     when(kMesh)},
    {&readers::dart, Effect::refuses, "finds no package, and refuses the file", kRun,
     when(cases::kLostPackage)},
    kMujocoLooksBeside,
    {&readers::mujoco, Effect::takes, "looks in the folder that its element `compiler` names", kRun,
     when(kElsewhere)},
    {&readers::mujoco, Effect::refuses, "cannot open the file, and refuses the model", kRun,
     when(kMesh)},
    {&readers::drake, Effect::loses, "shows nothing for a folder", kRun,
     at("visual").when(kMesh, kFolder)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun, when(kMesh)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun, when(kTexture)},
    {&readers::drake, Effect::refuses, "knows no such package, and refuses the file", kRun,
     when(cases::kLostPackage)},
    {&readers::pinocchio, Effect::refuses, "does not find the mesh, and refuses the shapes", kRun,
     when(kMesh)},
    {&readers::pinocchio, Effect::refuses, "finds only packages whose folders it was given", kRun,
     when(cases::kLostPackage)},
    {&readers::newton, Effect::refuses, "opens the folder, and refuses the file", kRun,
     when(kMesh, kFolder)},
    {&readers::newton, Effect::refuses, "refuses a relative URI", kRun, when(kShortUri)},
    newton_without_mesh(),
    isaac_without_mesh(),
};

}  // namespace

extern constinit const Rule sml1604_mesh_missing{
    .id = "SML1604",
    .name = "mesh-missing",
    .severity = Severity::error,
    .summary = "A mesh or texture file does not exist.",
    .why = "Some readers go on without the shape, others refuse the robot.",
    .remedy =
        "Correct the path (relative to the URDF), add the file, or name the package's folder with "
        "`--package NAME=DIR`.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::always};

}  // namespace smurf::rules::sml1604_mesh_missing_file
