// SPDX-License-Identifier: BSD-3-Clause
// Nothing here depends on the order in which a file system lists a folder.
#include "common/discover.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "base/path.hpp"
#include "common/input.hpp"
#include "smurf/load.hpp"

namespace smurf::tools {
namespace {

bool is_sought(std::string_view path) {
  const InputKind kind = kind_of(path);
  return kind == InputKind::model || kind == InputKind::scene || kind == InputKind::urdf;
}

enum class Entry : std::uint8_t { file, folder, link, other };

/// As the folder says it: these do not ask the file system for each, as the status would.
Entry kind_of_entry(const std::filesystem::directory_entry& entry) {
  std::error_code vanished;
  if (entry.is_symlink(vanished)) return Entry::link;
  if (entry.is_directory(vanished)) return Entry::folder;
  return entry.is_regular_file(vanished) ? Entry::file : Entry::other;
}

class Search {
 public:
  explicit Search(const LeftOut& is_left_out) : is_left_out_(is_left_out) {}

  Found run(const std::string& folder) {
    walk(folder);
    // Links come last, so that a file is known by its own path if that is inside the folder.
    for (std::size_t i = 0; i < links_.size(); ++i) follow(std::string(links_[i]));
    std::sort(found_.files.begin(), found_.files.end());
    std::sort(found_.unreadable.begin(), found_.unreadable.end());
    return std::move(found_);
  }

 private:
  bool is_left_out(const std::string& path, bool is_folder) {
    if (!is_left_out_ || !is_left_out_(path, is_folder)) return false;
    ++found_.left_out;
    return true;
  }

  bool is_new(const struct stat& status) {
    return seen_.insert({status.st_dev, status.st_ino}).second;
  }

  void fail(const std::string& path, int error) {
    found_.unreadable.push_back("'" + path + "': " + std::generic_category().message(error));
  }

  void walk(const std::string& folder) {
    struct stat status {};
    if (::stat(folder.c_str(), &status) != 0) return fail(folder, errno);
    if (!is_new(status)) return;
    std::error_code error;
    std::map<std::string, Entry> entries;
    std::filesystem::directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
      entries.emplace(entry->path().filename().string(), kind_of_entry(*entry));
    }
    if (error) fail(folder, error.value());
    for (const auto& [name, kind] : entries) {
      if (!name.starts_with('.')) visit(path::join(folder, name), kind);
    }
  }

  void visit(const std::string& path, Entry kind) {
    if (kind == Entry::link) {
      links_.push_back(path);
    } else if (kind == Entry::folder) {
      if (!is_left_out(path, true)) walk(path);
    } else if (kind == Entry::file && is_sought(path)) {
      struct stat status {};
      if (::lstat(path.c_str(), &status) != 0) return fail(path, errno);
      add(path, status);
    }
  }

  void follow(const std::string& link) {
    struct stat status {};
    if (::stat(link.c_str(), &status) != 0) {
      if (is_sought(link)) fail(link, errno);
    } else if (S_ISDIR(status.st_mode)) {
      // To git a link is a file, whatever it leads to.
      if (!is_left_out(link, false)) walk(link);
    } else if (S_ISREG(status.st_mode) && is_sought(link)) {
      add(link, status);
    }
  }

  void add(const std::string& path, const struct stat& status) {
    if (!is_left_out(path, false) && is_new(status)) found_.files.push_back(path);
  }

  const LeftOut& is_left_out_;
  Found found_;
  std::vector<std::string> links_;
  std::set<std::pair<dev_t, ino_t>> seen_;
};

/// What a file may demand that is only looked at to find out whether it uses another one: whoever
/// names a file has not asked for the ones around it. A robot of 5,000 links is within.
constexpr Limits kNeighbour{
    .file_bytes = 8U << 20U, .yaml_nodes = 50'000, .xml_elements = 100'000, .findings = 0};

/// Shows the loader one file and notes which others it asks for: they are what the file lists,
/// resolved as the loader resolves them.
class OnlyMainFile final : public FileReader {
 public:
  OnlyMainFile(const FileReader& files, const std::string& main)
      : files_(files), main_(path::normalize(main)) {}

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override {
    if (path::normalize(path) == main_) return files_.read(path, max_bytes);
    asked_.push_back(path);
    return {};
  }
  bool is_file(const std::string&) const override { return false; }
  std::vector<std::string> list(const std::string&) const override { return {}; }

