// SPDX-License-Identifier: BSD-3-Clause
#include "common/asset_copies.hpp"

#include <filesystem>
#include <system_error>

#include "base/limits.hpp"
#include "base/path.hpp"
#include "common/output.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {
namespace {

namespace fs = std::filesystem;

std::string with_extension(const std::string& file, std::string_view extension) {
  return file.substr(0, file.size() - path::extension(file).size()) + std::string(extension);
}

/// Reads files to copy. A model may name a file any number of times, so repeated reads have a
/// limit.
class RepeatedBytes {
 public:
  RepeatedBytes(const FileReader& files, const Limits& limits) : files_(files), limits_(limits) {}

  FileContent read(const std::string& file) {
    FileContent content = files_.read(file, limits_.mesh_bytes);
    if (content.status != ReadStatus::ok) {
      content.reason = "cannot read '" + file + "': " + content.reason;
    } else if (!seen_.insert(files_.identity(file)).second) {
      bytes_ += content.text.size();
      if (bytes_ > limits_.scene_bytes) {
        return {ReadStatus::too_large,
                {},
                "copies of files that are copied already have more than " +
                    std::to_string(limits_.scene_bytes) + " bytes; " + raise_limit("scene-bytes")};
      }
    }
    return content;
  }

 private:
  const FileReader& files_;
  const Limits& limits_;
  std::set<std::string> seen_;  ///< by identity
  std::uint64_t bytes_ = 0;
};

bool is_in_place(const AssetCopy& copy) {
  std::error_code error;
  return fs::equivalent(copy.from, copy.to(), error);
}

}  // namespace

CopyPlan::CopyPlan(const FileReader& files, std::string current_folder, std::string folder,
                   std::set<std::string> sources)
    : files_(files),
      current_(std::move(current_folder)),
      folder_(std::move(folder)),
      sources_(std::move(sources)) {}

std::optional<std::string> CopyPlan::copy_of(const std::string& file, const std::string& group) {
  const std::string from = in_first_folder(file);
  const auto [known, is_new] = copies_.try_emplace({group, from});
  if (is_new && (files_.is_file(from) || files_.is_denied(from))) known->second = add(from, group);
  return known->second;
}

// Links can give one folder thousands of names; each would get another copy.
std::string CopyPlan::in_first_folder(const std::string& file) {
  const std::string folder(path::parent(file));
  const auto [known, is_new] = folders_.try_emplace(folder);
  if (is_new) {
    known->second = first_folders_.try_emplace(files_.identity(folder), folder).first->second;
  }
  return path::join(known->second, path::file_name(file));
}

std::string CopyPlan::add(const std::string& from, const std::string& group) {
  // The materials of an OBJ are in a file of the same name.
  const std::string materials = with_extension(from, ".mtl");
  const bool has_materials =
      path::to_lower(path::extension(from)) == ".obj" && files_.is_file(materials);
  const std::string inside = unique(safe_name(group), from, has_materials);
  const AssetCopy copy{from, folder_, inside};
  list_.push_back(copy);
  if (has_materials) list_.push_back({materials, folder_, with_extension(inside, ".mtl")});
  return path::join(current_, copy.to());
}

// Files with one name from several folders get separate folders. So names stay, and no copy
// replaces another source.
std::string CopyPlan::unique(const std::string& group, const std::string& from,
                             bool has_materials) {
  const std::string name = safe_name(path::file_name(from));
  std::string inside = path::join(group, name);
  const auto is_taken = [&](const std::string& place) {
    return is_source(place, from) || taken_.contains(place);
  };
  int& number = numbers_.try_emplace(inside, 1).first->second;
  while (is_taken(inside) || (has_materials && is_taken(with_extension(inside, ".mtl")))) {
    inside = path::join(path::join(group, std::to_string(++number)), name);
  }
  taken_.insert(inside);
  if (has_materials) taken_.insert(with_extension(inside, ".mtl"));
  return inside;
}

bool CopyPlan::is_source(const std::string& inside, const std::string& from) const {
  const std::string place = path::normalize(path::join(current_, path::join(folder_, inside)));
  return place != from && sources_.contains(place);
}

std::string AssetCopy::to() const { return path::join(folder, inside); }

std::vector<std::string> places_of(const AssetCopies& copies, const InputFiles& inputs) {
  std::vector<std::string> places;
  for (const AssetCopy& copy : copies) {
    inputs.add(copy.from);
    if (!is_in_place(copy)) places.push_back(copy.to());
  }
  return places;
}

bool copy_files(std::string_view tool, const AssetCopies& copies, const FileReader& files,
                const Limits& limits, bool overwrite, const std::function<bool()>& write_result) {
  const DiskFiles disk;
  AssetCopies missing;
  for (const AssetCopy& copy : copies) {
    if (is_in_place(copy)) continue;
    if (input_kind(copy.to()) != InputKind::resource) {
      complain(tool, "cannot copy '" + copy.from +
                         "': its name is not that of a mesh or image; nothing was written");
      return false;
    }
    const FileContent there = disk.read(copy.to(), limits.mesh_bytes);
    if (there.status == ReadStatus::not_found || overwrite) {
      missing.push_back(copy);
    } else if (there.text != files.read(copy.from, limits.mesh_bytes).text) {
      complain(tool, "cannot write '" + copy.to() +
                         "': another file is there; see --overwrite; nothing was written");
      return false;
    }
  }
  RepeatedBytes repeated(files, limits);
  std::vector<OutputFile> outputs;
  for (const AssetCopy& copy : missing) {
    outputs.push_back({.folder = copy.folder, .path = copy.inside, .read = [&repeated, &copy] {
                         return repeated.read(copy.from);
                       }});
  }
  return write_files(tool, outputs, overwrite, write_result);
}

}  // namespace smurf::tools
