// SPDX-License-Identifier: BSD-3-Clause
// Looks up the colours and textures of visuals, with those from annotations, for writers that visit
// every instance.
#pragma once

#include <map>
#include <optional>
#include <unordered_map>

#include "write/parts/annotated_looks.hpp"

namespace smurf {

class AnnotatedColors {
 public:
  /// The colour of a visual of a model. The model must outlive this object.
  std::optional<Rgba> of(const urdf::Visual& visual, const LinkedModel& model,
                         const FlatModel& flat);
  /// The same with its texture, a file relative to the output's folder.
  AnnotatedLooks::Look look_of(const urdf::Visual& visual, const LinkedModel& model,
                               const FlatModel& flat);

 private:
  std::map<const LinkedModel*, AnnotatedLooks> looks_;
  std::unordered_map<const urdf::Visual*, AnnotatedLooks::Look> known_;
};

}  // namespace smurf
