// SPDX-License-Identifier: BSD-3-Clause
// Copies of the files that models name: chooses a place for each. Nothing is written here.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/flatten.hpp"
#include "smurf/limits.hpp"
#include "smurf/mesh.hpp"
#include "smurf/write_scene.hpp"

namespace smurf {

/// A file that is copied to a folder which the user names.
struct AssetCopy {
  std::string from;
  std::string folder;  ///< chosen by the user
  std::string inside;  ///< path relative to the folder
  FileNames names;     ///< new names of the files that it names, by their written names
  std::vector<std::string> needs{};  ///< AssetCopy::inside of the copies of these files
  bool is_buffer = false;            ///< belongs to a glTF, and may be a .bin
  std::string format{};              ///< the extension that determines how it names files

  std::string to() const;
};
using AssetCopies = std::vector<AssetCopy>;

/// Reads files to copy. Links can give one file thousands of names, so the total of repeated reads
/// is limited to the size of a scene.
class RepeatedReads {
 public:
  RepeatedReads(const FileReader& files, const Limits& limits) : files_(files), limits_(limits) {}

  FileContent read(const std::string& file);

 private:
  const FileReader& files_;
  const Limits& limits_;
  std::set<std::string> seen_;  ///< by identity
  std::uint64_t bytes_ = 0;     ///< bytes of files that were read before
};

/// Finds a place for every copy.
class CopyPlan {
 public:
  /// The user chose `folder`. No copy replaces one of `sources`, which are absolute paths.
  CopyPlan(const FileReader& files, const Limits& limits, std::string current_folder,
           std::string folder, std::set<std::string> sources);

  /// The absolute path of the copy of `file`, in a folder `group`. A second call with the same file
  /// returns the same path. None if the file does not exist. The files that a mesh names, relative
  /// to itself, are also copied.
  std::optional<std::string> copy_of(const std::string& file, const std::string& group);
  AssetCopies take() { return std::move(list_); }

 private:
  /// Files other than textures and buffers may name further files.
  enum class Kind : std::uint8_t { mesh, material_library, texture, buffer };

  static Kind kind_of(const MeshDependency& named);
  std::string in_first_folder(const std::string& file);
  std::string add(const std::string& from, const std::string& group);
  void add_copy(const std::string& from, const std::string& inside, const std::string& group,
                Kind kind);
  std::optional<std::string> copy_neighbour(const MeshDependency& named, const std::string& from,
                                            const std::string& inside, const std::string& group);
  std::string unique(const std::string& first, const std::string& from, bool has_materials);
  bool is_taken_as_other(const std::string& place) const;
  bool is_source(const std::string& inside, const std::string& from) const;

  const FileReader& files_;
  RepeatedReads reads_;  ///< bytes of files that are searched for further names
  std::string current_, folder_;
  std::set<std::string> sources_;
  std::map<std::pair<std::string, std::string>, std::optional<std::string>> copies_;
  std::map<std::pair<std::string, std::string>, std::string> neighbours_;  ///< in the folder
  std::set<std::string> taken_, taken_folders_;
  std::map<std::string, int> numbers_;
  std::map<std::string, std::string> folders_;        ///< the first name, by identity
  std::map<std::string, std::string> first_folders_;  ///< by identity
  AssetCopies list_;
};

/// The data of a copy: those of its original, with the new names.
FileContent renamed(FileContent content, const AssetCopy& copy);

/// The path of a file for `files`; in an archive, it begins with the path of the archive.
std::string known_name(const std::string& absolute, const std::string& current,
                       const FileReader& files);

/// Reads triangles and images of files relative to the output's folder. A file that will be copied
/// is read from its original. `files` and `limits` must outlive the result.
MeshSource mesh_source(const FlattenOptions& options, const AssetCopies& copies,
                       const FileReader& files, const Limits& limits);

}  // namespace smurf
