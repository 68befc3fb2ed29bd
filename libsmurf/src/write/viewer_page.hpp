// SPDX-License-Identifier: BSD-3-Clause
// The page that scripts/viewer makes from web/viewer, if it existed at build time.
#pragma once

#include "base/text/embedded_page.hpp"

namespace smurf {

/// Empty in a build without the viewer.
EmbeddedPage viewer_page();

}  // namespace smurf
