// SPDX-License-Identifier: BSD-3-Clause
// What every capability works with.
#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "smurf-lsp/workspace.hpp"

namespace smurf::lsp {

using Send = std::function<void(const Json& message)>;
using Log = std::function<void(std::string_view line)>;

/// What the client can do and what its user wants.
struct Client {
  Encoding encoding = Encoding::utf16;
  bool pulls_diagnostics = false;
  bool takes_related_documents = false;
  bool takes_document_changes = false;
  bool takes_snippets = false;
  bool takes_progress = false;
  bool takes_watchers = false;
  bool takes_deep_symbols = false;
  bool shows_degrees = true;    ///< inlay hints
  bool shows_defaults = false;  ///< inlay hints
};

/// Answers a request with an error.
struct RequestError : std::runtime_error {
  RequestError(int error, const std::string& message) : std::runtime_error(message), code(error) {}
  int code;
};
inline constexpr int kInvalidParams = -32602;
inline constexpr int kRequestFailed = -32803;
inline constexpr int kServerCancelled = -32802;

struct Context {
  Workspace workspace;
  Client client;
  Send send;
  int last_id = 0;  ///< of own requests
  bool has_checked_folders = false;
};

/// The path of the document that a request is about.
std::string path_in(const Json& params);

/// A place that a request is about, in one model or scene that reads the file.
struct PlaceView {
  FileView view;
  std::uint32_t offset = 0;
};
/// In all of them; empty for a file that is not open or cannot be read.
std::vector<PlaceView> places_in(Context& context, const Json& params);

Positions loaded_positions(const Context& context);
/// The reference at a place; null when there is none. A name ends where the cursor may still stand.
const Reference* reference_at(Context& context, const PlaceView& place);
/// Location of a span of what was loaded.
Json location(const Context& context, Span span);
/// A WorkspaceEdit of edits in these sources.
Json workspace_edit(const Context& context, std::span<const Edit> edits, const SourceMap& sources);
/// Paragraphs in which names stand in backquotes. Nothing in them is taken for other markup.
Json markdown(std::span<const std::string> lines);
Json markdown(std::string_view line);

}  // namespace smurf::lsp
