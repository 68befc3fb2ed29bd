// SPDX-License-Identifier: BSD-3-Clause
// What all readers of URDF have in common, unless their own table says otherwise.
#include "base/readers.hpp"

namespace smurf::readers {

extern constinit const Reader urdf{
    .name = "urdf",
    .title = "every URDF reader",
    .basis = "what the readers below have in common, unless their own table says otherwise",
    .is_target = false};

}  // namespace smurf::readers
