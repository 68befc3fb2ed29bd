// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <set>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1634_mesh_basename_clash_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  std::map<std::string, const urdf::Mesh*, std::less<>> first_by_stem;
  std::set<std::string_view> reported;
  for_each_geometry(model, [&](const GeometryUse& use) {
    const urdf::Mesh* mesh = use.mesh();
    if (mesh == nullptr || use.role != GeometryRole::collision) return;
    const MeshReference* reference = find_reference(model, *mesh);
    if (reference == nullptr || reference->filename.empty()) return;
    std::string key(path::stem(reference->filename));
    if (mesh->scale) {
      for (const double factor : *mesh->scale) key += " " + format_number(factor);
    } else {
      key += " 1 1 1";
    }
    const auto [known, is_new] = first_by_stem.emplace(std::move(key), mesh);
    const urdf::Mesh& first = *known->second;
    if (is_new || *first.filename == reference->filename) return;
    const MeshReference* other = find_reference(model, first);
    const bool is_same = !reference->path.empty() && reference->path == other->path;
    if (is_same || !reported.insert(reference->filename).second) return;
    Diagnostic& diagnostic =
        findings.report(reference->span, "another collision mesh is called " +
                                             quoted(path::stem(reference->filename)) +
                                             " too, elsewhere or in another format");
    diagnostic.label(first.filename.span, "the first one");
    diagnostic.note("MuJoCo uses the first for both");
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "tells meshes apart by their whole paths", "urdfdom, run"},
    {&readers::mujoco, Effect::changes,
     "keeps meshes by the name without folder and extension, so the first silently replaces the second",
     "MuJoCo xml_urdf.cc:594-615, run"},
};

}  // namespace

extern constinit const Rule sml1634_mesh_basename_clash{
    .id = "SML1634",
    .name = "mesh-basename-clash",
    .severity = Severity::warning,
    .summary = "Two collision meshes have the same file name in different folders or formats.",
    .remedy = "Rename one of them.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1634_mesh_basename_clash_file
