// SPDX-License-Identifier: BSD-3-Clause
// Colours and textures of visuals in MARS: those of the annotations override those of the
// URDF.
#pragma once

#include <map>

#include "convert/annotation_values.hpp"
#include "write/parts/placed_shapes.hpp"

namespace smurf {

class AnnotatedLooks {
 public:
  struct Look {
    std::optional<Rgba> color;
    std::optional<std::string> texture;  ///< a file relative to the output's folder
  };

  /// Both must outlive this object.
  AnnotatedLooks(const LinkedModel& model, const FlatModel& flat);
  Look of(const urdf::Visual& visual) const;

 private:
  const LinkedModel& model_;
  const FlatModel& flat_;
  AnnotationValues values_;
  std::multimap<std::string_view, const MaterialAnnotation*> annotations_;  ///< by material
  std::map<std::string_view, std::string_view> replaced_;                   ///< by visual
};

}  // namespace smurf
