// SPDX-License-Identifier: BSD-3-Clause
// An SVG drawing of a scene: every group is an entity (MARS SMURFLoader.cpp:127-302).
#pragma once

#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// One group. The page's x is the world's, its y goes down from the top; one unit is 1 m.
struct DrawnEntity {
  Span group;                 ///< the element's name in its start tag
  Spanned<std::string> file;  ///< of the title, relative to the drawing
  double x = 0, y = 0;        ///< in the world, m
  Span place;                 ///< span of its source: the transform, else the path
  double yaw = 0;             ///< degrees, in (-180, 180]
  double z = 0;               ///< m
  Span height;                ///< span of its source; the group's name if there is none
};

/// Reports groups that are not entities, and omits them.
std::vector<DrawnEntity> read_drawing(const xml::Document& document, DiagnosticSink& sink);

}  // namespace smurf
