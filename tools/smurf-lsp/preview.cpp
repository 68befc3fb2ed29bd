// SPDX-License-Identifier: BSD-3-Clause
// The model or scene of a document as a page in 3D, which an editor shows beside the text.
#include "base/files/path.hpp"
#include "common/convert/pictured_scene.hpp"
#include "common/files/input.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::lsp {
namespace {

/// What is shown of a file: itself, or the model that reads it.
std::string shown_path(const std::string& path, const std::vector<FileView>& views) {
  if (input_kind(path) != InputKind::annotation || views.empty()) return path;
  const FileView& first = views.front();
  return first.model != nullptr ? first.model->path : first.scene->path;
}

}  // namespace

Workspace::Picture Workspace::picture(const std::string& path) {
  const std::string shown = shown_path(path, views(path));
  const SceneFormat& format = *find_scene_format("html");
  if (!format.obstacle().empty())
    throw RequestError(kRequestFailed, std::string(format.obstacle()));
  names_.reset();
  session_.forget_loaded();
  tools::PicturedScene scene(session_, shown, settings_of_check(),
                             std::string(path::parent(shown)));
  const std::optional<SceneExport> to_write = scene.to_write();
  Picture picture;
  if (const Diagnostic* error = tools::first_error(scene.loaded())) {
    // An error in an expanded robot belongs to a xacro.
    const std::vector<Diagnostic> placed = session_.settle(scene.loaded(), {*error});
    picture.why = placed.empty() ? *error : placed.front();
  }
  if (!to_write || tools::is_broken_off(picture.why ? &*picture.why : nullptr)) return picture;
  picture.page = format.write(*to_write);
  if (picture.page.size() > to_write->most_bytes) picture.page.clear();
  return picture;
}

/// {page: the HTML or null, problem: {uri, range, message, ...} or null}
Json picture(Context& context, const Json& params) {
  const std::string path = path_in(params);
  if (path.empty()) throw RequestError(kInvalidParams, "the request names no file");
  Workspace::Picture made = context.workspace.picture(path);
  Json answer = {{"page", nullptr}, {"problem", nullptr}};
  if (!made.page.empty()) answer["page"] = std::move(made.page);
  if (made.why) {
    const SourceMap& sources = context.workspace.loaded_sources();
    answer["problem"] = to_json(context, *made.why, sources);
    answer["problem"]["uri"] = context.workspace.uri_of(sources.path(made.why->span.source));
  }
  return answer;
}

}  // namespace smurf::lsp
