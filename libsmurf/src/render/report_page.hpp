// SPDX-License-Identifier: BSD-3-Clause
// The page of web/report, which shows a report.
#pragma once

#include "base/text/embedded_page.hpp"

namespace smurf {

EmbeddedPage report_page();

}  // namespace smurf
