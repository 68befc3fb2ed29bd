// SPDX-License-Identifier: BSD-3-Clause
// The folders of the editor: the findings and the definitions in all their files.
#include <utility>

#include "smurf-lsp/workspace.hpp"

namespace smurf::lsp {

Session& Workspace::folder_session() {
  if (!folder_session_) folder_session_.emplace();
  for (const std::string& path : folder_texts_) {
    // A document that was closed without saving has the text on disk again.
    if (document(path) == nullptr) folder_session_->clear_text(path);
  }
  folder_texts_.clear();
  for (const auto& [path, document] : documents_) {
    folder_session_->set_text(path, document.text);
    folder_texts_.insert(path);
  }
  return *folder_session_;
}

Workspace::FolderReport
Workspace::check_folders(std::function<void(std::size_t, std::size_t)> on_progress,
                         std::function<bool()> is_cancelled) {
  Session& session = folder_session();
  CheckSettings settings = settings_of_check();
  settings.on_progress = std::move(on_progress);
  settings.is_cancelled = std::move(is_cancelled);
  Report report = session.check(make_plan(folders_), settings);
  return {std::move(report), &session.sources()};
}

Workspace::Definitions Workspace::definitions() {
  Session& session = folder_session();
  if (!folder_names_) {
    std::vector<std::string> paths = checkable_documents();
    paths.insert(paths.end(), folders_.begin(), folders_.end());
    session.forget_loaded();
    CheckSettings settings = settings_of_check();
    settings.opens_meshes = false;
    folder_names_.emplace(make_plan(paths), settings, session,
                          tools::LoadedNames::Reach::companions);
  }
  Definitions found{{}, &session.loaded_sources()};
  for (const std::vector<Reference>& part : folder_names_->names()) {
    for (const Reference& one : part) {
      if (!one.is_definition) continue;
      const std::string& path = found.sources->path(one.span.source);
      found.list.push_back({std::string(one.name), one.kind, path, one.span});
    }
  }
  return found;
}

}  // namespace smurf::lsp
