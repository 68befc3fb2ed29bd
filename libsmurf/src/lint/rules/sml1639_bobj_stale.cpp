// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <set>

#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1639_bobj_stale_file {
namespace {

bool is_alike(double a, double b, double size) { return std::abs(a - b) <= 0.01 * size; }

/// Equal as written, or after turning the axes of old MARS meshes, which are y up: (x, -z, y).
bool is_same(const Box& mesh, const Box& bobj) {
  const Vector3 extent = mesh.size();
  const double size = std::max({extent[0], extent[1], extent[2]});
  const Box turned{{mesh.low[0], mesh.low[2], -mesh.high[1]},
                   {mesh.high[0], mesh.high[2], -mesh.low[1]}};
  const Box back{{mesh.low[0], -mesh.high[2], mesh.low[1]},
                 {mesh.high[0], -mesh.low[2], mesh.high[1]}};
  for (const Box& candidate : {mesh, turned, back}) {
    bool is_equal = true;
    for (std::size_t i = 0; i < 3; ++i) {
      is_equal = is_equal && is_alike(candidate.low[i], bobj.low[i], size) &&
                 is_alike(candidate.high[i], bobj.high[i], size);
    }
    if (is_equal) return true;
  }
  return false;
}

void check(const LinkedModel& model, Findings& findings) {
  std::set<std::string_view> seen;
  for (const MeshReference& reference : model.meshes) {
    const MeshFile* mesh = reference.file;
    const MeshFile* bobj = reference.mars_file;
    if (mesh == nullptr || bobj == nullptr || mesh == bobj) continue;
    if (!mesh->facts.box || !bobj->facts.box || mesh->facts.defect || bobj->facts.defect) continue;
    if (is_same(*mesh->facts.box, *bobj->facts.box)) continue;
    if (!seen.insert(reference.mars_path).second) continue;
    findings
        .report(reference.span, "MARS loads " + quoted(reference.mars_path) +
                                    " instead, which has another size or place")
        .help("write the .bobj again, or delete it");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "silently prefers the .bobj", "MARS smurf.cpp:1075-1110"},
};

}  // namespace

extern constinit const Rule sml1639_bobj_stale{
    .id = "SML1639",
    .name = "bobj-stale",
    .severity = Severity::warning,
    .summary = "The .bobj that MARS loads instead of a mesh has another bounding box.",
    .why = "It was most likely made from an older state of the mesh.",
    .remedy = "Export the .bobj again, or delete it.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1639_bobj_stale_file
