// SPDX-License-Identifier: BSD-3-Clause
// The page of web/diff, which shows differences.
#pragma once

#include "base/text/embedded_page.hpp"

namespace smurf {

EmbeddedPage diff_page();

}  // namespace smurf
