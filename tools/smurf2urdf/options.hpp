// SPDX-License-Identifier: BSD-3-Clause
// The command line of smurf2urdf.
#pragma once

#include <string>

#include "common/convert/converter.hpp"
#include "smurf/conversion.hpp"
#include "smurf/convert.hpp"

namespace smurf::tools {

struct ExportOptions {
  ConverterOptions common;
  std::string model;
  UrdfExport conversion;
  CollisionRequest collisions;
  const Reader* reader = nullptr;  ///< that the result is for
  std::string srdf;
  std::string loss_report;
  std::string shown_preset;
  bool fails_on_loss = false;
  bool prove = false;
  bool dry_run = false;
};

Command make_command(ExportOptions& options);

/// The options of a preset, as a line of text.
std::string preset_text(std::string_view name);

/// Whether no option changes the content of the URDF.
bool is_plain(const ExportOptions& options);

/// An error message about the combination of options; "" if there is none. Sets the folder of the
/// output.
std::string problem_of(ExportOptions& options);

}  // namespace smurf::tools
