// SPDX-License-Identifier: BSD-3-Clause
// Copies of the files that models name: chooses a place for each, and writes all of them or none.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/input.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/mesh.hpp"

namespace smurf::tools {

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

/// False when the copy would be the file itself.
std::vector<std::string> places_of(const AssetCopies& copies, const InputFiles& inputs);

/// Copies the files and then calls `write_result`; writes either all files or none. Reports
/// errors and returns false. The names come from the model, so only files with the extension
/// of a mesh, an image or a buffer are copied, and existing files are kept unless
/// `overwrite`.
bool copy_files(std::string_view tool, const AssetCopies& copies, const FileReader& files,
                const Limits& limits, bool overwrite, const std::function<bool()>& write_result);

}  // namespace smurf::tools
