// SPDX-License-Identifier: BSD-3-Clause
// The functions that answer requests, one for each, grouped by file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "smurf-lsp/context.hpp"

namespace smurf::lsp {

// diagnostics.cpp
Json document_diagnostics(Context& context, const Json& params);
Json workspace_diagnostics(Context& context, const Json& params);
/// Printed lists of findings, by the client's URI of their file. With `only`, the list of that file
/// alone.
std::map<std::string, std::string> diagnostics_by_file(const Context& context, const Report& report,
                                                       const SourceMap& sources,
                                                       const std::string* only = nullptr);
inline constexpr const char* kNoDiagnostics = "[]";  ///< the list of a file without findings
Json to_json(const Context& context, const Diagnostic& diagnostic, const SourceMap& sources);

// code_actions.cpp
Json code_actions(Context& context, const Json& params);
Json execute_command(Context& context, const Json& params);
std::vector<std::string> commands();

// inertia_actions.cpp
struct InertiaAction {
  std::string title;
  std::vector<Edit> edits;  ///< point into the loaded sources
};
/// Other inertias for a finding about one; none for other findings.
std::vector<InertiaAction> inertia_actions(Context& context, const Diagnostic& finding);

Json hover(Context& context, const Json& params);       // hover.cpp
Json completion(Context& context, const Json& params);  // completion.cpp
Json colors(Context& context, const Json& params);      // colors.cpp
Json color_presentations(Context& context, const Json& params);
Json folding_ranges(Context& context, const Json& params);  // ranges.cpp
Json selection_ranges(Context& context, const Json& params);
Json inlay_hints(Context& context, const Json& params);      // inlay_hints.cpp
Json semantic_tokens(Context& context, const Json& params);  // semantic_tokens.cpp
Json token_legend();

// links.cpp
Json document_links(Context& context, const Json& params);
/// A file name in a document.
struct FileLink {
  Span span;
  std::string path;
};
std::vector<FileLink> links_in(const Context& context, const FileView& view);
/// The file names at the place of a request.
std::vector<FileLink> links_at(Context& context, const Json& params, Looks looks = Looks::around);
/// The files that a launch file means, as far as they are here; none for another file.
std::vector<FileLink> launch_links_in(Context& context, const FileView& view);
/// The name of an argument that a launch file gives to the xacro of a robot.
struct ArgumentAt {
  Span span;
  std::string name;
  Span declared;  ///< the name in `xacro:arg`
  bool has_default = false;
};
std::optional<ArgumentAt> launch_argument_at(Context& context, const PlaceView& place);
/// Calls `visit` with each file name in the models and scenes of the open documents, and its view.
/// A file that several models read is visited with each.
void for_each_link(Context& context,
                   const std::function<void(const FileView&, const FileLink&)>& visit);

// navigation.cpp
Json definition(Context& context, const Json& params);
Json references(Context& context, const Json& params);
Json highlights(Context& context, const Json& params);

// file_renaming.cpp
Json rename_files(Context& context, const Json& params);
/// Another name for the file that is named at a place, if there is one.
Json prepare_file_rename(Context& context, const Json& params);
Json rename_file_at(Context& context, const Json& params);
Json file_filters();

// renaming.cpp
Json prepare_rename(Context& context, const Json& params);
Json rename(Context& context, const Json& params);

Json picture(Context& context, const Json& params);  // preview.cpp

// xacro.cpp
/// What the name or the expression at the place is; null if there is none.
Json xacro_hover(Context& context, const Json& params);
/// The symbols of a xacro; null for another document.
std::optional<std::string> xacro_symbols(Context& context, const Json& params);

// expansion.cpp
/// {text: the robot that a xacro makes, or null}
Json expansion(Context& context, const Json& params);
/// The place in the xacro files of a position in the text of `expansion`.
Json expansion_origin(Context& context, const Json& params);
/// The ranges in the text of `expansion` that a place in a xacro file has made.
Json expansion_places(Context& context, const Json& params);

// symbols.cpp
Json document_symbols(Context& context, const Json& params);
Json workspace_symbols(Context& context, const Json& params);

}  // namespace smurf::lsp
