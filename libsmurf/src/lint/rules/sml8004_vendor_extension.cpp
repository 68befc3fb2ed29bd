// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml8004_vendor_extension{
    .id = "SML8004",
    .name = "vendor-extension",
    .severity = Severity::info,
    .summary = "An extension of the URDF is left out of the export.",
    .why = "Programs that read the extension, such as Gazebo or ros2_control, do not find it.",
    .remedy = "Export with `--vendor keep`.",
    .sources = "sdformat parser_urdf.cc; ros2_control hardware_interface.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules
