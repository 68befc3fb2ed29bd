// SPDX-License-Identifier: BSD-3-Clause
#include "lint/mesh_queries.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "ast/urdf_numbers.hpp"
#include "base/files/path.hpp"
#include "base/text/edits.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

constexpr std::string_view kPackage = "package://";

bool has_drive(std::string_view filename) {
  const bool has_letter = !filename.empty() && ((filename[0] >= 'A' && filename[0] <= 'Z') ||
                                                (filename[0] >= 'a' && filename[0] <= 'z'));
  return has_letter && filename.size() > 2 && filename[1] == ':' &&
         (filename[2] == '/' || filename[2] == '\\');
}

bool is_malformed_package(std::string_view filename) {
  if (!filename.starts_with("package:")) return false;
  const std::string_view package = package_of(filename);
  return package.empty() || filename.size() <= kPackage.size() + package.size() + 1;
}

/// The format that a reader expects for the extension; unknown if several or none are possible.
MeshFormat expected_format(std::string_view filename) {
  const std::string extension = path::to_lower(path::extension(filename));
  if (extension == ".stl") return MeshFormat::stl_binary;
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".dae") return MeshFormat::collada;
  if (extension == ".bobj") return MeshFormat::bobj;
  if (extension == ".gltf" || extension == ".glb") return MeshFormat::gltf;
  return MeshFormat::unknown;
}

}  // namespace

std::string_view package_of(std::string_view filename) {
  if (!filename.starts_with(kPackage)) return {};
  filename.remove_prefix(kPackage.size());
  return filename.substr(0, filename.find('/'));
}

PathFault path_fault(const MeshReference& reference) {
  using enum PathFault;
  const std::string_view filename = reference.filename;
  if (trimmed(filename).empty()) return empty;
  if (is_xacro(filename)) return none;  // SML1009
  if (is_malformed_package(filename)) return malformed_package;
  if (filename.find("://") != std::string_view::npos && !filename.starts_with(kPackage)) {
    return scheme;
  }
  if (path::is_absolute(filename) || has_drive(filename)) return absolute;
  if (reference.exists) return none;
  if (filename.find('\\') != std::string_view::npos) return backslash;
  if (!reference.similar.empty()) return other_case;
  return reference.mars_exists ? found_by_mars_only : missing;
}

bool lies_outside(const MeshReference& reference) {
  return reference.file != nullptr && reference.file->status == ReadStatus::denied;
}

std::vector<const MeshReference*> collisions_first(const LinkedModel& model) {
  std::set<std::uint32_t> collisions;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (use.mesh() != nullptr && use.role == GeometryRole::collision) {
      collisions.insert(use.mesh()->filename.span.begin);
    }
  });
  std::vector<const MeshReference*> references;
  for (const MeshReference& mesh : model.meshes) references.push_back(&mesh);
  std::stable_partition(references.begin(), references.end(), [&](const MeshReference* mesh) {
    return collisions.contains(mesh->span.begin);
  });
  return references;
}

std::vector<PathUses> paths_with(const LinkedModel& model, PathFault fault) {
  std::vector<PathUses> paths;
  std::map<std::string_view, std::size_t> by_name;
  for (const MeshReference* reference : collisions_first(model)) {
    if (path_fault(*reference) != fault) continue;
    const auto [known, is_new] = by_name.try_emplace(reference->filename, paths.size());
    if (is_new) paths.push_back({reference->filename, {}});
    paths[known->second].references.push_back(reference);
  }
  return paths;
}

Fix rewrite(const PathUses& path, std::string_view filename, Applicability applicability) {
  Fix fix{applicability, {}};
  for (const MeshReference* reference : path.references) {
    fix.edits.push_back({reference->span, escape_xml(filename)});
  }
  return fix;
}

bool has_other_format(const MeshReference& reference) {
  if (reference.file == nullptr || reference.file->facts.bytes == 0) return false;
  MeshFormat found = reference.file->facts.format;
  if (found == MeshFormat::lfs_pointer) return false;
  if (found == MeshFormat::stl_ascii) found = MeshFormat::stl_binary;
  const MeshFormat expected = expected_format(reference.filename);
  return expected != MeshFormat::unknown && expected != found;
}

