// SPDX-License-Identifier: BSD-3-Clause
#include "plan/models_around.hpp"

#include <algorithm>
#include <set>

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "plan/paths.hpp"
#include "smurf/load.hpp"
#include "smurf/plan.hpp"

namespace smurf {
namespace {

/// Limits for files that are read only to find out whether they use another file, because the user
/// did not name them. A robot of 5,000 links is within the limits.
constexpr Limits kNeighbour{
    .file_bytes = 8U << 20U, .yaml_nodes = 50'000, .xml_elements = 100'000, .findings = 0};

/// Gives the loader one file and records the other files that it requests: the files that it lists,
/// as the loader resolves them.
class OnlyMainFile final : public FileReader {
 public:
  OnlyMainFile(const FileReader& files, const std::string& main)
      : files_(files), main_(path::normalize(main)) {}

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override {
    if (path::normalize(path) == main_) return files_.read(path, max_bytes);
    asked_.insert(smurf::identity(path));
    return {};
  }
  bool is_file(const std::string&) const override { return false; }
  std::vector<std::string> list(const std::string&) const override { return {}; }

  const std::set<std::string>& asked() const { return asked_; }

 private:
  const FileReader& files_;
  std::string main_;
  mutable std::set<std::string> asked_;  ///< by identity
};

std::uint64_t bytes_of(const SourceMap& sources) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    bytes += sources.text(SourceId{static_cast<std::uint32_t>(i)}).size();
  }
  return bytes;
}

/// The folder of a file and its parents, each with some of its subfolders.
std::vector<std::string> places_around(const std::string& path, int levels,
                                       std::initializer_list<std::string_view> inner) {
  std::vector<std::string> places;
  std::string folder = path::normalize(path::parent(path));
  for (int level = 0; level <= levels; ++level, folder = path::join(folder, "..")) {
    places.push_back(folder);
    for (const std::string_view name : inner) places.push_back(path::join(folder, name));
  }
  return places;
}

}  // namespace

const ModelsAround::Users& ModelsAround::listing_in(const std::string& folder) {
  const auto [place, is_new] = listing_.try_emplace(folder);
  Users& users = place->second;
  if (!is_new) return users;
  for (const std::string& name : files_.list(folder)) {
    const std::string model = path::join(folder, name);
    if (input_kind(model) != InputKind::model || is_exhausted()) continue;
    const OnlyMainFile only(files_, model);
    SourceMap sources;
    DiagnosticSink ignored(kNeighbour.findings);
    LoadContext context{sources, only, ignored, kNeighbour, {}};
    load_model(model, context);
    bytes_ += bytes_of(sources);
    for (const std::string& file : only.asked()) {
      users[file].push_back({model, identity(model), {}, true});
    }
  }
  return users;
}

const ModelsAround::Users& ModelsAround::using_in(const std::string& folder) {
  const auto [place, is_new] = using_.try_emplace(folder);
  Users& users = place->second;
  if (!is_new) return users;
  for (const std::string& name : files_.list(folder)) {
    const std::string candidate = path::join(folder, name);
    const InputKind kind = input_kind(candidate);
    // Most of these are no robots.
    if (is_one_of(path::to_lower(path::extension(candidate)), {".xml", ".sdf", ".world"})) continue;
    if ((kind != InputKind::model && kind != InputKind::urdf) || is_exhausted()) continue;
    SourceMap sources;
    DiagnosticSink ignored(kNeighbour.findings);
    LoadContext context{sources, files_, ignored, kNeighbour, {}};
    const LinkedModel loaded = load_model(candidate, context);
    bytes_ += bytes_of(sources);
    std::set<std::string> used;
    for (const MeshReference& mesh : loaded.meshes) {
      if (mesh.exists) used.insert(identity(mesh.path));
    }
    for (const std::string& file : used) {
      users[file].push_back(
          {candidate, identity(candidate), identity(loaded.urdf_path), kind == InputKind::model});
    }
  }
  return users;
}

std::vector<std::string> ModelsAround::listing(const std::string& path) {
  const std::string wanted = identity(path);
  std::vector<std::string> models;
  std::set<std::string> seen;
  for (const std::string& place : places_around(path, 1, {"smurf"})) {
    const Users& users = listing_in(place);
    const auto found = users.find(wanted);
    if (found == users.end()) continue;
    for (const User& user : found->second) {
      if (seen.insert(user.identity).second) models.push_back(user.path);
    }
  }
  std::sort(models.begin(), models.end());
  return models;
}

std::vector<std::string> ModelsAround::using_resource(const std::string& path) {
  const std::string wanted = identity(path);
  std::vector<std::string> models;
  std::vector<User> robots;
  std::set<std::string> seen, listed_urdfs;
  for (const std::string& place : places_around(path, 3, {"smurf", "urdf"})) {
    const Users& users = using_in(place);
    const auto found = users.find(wanted);
    if (found == users.end()) continue;
    for (const User& user : found->second) {
      if (!seen.insert(user.identity).second) continue;
      if (!user.is_model) {
        robots.push_back(user);
        continue;
      }
      models.push_back(user.path);
      listed_urdfs.insert(user.urdf);
    }
  }
  for (const User& robot : robots) {
    if (!listed_urdfs.contains(robot.identity)) models.push_back(robot.path);
  }
  std::sort(models.begin(), models.end());
  return models;
}

}  // namespace smurf