  bool was_asked_for(const std::string& wanted) const {
    return std::any_of(asked_.begin(), asked_.end(),
                       [&](const std::string& path) { return identity(path) == wanted; });
  }

 private:
  const FileReader& files_;
  std::string main_;
  mutable std::vector<std::string> asked_;
};

bool lists(const std::string& model, const std::string& wanted, const FileReader& files) {
  const OnlyMainFile only(files, model);
  SourceMap sources;
  DiagnosticSink ignored(kNeighbour.findings);
  LoadContext context{sources, only, ignored, kNeighbour, {}};
  load_model(model, context);
  return only.was_asked_for(wanted);
}

/// The URDF of a model that uses the file `wanted`, by its identity.
std::optional<std::string> urdf_of_user(const std::string& model, const std::string& wanted,
                                        const FileReader& files) {
  SourceMap sources;
  DiagnosticSink ignored(kNeighbour.findings);
  LoadContext context{sources, files, ignored, kNeighbour, {}};
  const LinkedModel loaded = load_model(model, context);
  const bool is_user =
      std::any_of(loaded.meshes.begin(), loaded.meshes.end(), [&](const MeshReference& mesh) {
        return mesh.exists && identity(mesh.path) == wanted;
      });
  if (!is_user) return std::nullopt;
  return identity(loaded.urdf_path);
}

}  // namespace

Found find_inputs(const std::string& folder, const LeftOut& is_left_out) {
  return Search(is_left_out).run(folder);
}

std::vector<std::string> models_listing(const std::string& path, const FileReader& files) {
  const std::string folder = path::normalize(path::parent(path));
  const std::string wanted = identity(path);
  const std::string above = path::join(folder, "..");
  std::vector<std::string> models;
  std::set<std::string> seen;
  for (const std::string& place :
       {folder, path::join(folder, "smurf"), above, path::join(above, "smurf")}) {
    for (const std::string& name : files.list(place)) {
      const std::string model = path::join(place, name);
      if (kind_of(model) != InputKind::model || !seen.insert(identity(model)).second) continue;
      if (lists(model, wanted, files)) models.push_back(model);
    }
  }
  std::sort(models.begin(), models.end());
  return models;
}

std::vector<std::string> models_using(const std::string& path, const FileReader& files) {
  const std::string wanted = identity(path);
  std::vector<std::string> models;
  std::vector<std::string> robots;
  std::set<std::string> seen, listed_urdfs;
  std::string folder = path::normalize(path::parent(path));
  for (int level = 0; level <= 3; ++level, folder = path::join(folder, "..")) {
    for (const std::string& place :
         {folder, path::join(folder, "smurf"), path::join(folder, "urdf")}) {
      for (const std::string& name : files.list(place)) {
        const std::string candidate = path::join(place, name);
        const InputKind kind = kind_of(candidate);
        if (kind != InputKind::model && kind != InputKind::urdf) continue;
        if (!seen.insert(identity(candidate)).second) continue;
        const auto urdf = urdf_of_user(candidate, wanted, files);
        if (!urdf) continue;
        (kind == InputKind::model ? models : robots).push_back(candidate);
        if (kind == InputKind::model) listed_urdfs.insert(*urdf);
      }
    }
  }
  for (const std::string& robot : robots) {
    if (!listed_urdfs.contains(identity(robot))) models.push_back(robot);
  }
  std::sort(models.begin(), models.end());
  return models;
}

}  // namespace smurf::tools