bool OpenedMesh::is_collision() const {
  return std::any_of(uses.begin(), uses.end(),
                     [](const GeometryUse& use) { return use.role == GeometryRole::collision; });
}

std::vector<OpenedMesh> opened_meshes(const LinkedModel& model) {
  std::vector<OpenedMesh> meshes;
  if (model.meshes.empty()) return meshes;  // ten rules use it, so the geometries are searched once
  struct Found {
    const MeshReference* first = nullptr;
    const MeshReference* first_of_collisions = nullptr;
    std::vector<GeometryUse> uses;
  };
  std::vector<Found> found;
  std::unordered_map<const MeshFile*, std::size_t> by_file;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (use.mesh() == nullptr) return;
    const MeshReference* reference = find_reference(model, *use.mesh());
    if (reference == nullptr || reference->file == nullptr) return;
    if (reference->file->status != ReadStatus::ok) return;
    const auto [known, is_new] = by_file.try_emplace(reference->file, found.size());
    if (is_new) found.push_back({reference, nullptr, {}});
    Found& one = found[known->second];
    const bool is_collision = use.role == GeometryRole::collision;
    if (is_collision && one.first_of_collisions == nullptr) one.first_of_collisions = reference;
    one.uses.push_back(use);
  });
  for (Found& one : found) {
    const MeshReference& shown = one.first_of_collisions ? *one.first_of_collisions : *one.first;
    meshes.push_back({shown, *shown.file, shown.file->facts, std::move(one.uses)});
  }
  return meshes;
}

Diagnostic* report_meshes(const LinkedModel& model,
                          const std::function<bool(const OpenedMesh&)>& is_at_fault,
                          std::string_view one, std::string_view many, Findings& findings) {
  const std::vector<OpenedMesh> meshes = opened_meshes(model);
  std::vector<const OpenedMesh*> faulty;
  for (const OpenedMesh& mesh : meshes) {
    if (is_at_fault(mesh)) faulty.push_back(&mesh);
  }
  if (faulty.empty()) return nullptr;
  // At a collision if there is one, because some readers ignore visuals.
  const auto shown_first = std::find_if(
      faulty.begin(), faulty.end(), [](const OpenedMesh* mesh) { return mesh->is_collision(); });
  if (shown_first != faulty.end()) std::rotate(faulty.begin(), shown_first, shown_first + 1);
  const bool is_one = faulty.size() == 1;
  std::string message(one);
  if (!is_one) message = std::to_string(faulty.size()) + " mesh files " + std::string(many);
  Diagnostic& diagnostic = findings.report(faulty.front()->reference.span, std::move(message));
  if (is_one) return &diagnostic;
  diagnostic.caret = "the first of them";
  constexpr std::size_t kShown = 3;
  std::string others = "also";
  const std::size_t shown = std::min(faulty.size(), kShown + 1);
  // Files for drawing and for collisions often have the same name, in other folders.
  std::multiset<std::string_view> names;
  for (std::size_t i = 0; i < shown; ++i) {
    names.insert(path::file_name(faulty[i]->reference.filename));
  }
  for (std::size_t i = 1; i < shown; ++i) {
    const std::string_view file = faulty[i]->reference.filename;
    const std::string_view name = path::file_name(file);
    const std::string_view folder = path::file_name(path::parent(file));
    const bool is_clear = names.count(name) == 1 || folder.empty();
    others += (i > 1 ? ", " : " ") +
              quoted(is_clear ? std::string(name) : std::string(folder) + "/" + std::string(name));
  }
  if (faulty.size() > kShown + 1) {
    others += " and " + std::to_string(faulty.size() - kShown - 1) + " more";
  }
  diagnostic.note(std::move(others));
  return &diagnostic;
}

void report_turned(const std::vector<const MeshReference*>& turned, std::string message,
                   std::string_view kind, Findings& findings) {
  if (turned.empty()) return;
  std::set<std::string_view> files;
  for (const MeshReference* reference : turned) files.insert(reference->filename);
  Diagnostic& diagnostic = findings.report(turned.front()->span, std::move(message));
  if (files.size() > 1) {
    diagnostic.note("this applies to " + std::to_string(files.size()) + " " + std::string(kind));
  }
  diagnostic.help(
      "export a .bobj beside it with Phobos: MARS loads that instead, and does not turn it");
}

}  // namespace smurf
