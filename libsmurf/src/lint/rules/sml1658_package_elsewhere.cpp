// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1658_package_elsewhere_file {
namespace {

/// The URDF does not lie in the package.
constexpr Circumstance kOutside{"outside"};
/// The package is in a folder of its name.
constexpr Circumstance kOwnName{"folder of its name"};
constexpr std::string_view kScheme = "package://";

/// The folder of the package of a file that was found.
std::string folder_of_package(const MeshReference& mesh) {
  const std::string_view rest =
      std::string_view(mesh.filename).substr(kScheme.size() + package_of(mesh.filename).size());
  return mesh.path.ends_with(rest) ? mesh.path.substr(0, mesh.path.size() - rest.size()) : ".";
}

bool lies_in(const LinkedModel& model, const std::string& folder) {
  const std::string from = path::relative(folder, path::parent(model.urdf_path));
  return from.empty() || from == "." || from.ends_with("..");
}

void check(const LinkedModel& model, Findings& findings) {
  for (const MeshReference& mesh : model.meshes) {
    if (!mesh.exists || !mesh.is_package_elsewhere) continue;
    const std::string folder = folder_of_package(mesh);
    Diagnostic& finding = findings.report_habit(
        mesh.span, "no folder above the URDF holds " + quoted(mesh.filename.substr(kScheme.size())),
        "such files");
    finding.caret = "its package is in the folder " + quoted(folder);
    if (!lies_in(model, folder)) finding.when(kOutside);
    if (path::file_name(folder) == package_of(mesh.filename)) finding.when(kOwnName);
  }
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::refuses,
     "looks for the name of the package in the folders above the URDF, and refuses the robot", kRun,
     at("mesh")},
    {&readers::pinocchio, Effect::takes, "finds it, if it is given the folder around the package",
     kRun, when(kOwnName)},
    {&readers::pinocchio, Effect::refuses,
     "looks for a folder of the name of the package, and refuses the shapes", kRun, at("mesh")},
    newton_without_mesh(at("mesh")),
    isaac_without_mesh(at("mesh").when(kOutside)),
};

}  // namespace

extern constinit const Rule sml1658_package_elsewhere{
    .id = "SML1658",
    .name = "package-elsewhere",
    .severity = Severity::info,
    .summary = "A package lies in no folder of its name above the URDF.",
    .why = "ROS finds packages by their package.xml. Readers without ROS know only the folders "
           "above the URDF.",
    .remedy = "Keep the package in a folder of its name, in or beside a folder above the URDF.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1658_package_elsewhere_file
