// SPDX-License-Identifier: BSD-3-Clause
// Reads meshes and textures for formats that show them.
#include <map>

#include "base/files/path.hpp"
#include "smurf/asset_copies.hpp"

namespace smurf {

std::string known_name(const std::string& absolute, const std::string& current,
                       const FileReader& files) {
  return files.is_file(absolute) ? absolute : path::relative(absolute, current);
}

MeshSource mesh_source(const FlattenOptions& options, const AssetCopies& copies,
                       const FileReader& files, const Limits& limits) {
  std::map<std::string, std::string> origins;  // originals of copies that do not exist yet
  for (const AssetCopy& copy : copies) {
    origins.emplace(path::join(options.current_folder, copy.to()), copy.from);
  }
  const std::string output = path::join(options.current_folder, options.output_folder);
  const auto origin = [=, current = options.current_folder, &files](const std::string& file) {
    const std::string absolute = path::normalize(path::join(output, file));
    const auto copy = origins.find(absolute);
    return copy != origins.end() ? copy->second : known_name(absolute, current, files);
  };
  return {.triangles =
              [=, &files, &limits](const std::string& file, TexturePoints texture_points) {
                return read_triangles_of(origin(file), files, limits, texture_points);
              },
          .identity =
              [=, &files](const std::string& file) {  // the extension determines how it is read
                const std::string from = origin(file);
                return path::to_lower(path::extension(from)) + files.identity(from);
              },
          .image =
              [=, &files, &limits](const std::string& file) {
                return files.read(origin(file), limits.mesh_bytes);
              },
          .most_bytes = limits.scene_bytes,
          .most_pixels = limits.image_pixels};
}

}  // namespace smurf
