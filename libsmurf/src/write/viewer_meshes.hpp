// SPDX-License-Identifier: BSD-3-Clause
// The meshes of a page that shows a scene. Each is written once, however many shapes use it.
#pragma once

#include "write/json_printer.hpp"
#include "write/preview_meshes.hpp"

namespace smurf {

class ViewerMeshes {
 public:
  struct Known {
    std::optional<std::size_t> index;  ///< in what print() writes
    std::string why_none;
  };

  /// `scene` must outlive this.
  explicit ViewerMeshes(const SceneExport& scene);

  /// `place` is that of the shape that uses the file.
  const Known& find(const std::string& file, Span place);

  /// Prints a list of all meshes that were found.
  void print(JsonPrinter& json) const;

 private:
  struct Shown {
    std::string file, points, indices;  ///< the latter two in base64
    std::vector<MeshPart> parts;
    bool is_wide = false;  ///< four bytes an index, else two
  };
  Known read(const std::string& file, Span place);
  static void print_parts(const std::vector<MeshPart>& parts, JsonPrinter& json);

  PreviewMeshes files_;
  std::unordered_map<std::string, Known> known_;
  std::vector<Shown> shown_;
};

}  // namespace smurf
