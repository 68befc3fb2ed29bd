// SPDX-License-Identifier: BSD-3-Clause
// The files around the robots of the open documents: launch files, files of navigation and RViz.
#include <algorithm>
#include <array>

#include "link/surroundings/wanted_names.hpp"
#include "plan/robots_around.hpp"
#include "smurf-lsp/workspace.hpp"
#include "smurf/confine.hpp"

namespace smurf::lsp {

namespace {

/// A file of parameters may also be read as a part of a model without a robot.
bool has_robot(const FileView& view) { return view.model != nullptr && view.model->robot; }

}  // namespace

const std::vector<std::string>& Workspace::robots_about(const std::string& path) {
  const auto [known, is_new] = robots_about_.try_emplace(path);
  if (!is_new) return known->second;
  ConfinedFiles disk;
  confine_to_projects(disk, std::array{path});
  MemoryFiles files(&disk);
  for (const auto& [name, document] : documents_) files.add(name, document.text);
  known->second = robots_around(path, files, session_.limits());
  return known->second;
}

void Workspace::look_around() {
  if (reach_ == tools::LoadedNames::Reach::surroundings) return;
  reach_ = tools::LoadedNames::Reach::surroundings;
  names_.reset();
}

void Workspace::look_around(const std::string& path) {
  const OpenDocument* open = document(path);
  if (open == nullptr || looked_around_.contains(path)) return;
  const bool is_around = is_surrounding_file(path, open->text);
  if (!is_around && find_companion_kind(path, open->text) == nullptr) return;
  // What was needed before an edit is needed after it.
  if (needs_around_.contains(path)) look_around();
  if (const auto about = robots_about_.find(path); about != robots_about_.end()) {
    if (!about->second.empty()) names_.reset();
    looked_around_.insert(path);
    return;
  }
  const std::vector<FileView> known = views(path);
  if (std::any_of(known.begin(), known.end(), has_robot)) return;
  if (is_around) {
    needs_around_.insert(path);
    look_around();
    if (!views_around(path).empty()) return;
  }
  if (robots_about(path).empty()) return;
  names_.reset();
  looked_around_.insert(path);
}

std::vector<FileView> Workspace::views_around(const std::string& path) {
  std::vector<FileView> found;
  const auto& parts = names().parts();
  const SourceMap& sources = loaded_sources();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].companions == nullptr) continue;
    const Surroundings& around = parts[i].companions->surroundings;
    for (const LaunchFile& one : around.launch_files) {
      if (sources.path(one.source) != path) continue;
      found.push_back(
          {.part = i, .source = one.source, .model = &parts[i].model->model, .launch = &one});
    }
    for (const FrameFile& one : around.frame_files) {
      if (sources.path(one.source) != path) continue;
      found.push_back({.part = i, .source = one.source, .model = &parts[i].model->model});
    }
  }
  return found;
}

const Surroundings& Workspace::surroundings_of(const FileView& view) {
  return names().parts()[view.part].companions->surroundings;
}

}  // namespace smurf::lsp
