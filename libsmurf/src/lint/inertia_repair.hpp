// SPDX-License-Identifier: BSD-3-Clause
// Inertias that replace those which cannot be right.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"
#include "smurf/source.hpp"
#include "smurf/xacro.hpp"

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

/// Inertias of robots that are repaired together.
struct InertiaRepairs {
  std::vector<Diagnostic> repairs;  ///< as of repair_inertias(), with places in the files to change
  /// Without a fix, because xacro computes a value, or because a literal has other users. The first
  /// label is at the expression or literal, the last note says what to change.
  std::vector<Diagnostic> refused;
  /// What each robot becomes with the repairs, by the xacro file that makes it.
  std::map<std::string, std::string> expanded;
};
/// The same for robots that may come from xacro files. A literal is changed only if every part of a
/// robot that comes from it gets the same value. `may_change` tells by the path whether a file may
/// be changed.
InertiaRepairs repair_inertias(std::span<const LinkedModel* const> models, const SourceMap& sources,
                               const xacro::Expansions& expansions, const InertiaSource& source,
                               const std::function<bool(const std::string&)>& may_change);

/// Whether the findings of a rule are about an inertia that can be replaced.
bool is_repairable(const Rule& rule);

}  // namespace smurf
