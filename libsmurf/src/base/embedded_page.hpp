// SPDX-License-Identifier: BSD-3-Clause
// Pages of web/ that are built in, and how data gets into them.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace smurf {

/// The texts before and after the data, in pieces that every compiler takes.
struct EmbeddedPage {
  std::span<const std::string_view> head, tail;
};

/// The page with its data. Nothing in the data ends its block, or begins a comment or another
/// block.
std::string page_around(const EmbeddedPage& page, std::string_view json);

}  // namespace smurf
