// SPDX-License-Identifier: BSD-3-Clause
// Rename, with the engine of `smurf-lint --rename`.
#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

/// Removes the advice for the command line.
std::string reason(const std::string& problem) {
  return problem.substr(0, problem.find("; name "));
}

}  // namespace

Json prepare_rename(Context& context, const Json& params) {
  for (const PlaceView& place : places_in(context, params)) {
    const Reference* named = reference_at(context, place);
    if (named == nullptr || !named->is_known()) continue;
    return {{"range", loaded_positions(context).range(named->span)},
            {"placeholder", std::string(named->name)}};
  }
  return nullptr;
}

Json rename(Context& context, const Json& params) {
  const std::string to = text_at(params, {"newName"});
  for (const PlaceView& place : places_in(context, params)) {
    const Reference* named = reference_at(context, place);
    if (named == nullptr || !named->is_known()) continue;
    const Renamed renamed = context.workspace.rename(place.view.part, *named, to);
    if (!renamed.problems.empty()) {
      throw RequestError(kRequestFailed,
                         "nothing was renamed: " + reason(renamed.problems.front()));
    }
    return workspace_edit(context, renamed.edits, context.workspace.loaded_sources());
  }
  throw RequestError(kRequestFailed, "there is no name here");
}

}  // namespace smurf::lsp
