// SPDX-License-Identifier: BSD-3-Clause
// Inertias that replace those which cannot be right.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// Where a new inertia comes from.
struct InertiaSource {
  enum class From : std::uint8_t {
    mass,     ///< the shapes, with the written mass; without shapes, the tensor without its likely
              ///< mistake, or the nearest possible one
    mesh,     ///< as `mass`, but only if the shapes are closed
    box,      ///< the box around the shapes, with the written mass
    nearest,  ///< the possible tensor that is nearest to the written one
    density   ///< the shapes with this density, which also gives the mass
  };
  From from = From::mass;
  double density = 0;  ///< kg/m3
};
/// "mass", "mesh", "box", "nearest" or "density:2700". None for another text.
std::optional<InertiaSource> parse_inertia_source(std::string_view text);

/// Findings about inertias that no body, or not this one, can have, each with an unsafe fix that
/// writes another inertia, and a note that says what was assumed. Links without a replacement are
/// left out.
std::vector<Diagnostic> repair_inertias(const LinkedModel& model, const InertiaSource& source);

}  // namespace smurf
