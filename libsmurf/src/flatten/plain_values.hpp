// SPDX-License-Identifier: BSD-3-Clause
// YAML trees to plain values.
#pragma once

#include "smurf/flatten.hpp"

namespace smurf {

/// Scalars by the YAML 1.2 core schema; infinities and NaN, which JSON lacks, stay text. Of equal
/// keys, the first is used.
Value to_value(yaml::View node);
Value::Object to_object(yaml::View mapping);

}  // namespace smurf
