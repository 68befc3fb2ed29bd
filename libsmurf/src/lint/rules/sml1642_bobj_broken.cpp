// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "base/findings/readers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1642_bobj_broken_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  std::set<const MeshFile*> seen;
  for (const MeshReference& reference : model.meshes) {
    const std::pair<const MeshFile*, const std::string*> candidates[] = {
        {reference.file, &reference.path}, {reference.mars_file, &reference.mars_path}};
    for (const auto& [file, path] : candidates) {
      if (file == nullptr || !seen.insert(file).second) continue;
      if (file->facts.format != MeshFormat::bobj || !file->facts.defect) continue;
      const MeshDefect& defect = *file->facts.defect;
      Diagnostic& diagnostic =
          findings.report(reference.span, "the .bobj cannot be read: " + defect.what + " (byte " +
                                              std::to_string(defect.offset) + ")");
      if (file != reference.file) diagnostic.note("MARS loads " + quoted(*path));
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::ignores, "reads no .bobj",
     "only the MARS generations and Phobos know it"},
    {&readers::mars, Effect::crashes,
     "checks neither records nor indices: it reads out of bounds, or draws a mesh with a hole",
     "MARS gui_helper_functions.cpp:390-599, control flow executed"},
};

}  // namespace

extern constinit const Rule sml1642_bobj_broken{
    .id = "SML1642",
    .name = "bobj-broken",
    .severity = Severity::error,
    .summary = "A .bobj file is damaged, or has a size at which MARS loses the last triangle.",
    .remedy = "Export the .bobj again; if the size is the problem, repeat the last triangle.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1642_bobj_broken_file
