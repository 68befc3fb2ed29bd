// SPDX-License-Identifier: BSD-3-Clause
// The textures of a page that shows a scene. Each is written once, however many shapes use it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "smurf/write_scene.hpp"
#include "write/text/json_printer.hpp"

namespace smurf {

class ViewerImages {
 public:
  struct Known {
    std::optional<std::size_t> index;  ///< index in the output of print()
    std::string why_none;              ///< "is neither PNG nor JPEG"
  };

  /// `scene` must outlive this object.
  explicit ViewerImages(const SceneExport& scene) : scene_(scene) {}

  const Known& find(const std::string& file);

  /// Prints all images that were found, in the order of their indices.
  void print(JsonPrinter& json) const;

 private:
  struct Shown {
    std::string file;
    std::string_view type;
    std::string bytes;  ///< in base64
  };
  Known read(const std::string& file);

  const SceneExport& scene_;
  std::map<std::string, Known> known_;
  std::vector<Shown> shown_;
  std::uint64_t pixels_ = 0, bytes_ = 0;  ///< total of all images
};

/// The header of a PNG or JPEG file; none for other files and damaged headers.
struct ImageHead {
  std::string_view type;  ///< "image/png"
  std::uint64_t width = 0, height = 0;
};
std::optional<ImageHead> image_head(std::string_view bytes);

}  // namespace smurf
