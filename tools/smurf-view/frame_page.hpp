// SPDX-License-Identifier: BSD-3-Clause
// The page around the page of the viewer, which follows the server.
#pragma once

#include <string>

namespace smurf::tools {

/// Its script and style are allowed by `nonce`, a random word.
std::string frame_page(const std::string& nonce);

}  // namespace smurf::tools
