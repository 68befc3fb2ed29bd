// SPDX-License-Identifier: BSD-3-Clause
// The meshes of the page that shows a scene: each is written once, for all of its shapes.
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

  /// `place` of the shape that asks.
  const Known& find(const std::string& file, Span place);

  /// A list with every mesh that was found.
  void print(JsonPrinter& json) const;

 private:
  struct Shown {
    std::string file, points, indices;  ///< the latter two in base64
    bool is_wide = false;               ///< four bytes an index, else two
  };
  Known read(const std::string& file, Span place);

  PreviewMeshes files_;
  std::unordered_map<std::string, Known> known_;
  std::vector<Shown> shown_;
};

}  // namespace smurf
