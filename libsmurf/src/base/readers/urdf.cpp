// SPDX-License-Identifier: BSD-3-Clause
// The facts about all URDF readers; the table of a reader can override them.
#include "base/readers.hpp"

namespace smurf::readers::urdf_file {

extern constinit const Reader urdf{
    .name = "urdf",
    .title = "every URDF reader",
    .basis = "what the readers below have in common, unless their own table says otherwise",
    .is_target = false};

}  // namespace smurf::readers::urdf_file
