// SPDX-License-Identifier: BSD-3-Clause
// The last check of an exported URDF before it is written.
#pragma once

#include <string>

#include "smurf/convert.hpp"

namespace smurf::tools {

struct Verification {
  Proof proof;
  bool tinyxml2_accepts = false;
  RefereeVerdict urdfdom;
  std::size_t links = 0, joints = 0;  ///< of the result
  std::string strict_fault;           ///< why strict readers of XML refuse it; empty if they do not
  std::string problem;                ///< why the result must not be written; empty if it may be

  bool holds() const { return problem.empty(); }
};

/// Reads `urdf` again and compares it with its source model. urdfdom crashes on some texts, so the
/// caller decides whether it is used.
Verification verify(const LinkedModel& model, const SourceMap& sources, const std::string& urdf,
                    const UrdfExport& options, bool may_ask_urdfdom);

/// The figures, one per line.
std::string describe(const Verification& verification);

}  // namespace smurf::tools
