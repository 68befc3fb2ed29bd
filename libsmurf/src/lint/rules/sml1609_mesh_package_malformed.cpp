// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>

#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1609_mesh_package_malformed_file {
namespace {

/// The text after "package:" and its slashes, if it may be the name of a package and a file.
std::optional<std::string> corrected(std::string_view filename) {
  std::string_view rest = filename.substr(filename.find(':') + 1);
  rest.remove_prefix(std::min(rest.find_first_not_of('/'), rest.size()));
  const std::size_t slash = rest.find('/');
  if (slash == std::string_view::npos || slash + 1 == rest.size()) return std::nullopt;
  return "package://" + std::string(rest);
}

/// Only the name of the package is missing, and the file lies in the folder of the URDF, or of one
/// above it.
constexpr Circumstance kFound{"found without a package"};
constexpr Circumstance kInFolder{"found in the folder of the URDF"};

/// The name of a package without a file, or nothing.
constexpr Circumstance kBare{"no file"};

/// Such a name has an extension, so it is no folder.
constexpr Circumstance kFileName{"name of a file"};

bool are_all(const std::vector<PathUses>& paths, bool (*is_one)(const MeshReference&)) {
  return std::all_of(paths.begin(), paths.end(),
                     [&](const PathUses& path) { return is_one(path.first()); });
}

void check(const LinkedModel& model, Findings& findings) {
  const std::vector<PathUses> paths = paths_with(model, PathFault::malformed_package);
  if (paths.empty()) return;
  const std::string_view first = paths.front().filename;
  Diagnostic& diagnostic = findings.report(
      paths.front().first().span, "the address " + quoted(first) + " names no package and file");
  if (paths.size() > 1) {
    diagnostic.note("this applies to " + std::to_string(paths.size()) + " addresses");
  }
  const bool are_found = are_all(paths, [](const MeshReference& one) { return one.exists; });
  if (are_found) diagnostic.when(kFound);
  if (first == "package://" || !package_of(first).empty()) diagnostic.when(kBare);
  if (first.find('.') != std::string_view::npos) diagnostic.when(kFileName);
  if (are_found && are_all(paths, [](const MeshReference& one) { return one.lies_beside; })) {
    diagnostic.when(kInFolder);
  }
  diagnostic.help("write package://NAME/PATH");
  Fix fix{Applicability::unsafe, {}};
  for (const PathUses& path : paths) {
    const auto name = corrected(path.filename);
    if (!name) continue;
    const Fix one = rewrite(path, *name, Applicability::unsafe);
    fix.edits.insert(fix.edits.end(), one.edits.begin(), one.edits.end());
  }
  if (const auto name = corrected(first)) diagnostic.help("did you mean " + quoted(*name) + "?");
  if (!fix.edits.empty()) diagnostic.fixes.push_back(std::move(fix));
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes,
     "looks for the rest of the path in the folders above the URDF", kRun, when(kFound)},
    {&readers::pybullet, Effect::takes, "does without a texture", kRun, at("texture")},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", kRun},
    {&readers::newton, Effect::takes, "does not open textures that it does not find", kRun,
     at("texture")},
    {&readers::isaac, Effect::refuses, "refuses the address of a texture", kRun,
     at("texture").when(kBare)},
    newton_without_mesh(when(kBare, kFileName)),
    {&readers::newton, Effect::refuses, "opens the folder, and refuses the file", kRun,
     when(kBare)},
    newton_without_mesh(),
    isaac_without_mesh(when(kBare)),
    {&readers::isaac, Effect::takes, "looks for the rest of the path in the folders above the URDF",
     kRun, when(kFound)},
    isaac_without_mesh(),
    {&readers::ros, Effect::loses, "looks for a folder called `package:`",
     "resource_retriever, read"},
    kMujocoLooksBeside,
    {&readers::mujoco, Effect::refuses, "looks for a folder called `package:`", kRun},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
    gazebo_without_mesh(),
    {&readers::dart, Effect::refuses, "finds no package, and refuses the file", kRun},
    {&readers::pinocchio, Effect::takes, "finds it, if it is given the folder of the URDF", kRun,
     when(kInFolder)},
    {&readers::pinocchio, Effect::takes, "does not look at textures", kRun, at("texture")},
    {&readers::pinocchio, Effect::refuses, "does not find the mesh, and refuses the shapes", kRun},
};

}  // namespace

extern constinit const Rule sml1609_mesh_package_malformed{
    .id = "SML1609",
    .name = "mesh-package-malformed",
    .severity = Severity::error,
    .summary = "A package:// address lacks the name of a package or of a file.",
    .remedy = "Write package://NAME/PATH.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1609_mesh_package_malformed_file
