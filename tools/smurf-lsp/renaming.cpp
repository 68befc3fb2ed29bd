// SPDX-License-Identifier: BSD-3-Clause
// Rename, with the engine of `smurf-lint --rename`.
#include <algorithm>
#include <optional>
#include <set>

#include "smurf-lsp/capabilities.hpp"
#include "smurf-lsp/xacro.hpp"

namespace smurf::lsp {
namespace {

/// Refuses edits that would hit other places in the editor.
void check_lines(const Context& context, std::span<const Edit> edits) {
  const SourceMap& sources = context.workspace.loaded_sources();
  std::set<SourceId> seen;  // a file may have thousands of edits
  for (const Edit& edit : edits) {
    const SourceId source = edit.span.source;
    if (!seen.insert(source).second || !is_counted_differently(context, source, sources)) continue;
    throw RequestError(kRequestFailed, "nothing was renamed: '" + sources.path(source) +
                                           "' contains a carriage return alone, which not all "
                                           "editors count as the end of a line; open the file");
  }
}

/// Refuses early, because the work needs memory for each place.
void check_number(Context& context, std::size_t part, const Reference& named) {
  const std::vector<Reference>& all = context.workspace.names().names()[part];
  const auto places = std::count_if(
      all.begin(), all.end(), [&](const Reference& one) { return is_same_thing(one, named); });
  if (static_cast<std::size_t>(places) <= kMostPlaces) return;
  throw RequestError(kRequestFailed, "nothing was renamed: the name has " + std::to_string(places) +
                                         " places, too many for an editor; use `smurf-lint "
                                         "--rename`");
}

/// The name of xacro at a place, and the document; none if there is none, or only a name of Python.
struct XacroTarget {
  XacroRequest request;
  tools::XacroMeaning meaning;
};
std::optional<XacroTarget> xacro_target(Context& context, const Json& params) {
  auto request = xacro_request(context, params);
  if (!request) return std::nullopt;
  auto meaning = tools::xacro_meaning(*request->family, request->offset);
  if (!meaning) return std::nullopt;
  return XacroTarget{*std::move(request), *std::move(meaning)};
}

Json rename_xacro(Context& context, const XacroTarget& target, const std::string& to) {
  const tools::XacroMeaning& meaning = target.meaning;
  const std::string macro(tools::macro_of(*target.request.family, meaning.definitions.front()));
  const tools::RenamedXacro renamed =
      context.workspace.rename_xacro(target.request.path, {meaning.kind, macro, meaning.name, to});
  if (!renamed.problems.empty()) {
    throw RequestError(kRequestFailed, "nothing was renamed: " + renamed.problems.front());
  }
  return workspace_edit(context, renamed.edits, renamed.family.sources);
}

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
  if (const auto target = xacro_target(context, params)) {
    const Positions positions(target->request.family->sources, context.client.encoding);
    const SourceId source = target->request.own().source;
    const TextRange at = target->meaning.at;
    const Span span{source, static_cast<std::uint32_t>(at.begin),
                    static_cast<std::uint32_t>(at.end)};
    return {{"range", positions.range(span)}, {"placeholder", target->meaning.name}};
  }
  return prepare_file_rename(context, params);
}

Json rename(Context& context, const Json& params) {
  const std::string to = text_at(params, {"newName"});
  for (const PlaceView& place : places_in(context, params)) {
    const Reference* named = reference_at(context, place);
    if (named == nullptr || !named->is_known()) continue;
    check_number(context, place.view.part, *named);
    const Renamed renamed = context.workspace.rename(place.view.part, *named, to);
    if (!renamed.problems.empty()) {
      throw RequestError(kRequestFailed,
                         "nothing was renamed: " + reason(renamed.problems.front()));
    }
    check_lines(context, renamed.edits);
    return workspace_edit(context, renamed.edits, context.workspace.loaded_sources());
  }
  if (const auto target = xacro_target(context, params)) return rename_xacro(context, *target, to);
  Json file = rename_file_at(context, params);
  if (!file.is_null()) return file;
  throw RequestError(kRequestFailed, "there is no name here");
}

}  // namespace smurf::lsp
