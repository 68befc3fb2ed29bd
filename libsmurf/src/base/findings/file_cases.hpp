// SPDX-License-Identifier: BSD-3-Clause
// Cases of findings about the text of a file, which the stages before `link` report.
#pragma once

#include "smurf/diagnostic.hpp"

namespace smurf::cases {

// SML18xx: one of the numbers that can be read, up to the first that cannot, is nearly 0.
inline constexpr Circumstance kReadsZero{"reads 0"};
// SML0003: TinyXML loses the quote or the `<` behind such a byte; a link or a joint has the byte in
// its name; the declaration names another encoding.
inline constexpr Circumstance kLosesQuote{"loses a quote"};
inline constexpr Circumstance kInName{"in a name"};
inline constexpr Circumstance kOtherEncoding{"another encoding is declared"};
// SML0004: NUL behind the last element.
inline constexpr Circumstance kPadding{"padding"};
// SML1015: the instruction is an XML declaration.
inline constexpr Circumstance kLateDeclaration{"late declaration"};
// SML1009: `file://$(find PACKAGE)/...`
inline constexpr Circumstance kUnexpandedUri{"file: address"};

}  // namespace smurf::cases
