// SPDX-License-Identifier: BSD-3-Clause
// The page of web/viewer, as scripts/viewer made it, in a build that found it.
#pragma once

#include <span>
#include <string_view>

namespace smurf {

/// What stands before and after the data of a scene, in pieces that every compiler takes.
struct ViewerPage {
  std::span<const std::string_view> head, tail;
};

/// Empty when there was no page to build in.
ViewerPage viewer_page();

}  // namespace smurf
