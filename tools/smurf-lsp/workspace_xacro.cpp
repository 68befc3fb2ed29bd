// SPDX-License-Identifier: BSD-3-Clause
// The xacro files around the open documents.
#include <algorithm>
#include <array>

#include "base/files/path.hpp"
#include "smurf-lsp/workspace.hpp"
#include "smurf/confine.hpp"

namespace smurf::lsp {

void Workspace::forget_xacro_files() {
  xacro_files_.clear();
  xacro_families_.clear();
}

const XacroFiles& Workspace::xacro_files_around(const std::string& path) {
  const std::string project = project_around(path);
  const auto known = xacro_files_.find(project);
  if (known != xacro_files_.end()) return known->second;
  ConfinedFiles disk;
  confine_to_projects(disk, std::array{path});
  MemoryFiles files(&disk);
  for (const auto& [name, document] : documents_) files.add(name, document.text);
  return xacro_files_.emplace(project, smurf::xacro_files_around(path, files, session_.limits()))
      .first->second;
}

const tools::XacroFamily* Workspace::xacro_family(const std::string& path) {
  const OpenDocument* open = document(path);
  if (open == nullptr || !xacro::is_xacro_file(path)) return nullptr;
  const auto [known, is_new] = xacro_families_.try_emplace(path);
  tools::XacroFamily& family = known->second;
  if (!is_new) return &family;
  ConfinedFiles disk;
  confine_to_projects(disk, std::array{path});
  family.add(path, open->text);
  for (const std::string& other : xacro_files_around(path).family_of(path)) {
    if (other == path) continue;
    const OpenDocument* edited = document(other);
    family.add(other, edited != nullptr ? edited->text
                                        : disk.read(other, session_.limits().file_bytes).text);
  }
  return &family;
}

std::vector<std::string> Workspace::xacro_files_meant(const std::string& written,
                                                      const std::string& from) {
  return xacro_files_around(from).meant_by(written, from);
}

std::optional<std::string> Workspace::package_folder(const std::string& name,
                                                     const std::string& from) {
  ConfinedFiles disk;
  confine_to_projects(disk, std::array{from});
  const std::string tag = "<name>" + name + "</name>";
  std::set<std::string> seen;
  for (const std::string& file : xacro_files_around(from).files()) {
    constexpr int kMostLevels = 8;
    std::string folder(path::parent(file));
    for (int level = 0; level < kMostLevels && seen.insert(folder).second; ++level) {
      const FileContent manifest =
          disk.read(path::join(folder, "package.xml"), session_.limits().file_bytes);
      if (manifest.text.find(tag) != std::string::npos) return folder;
      folder = path::join(folder, "..");
    }
  }
  return std::nullopt;
}

tools::RenamedXacro Workspace::rename_xacro(const std::string& path,
                                            const tools::XacroRename& rename) {
  ConfinedFiles changeable;
  confine_changes(changeable);
  put_texts();
  tools::RenamedXacro renamed = tools::rename_in_xacro(xacro_files_around(path), path, rename,
                                                       settings_of_check(), session_, changeable);
  for (const FixedText& file : renamed.texts) changed_.insert(file.path);
  put_texts();
  return renamed;
}

std::vector<Workspace::Expanded> Workspace::expansions_of(const std::string& path) {
  std::vector<Expanded> found;
  for (const tools::LoadedNames::Part& part : names().parts()) {
    if (part.model == nullptr || !part.model->model.robot) continue;
    const auto one = part.expansions->find(part.model->model.robot->document.source);
    if (one == part.expansions->end()) continue;
    Expanded expanded{&one->second, {}};
    for (const xml::Document& document : one->second.documents) {
      if (loaded_sources().path(document.source) == path) expanded.sources.insert(document.source);
    }
    if (!expanded.sources.empty()) found.push_back(std::move(expanded));
  }
  return found;
}

}  // namespace smurf::lsp
