// SPDX-License-Identifier: BSD-3-Clause
// Pages that show a scene, or two versions of one, in a browser: the viewer of web/viewer with the
// scene as JSON in it.
#include "write/pages/viewer_data.hpp"
#include "write/viewer_page.hpp"

namespace smurf::scene_html_file {
namespace {

std::string write(const SceneExport& scene) {
  const std::optional<std::string> data = viewer_data(scene, nullptr);
  if (!data) return std::string(scene.most_bytes + 1, ' ');
  return page_around(viewer_page(), *data);
}

std::string_view obstacle() {
  if (!viewer_page().head.empty()) return {};
  return "this build has no viewer: run scripts/viewer in the sources, and build again";
}

}  // namespace

extern constinit const SceneFormat scene_html{
    .name = "html",
    .help = "a page that shows the scene in a browser, without network",
    .write = write,
    .has_collisions = true,
    .has_meshes_inside = true,
    .obstacle = obstacle};

}  // namespace smurf::scene_html_file

namespace smurf {

std::string write_both_versions(const SceneExport& before, const SceneExport& after) {
  if (!scene_html_file::obstacle().empty()) return {};
  const std::optional<std::string> data = viewer_data(after, &before);
  return data ? page_around(viewer_page(), *data) : std::string();
}

}  // namespace smurf
