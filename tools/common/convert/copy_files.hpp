// SPDX-License-Identifier: BSD-3-Clause
// Writes copies of the files that models name: all of them or none.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "common/files/input.hpp"
#include "smurf/asset_copies.hpp"
#include "smurf/limits.hpp"

namespace smurf::tools {

/// The places of the copies, without files that are there already under another name. Their
/// originals become inputs.
std::vector<std::string> places_of(const AssetCopies& copies, const InputFiles& inputs);

/// Copies the files and then calls `write_result`; writes either all files or none. Reports
/// errors and returns false. The names come from the model, so only files with the extension
/// of a mesh, an image or a buffer are copied, and existing files are kept unless
/// `overwrite`.
bool copy_files(std::string_view tool, const AssetCopies& copies, const FileReader& files,
                const Limits& limits, bool overwrite, const std::function<bool()>& write_result);

}  // namespace smurf::tools
