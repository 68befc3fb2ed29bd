// SPDX-License-Identifier: BSD-3-Clause
// Reads mesh files, and the files that they name.
#include <algorithm>
#include <mutex>
#include <set>

#include "base/files/path.hpp"
#include "link/file_index.hpp"
#include "mesh/mesh_reader.hpp"
#include "smurf/mesh.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf {
namespace {

/// Reads the files that a mesh names, in total as many bytes as a mesh may have.
MeshNeighbours neighbours_of(const std::string& path, const FileReader& files,
                             const Limits& limits) {
  return [&, bytes_left = limits.mesh_bytes](const std::string& name) mutable {
    FileContent neighbour = files.read(path::join(path::parent(path), name), bytes_left);
    bytes_left -= neighbour.text.size();
    return neighbour;
  };
}

class Dependencies {
 public:
  /// Material libraries of all meshes, and their textures.
  using Libraries = std::map<std::string, std::vector<MeshDependency>>;

  Dependencies(const std::string& mesh_path, const FileReader& files, Libraries& libraries,
               std::mutex& mutex)
      : folder_(path::parent(mesh_path)), files_(files), libraries_(libraries), mutex_(mutex) {}

  std::vector<MeshDependency> lost(const std::vector<MeshDependency>& dependencies) {
    for (const MeshDependency& dependency : dependencies) check(dependency);
    return std::move(lost_);
  }

 private:
  void check(const MeshDependency& dependency) {
    if (!seen_.insert(dependency.filename).second) return;
    const std::string path = path::join(folder_, dependency.path());
    if (!files_.is_file(path)) {
      lost_.push_back(dependency);
      lost_.back().is_denied = files_.is_denied(path);
    } else if (dependency.kind == MeshDependency::Kind::material_library) {
      const std::string library = files_.identity(path);
      if (!seen_libraries_.insert(library).second) return;
      for (const MeshDependency& texture : textures_of(library, path)) check(texture);
    }
  }

  const std::vector<MeshDependency>& textures_of(const std::string& library,
                                                 const std::string& path) {
    const std::lock_guard lock(mutex_);
    constexpr std::uint64_t kMostBytes = 1U << 20U;
    const auto [known, is_new] = libraries_.try_emplace(library);
    if (is_new) known->second = read_material_library(files_.read(path, kMostBytes).text);
    return known->second;
  }

  std::string folder_;
  const FileReader& files_;
  Libraries& libraries_;
  std::mutex& mutex_;  ///< of the libraries
  std::set<std::string> seen_, seen_libraries_;
  std::vector<MeshDependency> lost_;
};

}  // namespace

struct MeshLibrary::Shelves {
  struct Entry {
    std::mutex mutex;  ///< held by the thread that reads the file
    bool is_read = false;
    MeshFile file;
  };
  std::mutex mutex;                         ///< of the two maps
  std::map<std::string, std::string> keys;  ///< of the files, by path
  std::map<std::string, Entry> entries;     ///< one for all names that links give to a file
  std::mutex texture_mutex;
  Dependencies::Libraries textures;  ///< of material libraries

  Entry& entry_of(const std::string& path, const FileReader& files) {
    const std::lock_guard lock(mutex);
    const auto [key, is_new_name] = keys.try_emplace(path);
    if (is_new_name) key->second = key_of_file(path, files);
    return entries[key->second];
  }
};

MeshLibrary::MeshLibrary() : shelves_(std::make_unique<Shelves>()) {}
MeshLibrary::~MeshLibrary() = default;
MeshLibrary::MeshLibrary(MeshLibrary&& other) noexcept = default;
MeshLibrary& MeshLibrary::operator=(MeshLibrary&& other) noexcept = default;

const MeshFile& MeshLibrary::read(const std::string& path, const FileReader& files,
                                  const Limits& limits) {
  Shelves::Entry& entry = shelves_->entry_of(path, files);
  const std::lock_guard lock(entry.mutex);
  MeshFile& file = entry.file;
  if (entry.is_read) return file;
  const FileContent content = files.read(path, limits.mesh_bytes);
  file.status = content.status;
  file.reason = content.reason;
  if (content.status != ReadStatus::ok) {
    entry.is_read = true;
    return file;
  }
  file.facts =
      read_mesh(content.text, path::extension(path), {}, neighbours_of(path, files, limits));
  file.lost = Dependencies(path, files, shelves_->textures, shelves_->texture_mutex)
                  .lost(file.facts.dependencies);
  entry.is_read = true;  // only now: reading may end with the time of the model
  return file;
}

MeshTriangles read_triangles_of(const std::string& path, const FileReader& files,
                                const Limits& limits, TexturePoints texture_points) {
  const FileContent content = files.read(path, limits.mesh_bytes);
  if (content.status == ReadStatus::ok) {
    return read_triangles(content.text, path::extension(path), neighbours_of(path, files, limits),
                          texture_points);
  }
  if (content.status == ReadStatus::not_found) return {{}, {}, "is not there"};
  return {{}, {}, "cannot be read: " + content.reason};
}

}  // namespace smurf
