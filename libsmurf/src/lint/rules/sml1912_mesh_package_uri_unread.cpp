// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "base/findings/readers.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/geometry_queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1912_mesh_package_uri_unread_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  std::map<GeometryRole, std::vector<Span>> uses;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (use.mesh() == nullptr || !use.mesh()->filename) return;
    if (!use.mesh()->filename->starts_with("package://")) return;
    uses[use.role].push_back(use.mesh()->filename.span);
  });
  for (const auto& [role, places] : uses) {
    const std::string what = std::string(to_string(role));
    Diagnostic& diagnostic =
        findings.report(places.front(), "the mesh of a " + what + " is named by `package://`");
    if (places.size() > 1) {
      diagnostic.note("the same applies to those of " + std::to_string(places.size() - 1) +
                      " more " + what + (places.size() > 2 ? "s" : ""));
    }
    diagnostic.help(
        "write a path relative to the URDF, as smurf2urdf does for packages that it finds");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "treats `package://` as a part of the path, and ends with an exception",
     "MARS misc.cpp:112-131", at("collision")},
    {&readers::mars, Effect::loses,
     "treats `package://` as a part of the path, and shows the link without it",
     "MARS misc.cpp:112-131"},
    {&readers::phobos, Effect::refuses,
     "uses the folder above urdf/ for every package, and stops when the file is not there",
     "Phobos xml.py:89-98, run"},
    kMujocoLooksBeside,
    {&readers::mujoco, Effect::takes, "looks in the folder that its element `compiler` names", kRun,
     when(kElsewhere)},
    {&readers::mujoco, Effect::refuses, "treats `package://` as a part of the path", kRun},
    {&readers::dart, Effect::takes,
     "finds packages whose folders it was given, as programs that use it do", kRun},
};

}  // namespace

extern constinit const Rule sml1912_mesh_package_uri_unread{
    .id = "SML1912",
    .name = "mesh-package-uri-unread",
    .severity = Severity::error,
    .summary = "A mesh is named by `package://`, which a target does not resolve.",
    .remedy = "Write a path relative to the URDF.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1912_mesh_package_uri_unread_file
