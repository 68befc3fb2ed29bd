// SPDX-License-Identifier: BSD-3-Clause
// Converts between file: URIs and paths.
#pragma once

#include <string>
#include <string_view>

namespace smurf::lsp {

/// The normalised path of a file: URI; "" for any other.
std::string path_of_uri(std::string_view uri);
std::string uri_of_path(std::string_view path);

}  // namespace smurf::lsp
