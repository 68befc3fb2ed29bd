// SPDX-License-Identifier: BSD-3-Clause
// Cases of findings about the text of a file, which the stages before `link` report.
#pragma once

#include "smurf/diagnostic.hpp"

namespace smurf::cases {

// SML1015: the instruction is an XML declaration.
inline constexpr Circumstance kLateDeclaration{"late declaration"};
// SML1009: `file://$(find PACKAGE)/...`
inline constexpr Circumstance kUnexpandedUri{"file: address"};

}  // namespace smurf::cases
