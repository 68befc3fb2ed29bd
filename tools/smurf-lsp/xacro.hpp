// SPDX-License-Identifier: BSD-3-Clause
// Requests about the names of xacro, and their answers.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/rename/xacro_names.hpp"
#include "smurf-lsp/context.hpp"

namespace smurf::lsp {

using tools::XacroFamily;
using tools::XacroMeaning;
using tools::XacroPlace;

Json to_json(const XacroFamily& family, const XacroPlace& place, const Context& context);

/// The document of a request as a xacro, and the place in it.
struct XacroRequest {
  std::string path;
  const XacroFamily* family = nullptr;
  std::size_t offset = 0;

  const XacroFamily::File& own() const { return family->files.front(); }
  std::string_view text() const { return family->text(own()); }
};
std::optional<XacroRequest> xacro_request(Context& context, const Json& params);

}  // namespace smurf::lsp
