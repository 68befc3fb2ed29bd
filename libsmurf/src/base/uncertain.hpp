// SPDX-License-Identifier: BSD-3-Clause
// Findings whose effect on a reader depends on files outside of the model.
#pragma once

#include <string_view>

namespace smurf {

/// A construct of such findings. The reader may find what it needs, so a refusal in its fact makes
/// the verdict `not known`.
inline constexpr std::string_view kUncertain = "#uncertain";

}  // namespace smurf
