// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1608_mesh_package_uri_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main) return;
  const MeshReference* first = nullptr;
  std::size_t count = 0;
  for (const MeshReference& reference : model.meshes) {
    if (reference.is_texture || package_of(reference.filename).empty()) continue;
    if (first == nullptr) first = &reference;
    ++count;
  }
  if (first == nullptr) return;
  Diagnostic& diagnostic = findings.report(first->span, "MARS does not understand the address " +
                                                            quoted(first->filename));
  if (count > 1) {
    diagnostic.note("the URDF names " + std::to_string(count) + " meshes in this way");
  }
  diagnostic.help("write relative paths that lead to the file from the folder of the URDF and from "
                  "that of the .smurf, such as `../meshes/arm.obj`");
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "treats it as a relative path, finds no file, and ends with an uncaught exception",
     "MARS smurf.cpp:1066-1137, misc.cpp:108-131, NodePhysics.cpp:626-634", at("collision")},
    {&readers::mars, Effect::loses, "treats it as a relative path, and shows the link without it",
     "MARS smurf.cpp:1066-1137, misc.cpp:108-131"},
};

}  // namespace

extern constinit const Rule sml1608_mesh_package_uri{
    .id = "SML1608",
    .name = "mesh-package-uri",
    .severity = Severity::warning,
    .summary = "The URDF of a SMURF model names a mesh by package://.",
    .remedy = "Write a relative path; with the folders `urdf/` and `smurf/` side by side, "
              "`../meshes/x.obj` works from both.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1608_mesh_package_uri_file
