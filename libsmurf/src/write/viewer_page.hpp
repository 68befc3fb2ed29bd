// SPDX-License-Identifier: BSD-3-Clause
// The page that scripts/viewer made of web/viewer, if it was there when this was built.
#pragma once

#include "base/embedded_page.hpp"

namespace smurf {

/// Empty in a build without the page.
EmbeddedPage viewer_page();

}  // namespace smurf
