// SPDX-License-Identifier: BSD-3-Clause
// The export edits bytes; it never prints a tree (urdfdom's own export loses names, extensions,
// comments and digits).
#include "base/edits.hpp"
#include "base/path.hpp"
#include "convert/rebase.hpp"

namespace smurf {
namespace {

bool is_relative_path(std::string_view filename) {
  return !filename.empty() && !path::is_absolute(filename) &&
         filename.find("://") == std::string_view::npos;
}

}  // namespace

std::vector<Edit> rebase_paths(const LinkedModel& model, const std::string& folder,
                               const std::string& current_folder) {
  std::vector<Edit> edits;
  for (const MeshReference& mesh : model.meshes) {
    if (!is_relative_path(mesh.filename)) continue;
    const std::string target = path::join(current_folder, mesh.path);
    if (path::join(folder, mesh.filename) == target) continue;  // resolves as it is written
    edits.push_back({mesh.span, escape_xml(path::relative(target, folder))});
  }
  return edits;
}

std::string export_urdf(const LinkedModel& model, const SourceMap& sources,
                        const UrdfExport& options) {
  const std::string folder = path::join(options.current_folder, options.output_folder);
  return apply_edits(sources.text(model.robot->document.source),
                     rebase_paths(model, folder, options.current_folder));
}

}  // namespace smurf
