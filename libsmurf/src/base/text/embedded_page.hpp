// SPDX-License-Identifier: BSD-3-Clause
// The embedded pages of web/; inserts data into them.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace smurf {

/// The texts before and after the data, in pieces that are short enough for every compiler.
struct EmbeddedPage {
  std::span<const std::string_view> head, tail;
};

/// The page with its data. The data cannot end their block or begin a comment or another
/// block.
std::string page_around(const EmbeddedPage& page, std::string_view json);

}  // namespace smurf
