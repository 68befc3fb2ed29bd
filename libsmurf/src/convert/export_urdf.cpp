// SPDX-License-Identifier: BSD-3-Clause
// The export edits bytes; it never prints a tree (urdfdom's own export loses names, extensions,
// comments and digits).
#include "base/edits.hpp"
#include "base/path.hpp"
#include "smurf/convert.hpp"

namespace smurf {
namespace {

bool is_relative_path(std::string_view filename) {
  return !filename.empty() && !path::is_absolute(filename) &&
         filename.find("://") == std::string_view::npos;
}

}  // namespace

std::string export_urdf(const LinkedModel& model, const SourceMap& sources,
                        const UrdfExport& options) {
  const auto absolute = [&](std::string_view path) {
    return path::join(options.current_folder, path);
  };
  const std::string output_folder = absolute(options.output_folder);
  std::vector<Edit> edits;
  for (const MeshReference& mesh : model.meshes) {
    if (!is_relative_path(mesh.filename)) continue;
    const std::string target = absolute(mesh.path);
    if (path::join(output_folder, mesh.filename) == target) continue;  // resolves as it is written
    edits.push_back({mesh.span, escape_xml(path::relative(target, output_folder))});
  }
  return apply_edits(sources.text(model.robot->document.source), edits);
}

}  // namespace smurf
