// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "base/files/path.hpp"
#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1666_unused_mesh_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.unused_meshes.empty()) return;
  constexpr std::size_t kMostNames = 4;
  const std::size_t count = model.unused_meshes.size();
  std::vector<std::string> names;
  for (const std::string& mesh : model.unused_meshes)
    names.push_back(quoted(path::file_name(mesh)));
  const Field<std::string>& name = model.robot->name;
  findings
      .report(name.span.empty() ? tag_name(model, model.robot->document.root) : name.span,
              "no link uses " + counted(count, "mesh", "meshes") +
                  " beside those of the robot: " + shortlist(names, kMostNames, "other", "others"))
      .help(
          "delete them, or add the links that are missing: exporters leave out parts whose joints "
          "they do not know");
}

}  // namespace

extern constinit const Rule sml1666_unused_mesh{
    .id = "SML1666",
    .name = "unused-mesh",
    .severity = Severity::info,
    .summary = "Mesh files beside those of the robot are used by no link.",
    .why =
        "Exporters write a mesh for each part, and leave out links whose joints they do not know. "
        "The rule is silent if the package has other robots, if any text in it names the file, or if "
        "the robot computes such names.",
    .remedy = "Add the missing links, or delete the files.",
    .sources = "fusion2urdf issue 78; urdf2webots issue 44.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1666_unused_mesh_file
