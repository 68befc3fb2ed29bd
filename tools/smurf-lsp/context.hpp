// SPDX-License-Identifier: BSD-3-Clause
// The state and helpers that all capabilities use.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "smurf-lsp/printed_lists.hpp"
#include "smurf-lsp/workspace.hpp"

namespace smurf::lsp {

/// Takes the text of a message in parts, since it may be long.
using Send = std::function<void(std::span<const std::string_view> parts)>;
using Log = std::function<void(std::string_view line)>;

/// The client's capabilities and the user's settings.
struct Client {
  Encoding encoding = Encoding::utf16;
  bool pulls_diagnostics = false;
  bool takes_related_documents = false;
  bool takes_document_changes = false;
  bool takes_snippets = false;
  bool takes_progress = false;
  bool takes_watchers = false;
  bool takes_deep_symbols = false;
  bool renames_files = false;          ///< as a part of an edit
  bool refreshes_diagnostics = false;  ///< asks for them again when it is notified
  bool refreshes_hints = false;
  bool refreshes_tokens = false;
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
inline constexpr int kRequestCancelled = -32800;

/// The most places of a name in an answer. An editor shows fewer, and each needs 150 bytes.
inline constexpr std::size_t kMostPlaces = 100'000;

struct Context {
  Workspace workspace;
  Client client;
  Send write;
  std::string name;                                           ///< begins the ids of own requests
  std::function<bool()> is_cancelled = [] { return false; };  ///< the request that is handled
  PrintedLists lists;                                         ///< of the next message
  int last_id = 0;                                            ///< of own requests
  bool has_checked_folders = false;

  void send(const Json& message);
  /// Sends a request whose answer is ignored.
  void ask(const char* method, Json params);
};

/// The path of the document of a request.
std::string path_in(const Json& params);

/// The place of a request, in one model or scene that reads the file.
struct PlaceView {
  FileView view;
  std::uint32_t offset = 0;
};
/// Whether robots are loaded for a file around them, which takes as long as to load a robot: what
/// an editor asks while someone types must not wait for that.
enum class Looks : std::uint8_t { around, at_what_is_loaded };
/// The place in all models and scenes; empty for a file that is not open or cannot be read.
std::vector<PlaceView> places_in(Context& context, const Json& params, Looks looks = Looks::around);

Positions loaded_positions(const Context& context);
/// The reference at a place, or null. A cursor just behind a name is still at the name.
const Reference* reference_at(Context& context, const PlaceView& place);
/// The Location of a span in the loaded sources.
Json location(const Context& context, Span span);
/// A WorkspaceEdit of edits in these sources.
Json workspace_edit(Context& context, std::span<const Edit> edits, const SourceMap& sources);
/// Whether an editor may count the lines of a file differently than this server, so that an edit
/// would hit another place. This is possible if the file is not open and contains a carriage return
/// alone, which ends a line in some editors only.
bool is_counted_differently(const Context& context, SourceId source, const SourceMap& sources);
/// Makes Markdown of paragraphs with names in backquotes. All other markup in them is escaped.
Json markdown(std::span<const std::string> lines);
Json markdown(std::string_view line);

}  // namespace smurf::lsp
