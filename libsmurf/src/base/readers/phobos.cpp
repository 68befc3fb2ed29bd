// SPDX-License-Identifier: BSD-3-Clause
// Phobos 2, which reads URDF with Python's XML and YAML with PyYAML.
#include "base/readers.hpp"

namespace smurf::readers {

extern constinit const Reader phobos{.name = "phobos",
                                     .title = "Phobos 2",
                                     .basis = "a613e31, read",
                                     .like = &urdf,
                                     .reads_annotations = true};

}  // namespace smurf::readers
