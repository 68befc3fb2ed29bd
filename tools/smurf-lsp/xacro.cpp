// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/xacro.hpp"

#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {

Json to_json(const XacroFamily& family, const XacroPlace& place, const Context& context) {
  const SourceId source = place.file->source;
  const Positions positions(family.sources, context.client.encoding);
  const Span span{source, static_cast<std::uint32_t>(place.range.begin),
                  static_cast<std::uint32_t>(place.range.end)};
  return {{"uri", context.workspace.uri_of(family.sources.path(source))},
          {"range", positions.range(span)}};
}

std::optional<XacroRequest> xacro_request(Context& context, const Json& params) {
  XacroRequest request;
  request.path = path_in(params);
  request.family = context.workspace.xacro_family(request.path);
  if (request.family == nullptr) return std::nullopt;
  request.offset = offset_in(request.text(), at(params, {"position"}), context.client.encoding);
  return request;
}

}  // namespace smurf::lsp
