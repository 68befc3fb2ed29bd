// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3413_xacro_unused_name_file {

extern constinit const Rule sml3413_xacro_unused_name{
    .id = "SML3413",
    .name = "xacro-unused-name",
    .severity = Severity::info,
    .summary = "The file of a robot defines a macro, parameter, property or argument that nothing "
               "uses.",
    .why = "A name that is not used may be misspelt where it should be used. Names in files that "
           "other files include are not reported, because other robots may use them.",
    .remedy = "Delete the name, or use it.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules::sml3413_xacro_unused_name_file
