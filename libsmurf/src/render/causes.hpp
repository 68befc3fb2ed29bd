// SPDX-License-Identifier: BSD-3-Clause
// Findings with one cause: a thing was renamed where it is defined, and everything that names it is
// reported.
#pragma once

#include <deque>
#include <map>
#include <span>

#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"

namespace smurf::render {

/// The findings of a report that are shown once.
class Causes {
 public:
  Causes(std::span<const Diagnostic> diagnostics, const SourceMap& sources);

  /// What is shown instead of a finding: itself, one that speaks for several, or null for those
  /// that another one speaks for.
  const Diagnostic* shown(const Diagnostic& finding) const;

 private:
  std::deque<Diagnostic> spokesmen_;
  std::map<const Diagnostic*, const Diagnostic*> shown_;
};

}  // namespace smurf::render
