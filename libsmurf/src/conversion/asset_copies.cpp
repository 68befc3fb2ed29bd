// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/asset_copies.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "base/findings/limits.hpp"
#include "render/printable.hpp"

namespace smurf {
namespace {

/// A path whose names need no quoting in any format.
std::string plain(std::string_view written) {
  const std::string name = path::normalize(written);
  std::string all;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    std::string one(name.substr(begin, end - begin));
    begin = end + 1;
    if (one.empty() || one == "." || one == "..") continue;
    for (char& c : one) {
      const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                            (c >= 'a' && c <= 'z') || c == '.' || c == '-' || c == '_';
      if (!is_plain) c = '_';
    }
    all = path::join(all, render::safe_file_name(one));
  }
  return all;
}

std::string with_extension(const std::string& file, std::string_view extension) {
  return file.substr(0, file.size() - path::extension(file).size()) + std::string(extension);
}

}  // namespace

FileContent renamed(FileContent content, const AssetCopy& copy) {
  if (content.status == ReadStatus::ok && !copy.names.empty()) {
    content.text = with_other_names(content.text, copy.format, copy.names);
  }
  return content;
}

FileContent RepeatedReads::read(const std::string& file) {
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

CopyPlan::Kind CopyPlan::kind_of(const MeshDependency& named) {
  switch (named.kind) {
  case MeshDependency::Kind::material_library: return Kind::material_library;
  case MeshDependency::Kind::buffer: return Kind::buffer;
  case MeshDependency::Kind::texture: break;
  }
  return Kind::texture;
}

CopyPlan::CopyPlan(const FileReader& files, const Limits& limits, std::string current_folder,
                   std::string folder, std::set<std::string> sources)
    : files_(files),
      reads_(files, limits),
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
  // An OBJ may use a material file of the same name without naming it.
  const std::string materials = with_extension(from, ".mtl");
  const bool has_materials =
      path::to_lower(path::extension(from)) == ".obj" && files_.is_file(materials);
  const std::string first =
      path::join(render::safe_file_name(group), render::safe_file_name(path::file_name(from)));
  const std::string inside = unique(first, from, has_materials);
  if (has_materials) {
    const std::string beside = with_extension(inside, ".mtl");
    neighbours_.emplace(std::pair(group, materials), beside);
    add_copy(materials, beside, group, Kind::material_library);
  }
  add_copy(from, inside, group, Kind::mesh);
  if (has_materials) list_.back().needs.push_back(with_extension(inside, ".mtl"));
  return path::join(current_, path::join(folder_, inside));
}

void CopyPlan::add_copy(const std::string& from, const std::string& inside,
                        const std::string& group, Kind kind) {
  AssetCopy copy{
      from, folder_, inside, {}, {}, kind == Kind::buffer, std::string(path::extension(from))};
  // Any file that is named as a material library is read as one. It may only name textures, because
  // libraries that name libraries could form an endless chain.
  if (kind == Kind::material_library) copy.format = ".mtl";
  const bool names_files = kind == Kind::mesh || kind == Kind::material_library;
  const std::string text = names_files ? reads_.read(from).text : std::string();
  for (const MeshDependency& named : files_named_in(text, copy.format)) {
    if (named.length == 0 || copy.names.contains(named.filename)) continue;
    const auto place = copy_neighbour(named, from, inside, group);
    if (!place) continue;
    copy.names.emplace(named.filename, path::relative(*place, path::parent(inside)));
    copy.needs.push_back(*place);
  }
  list_.push_back(std::move(copy));
}

std::optional<std::string> CopyPlan::copy_neighbour(const MeshDependency& named,
                                                    const std::string& from,
                                                    const std::string& inside,
                                                    const std::string& group) {
  const std::string name = named.path();
  const bool is_relative = !path::is_absolute(name) && name.find(':') == std::string::npos;
  const std::string file = in_first_folder(path::join(path::parent(from), name));
  if (!is_relative || !(files_.is_file(file) || files_.is_denied(file))) return std::nullopt;
  const auto [known, is_new] = neighbours_.try_emplace({group, file});
  if (is_new) {
    const std::string place = unique(path::join(path::parent(inside), plain(name)), file, false);
    known->second = place;
    add_copy(file, place, group, kind_of(named));
    return place;
  }
  return known->second;
}

// Files with the same name from several folders get separate folders. So names are kept, and no
// copy replaces another source.
std::string CopyPlan::unique(const std::string& first, const std::string& from,
                             bool has_materials) {
  std::string inside = first;
  const auto is_taken = [&](const std::string& place) {
    return is_source(place, from) || taken_.contains(place) || is_taken_as_other(place);
  };
  int& number = numbers_.try_emplace(first, 1).first->second;
  // If the path leads through a file, a number in the file name does not help; the first folder
  // gets a new name.
  const bool is_below_file = is_taken_as_other(first);
  const std::string_view front = is_below_file ? std::string_view() : path::parent(first);
  const std::string_view rest = is_below_file ? std::string_view(first) : path::file_name(first);
  while (is_taken(inside) || (has_materials && is_taken(with_extension(inside, ".mtl")))) {
    inside = path::join(path::join(front, std::to_string(++number)), rest);
  }
  taken_.insert(inside);
  if (has_materials) taken_.insert(with_extension(inside, ".mtl"));
  for (std::string above(path::parent(inside)); !above.empty();
       above = std::string(path::parent(above))) {
    if (!taken_folders_.insert(above).second) break;
  }
  return inside;
}

/// Whether the file would have the path of a folder of another copy, or lie below another file.
bool CopyPlan::is_taken_as_other(const std::string& place) const {
  if (taken_folders_.contains(place)) return true;
  for (std::string above(path::parent(place)); !above.empty();
       above = std::string(path::parent(above))) {
    if (taken_.contains(above)) return true;
  }
  return false;
}

bool CopyPlan::is_source(const std::string& inside, const std::string& from) const {
  const std::string place = path::normalize(path::join(current_, path::join(folder_, inside)));
  return place != from && sources_.contains(place);
}

std::string AssetCopy::to() const { return path::join(folder, inside); }

}  // namespace smurf
