// SPDX-License-Identifier: BSD-3-Clause
// The meshes of a page that shows a scene. Each is written once, however many shapes use it.
#pragma once

#include <map>
#include <utility>

#include "write/pages/preview_meshes.hpp"
#include "write/text/json_printer.hpp"

namespace smurf {

class ViewerMeshes {
 public:
  struct Known {
    std::optional<std::size_t> index;  ///< index in the output of print()
    std::string why_none;
    bool has_textures = false;  ///< textures in the file, which are not shown
  };

  /// `scene` must outlive this object. With `has_copies`, files with the same triangles, as in two
  /// versions of a scene, are written once.
  ViewerMeshes(const SceneExport& scene, bool has_copies);

  /// `place` is the place of the shape that uses the file.
  const Known& find(const std::string& file, Span place);
  /// The mesh with its texture coordinates; no index if there are none.
  const Known& find_textured(const std::string& file, Span place);

  /// Counts a shape whose file is not shown.
  /// `package`: the one of the file, if no folder of it was found.
  void add_unseen(const std::string& file, const std::string& why, std::string_view package = {}) {
    Unseen& unseen = unseen_[{file, why}];
    ++unseen.shapes;
    unseen.package = package;
  }

  /// Prints all meshes that were found, in the order of their indices.
  void print(JsonPrinter& json) const;
  /// Prints the mesh files that are not shown, each with the reason and the number of shapes that
  /// use it.
  void print_unseen(JsonPrinter& json) const;

 private:
  struct Shown {
    std::string file, points, indices, texture_points;  ///< all but the first in base64
    std::vector<MeshPart> parts;
    bool is_wide = false;  ///< four bytes per index, otherwise two
  };
  Known read(const std::string& file, Span place, TexturePoints texture_points);
  Known add(const std::string& file, const MeshTriangles& mesh);
  static void print_parts(const std::vector<MeshPart>& parts, JsonPrinter& json);

  PreviewMeshes files_;
  bool has_copies_;
  std::map<std::string, Known> known_, textured_;
  std::vector<Shown> shown_;
  struct Unseen {
    std::size_t shapes = 0;
    std::string package;
  };
  std::map<std::pair<std::string, std::string>, Unseen> unseen_;  ///< by file and reason
};

}  // namespace smurf
