// SPDX-License-Identifier: BSD-3-Clause
#include "smurfs-flatten/assets.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include "base/path.hpp"
#include "common/output.hpp"

namespace smurf::tools {
namespace {

namespace fs = std::filesystem;

/// Files of an archive go by the name that the archive was given.
std::string known_name(const std::string& absolute, const std::string& current,
                       const FileReader& files) {
  return files.is_file(absolute) ? absolute : path::relative(absolute, current);
}

class Redirection {
 public:
  Redirection(const std::string& folder, const FlattenOptions& options, const FileReader& files)
      : files_(files),
        current_(options.current_folder),
        folder_(path::join(options.current_folder, folder)),
        output_(path::join(options.current_folder, options.output_folder)) {}

  /// What the file is called from now on; `file` is relative to the output's folder.
  std::string redirect(const std::string& file, const std::string& group) {
    const std::string from =
        known_name(path::normalize(path::join(output_, file)), current_, files_);
    const auto [known, is_new] = copies_.try_emplace({group, from});
    if (is_new) {
      const bool is_known = files_.is_file(from) || files_.is_denied(from);
      known->second = is_known ? path::relative(add(from, group), output_) : file;
    }
    return known->second;
  }

  AssetCopies take() { return std::move(list_); }

 private:
  std::string add(const std::string& from, const std::string& group) {
    const std::string to = unique(path::join(folder_, group), from);
    list_.emplace_back(from, to);
    // An OBJ names its materials in a file of the same name.
    const std::string materials = with_extension(from, ".mtl");
    if (path::to_lower(path::extension(from)) == ".obj" && files_.is_file(materials)) {
      list_.emplace_back(materials, path::join(path::parent(to), path::file_name(materials)));
    }
    return to;
  }

  static std::string with_extension(const std::string& file, std::string_view extension) {
    return file.substr(0, file.size() - path::extension(file).size()) + std::string(extension);
  }

  /// Files of one name from several folders get folders of their own, so that the name stays.
  std::string unique(const std::string& folder, const std::string& from) {
    const std::string name(path::file_name(from));
    std::string to = path::join(folder, name);
    for (int number = 2; !taken_.insert(to).second; ++number) {
      to = path::join(path::join(folder, std::to_string(number)), name);
    }
    return to;
  }

  const FileReader& files_;
  std::string current_, folder_, output_;
  std::map<std::pair<std::string, std::string>, std::string> copies_;
  std::set<std::string> taken_;
  AssetCopies list_;
};

}  // namespace

AssetCopies redirect_assets(FlatScene& flat, const std::string& folder,
                            const FlattenOptions& options, const FileReader& files) {
  Redirection redirection(folder, options, files);
  for (FlatModel& model : flat.models) {
    for (auto& [written, file] : model.resources) file = redirection.redirect(file, model.id);
  }
  for (FlatInstance& instance : flat.instances) {
    for (FlatShape& shape : instance.shapes) {
      if (auto* map = std::get_if<FlatHeightmap>(&shape.geometry)) {
        map->file = redirection.redirect(map->file, "heightmaps");
      } else if (auto* mesh = std::get_if<FlatMesh>(&shape.geometry)) {
        mesh->file = redirection.redirect(mesh->file, "meshes");
      }
    }
  }
  return redirection.take();
}

MeshSource mesh_source(const FlattenOptions& options, const AssetCopies& copies,
                       const FileReader& files, const Limits& limits) {
  std::map<std::string, std::string> origins;  // of copies that are not there yet
  for (const auto& [from, to] : copies) origins.emplace(to, from);
  const std::string output = path::join(options.current_folder, options.output_folder);
  return [=, &files, &limits](const std::string& file) {
    const std::string absolute = path::normalize(path::join(output, file));
    const auto copy = origins.find(absolute);
    return read_triangles_of(
        copy != origins.end() ? copy->second : known_name(absolute, options.current_folder, files),
        files, limits);
  };
}

bool copy_files(std::string_view tool, const AssetCopies& copies, const FileReader& files,
                const Limits& limits) {
  for (const auto& [from, to] : copies) {
    std::error_code error;
    if (fs::equivalent(from, to, error)) continue;
    const FileContent content = files.read(from, limits.mesh_bytes);
    if (content.status != ReadStatus::ok) {
      complain(tool, "cannot read '" + from + "': " + content.reason);
      return false;
    }
    fs::create_directories(fs::path(to).parent_path(), error);
    if (!write_output(tool, to, content.text)) return false;
  }
  return true;
}

}  // namespace smurf::tools
