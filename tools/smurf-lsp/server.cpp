// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/server.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/deadline.hpp"
#include "common/cli/command.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf-lsp/messages.hpp"
#include "smurf-lsp/uri.hpp"

namespace smurf::lsp {
namespace {

constexpr int kParseError = -32700;
constexpr int kInvalidRequest = -32600;
constexpr int kMethodNotFound = -32601;
constexpr int kNotInitialized = -32002;

using Handler = Json (*)(Context&, const Json&);
constexpr std::pair<std::string_view, Handler> kHandlers[] = {
    {"textDocument/diagnostic", document_diagnostics},
    {"workspace/diagnostic", workspace_diagnostics},
    {"textDocument/codeAction", code_actions},
    {"workspace/executeCommand", execute_command},
    {"textDocument/hover", hover},
    {"textDocument/completion", completion},
    {"textDocument/definition", definition},
    {"textDocument/references", references},
    {"textDocument/documentHighlight", highlights},
    {"textDocument/prepareRename", prepare_rename},
    {"textDocument/rename", rename},
    {"workspace/willRenameFiles", rename_files},
    {"textDocument/documentSymbol", document_symbols},
    {"workspace/symbol", workspace_symbols},
    {"textDocument/foldingRange", folding_ranges},
    {"textDocument/selectionRange", selection_ranges},
    {"textDocument/documentLink", document_links},
    {"textDocument/documentColor", colors},
    {"textDocument/colorPresentation", color_presentations},
    {"textDocument/semanticTokens/full", semantic_tokens},
    {"textDocument/semanticTokens/range", semantic_tokens},
    {"textDocument/inlayHint", inlay_hints},
    {"smurf/picture", picture},
    {"smurf/expansion", expansion},
    {"smurf/expansionOrigin", expansion_origin},
    {"smurf/expansionPlaces", expansion_places},
};

Json capabilities(const Client& client) {
  return {
      {"positionEncoding", to_string(client.encoding)},
      {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
      {"diagnosticProvider",
       {{"identifier", "smurf-lint"},
        {"interFileDependencies", true},
        {"workspaceDiagnostics", true},
        {"workDoneProgress", true}}},
      {"codeActionProvider", {{"codeActionKinds", {"quickfix", "source.fixAll"}}}},
      {"executeCommandProvider", {{"commands", commands()}}},
      {"hoverProvider", true},
      {"completionProvider", {{"triggerCharacters", {"<", "\"", "'", " ", ":", "/", "-"}}}},
      {"definitionProvider", true},
      {"referencesProvider", true},
      {"documentHighlightProvider", true},
      {"renameProvider", {{"prepareProvider", true}}},
      {"documentSymbolProvider", true},
      {"workspaceSymbolProvider", true},
      {"foldingRangeProvider", true},
      {"selectionRangeProvider", true},
      {"documentLinkProvider", {{"resolveProvider", false}}},
      {"colorProvider", true},
      {"semanticTokensProvider", {{"legend", token_legend()}, {"full", true}, {"range", true}}},
      {"inlayHintProvider", true},
      {"experimental", {{"picture", true}, {"expansion", true}}},
      {"workspace",
       {{"workspaceFolders", {{"supported", true}, {"changeNotifications", true}}},
        {"fileOperations", {{"willRename", file_filters()}}}}},
  };
}

Encoding encoding_of(const Json& wanted) {
  if (!wanted.is_array()) return Encoding::utf16;
  for (const Json& one : wanted) {  // in the client's order of preference
    for (const Encoding encoding : {Encoding::utf8, Encoding::utf16, Encoding::utf32}) {
      if (one == to_string(encoding)) return encoding;
    }
  }
  return Encoding::utf16;
}

void read_settings(const Json& settings, Client& client) {
  const Json& own = at(settings, {"smurf"}).is_object() ? at(settings, {"smurf"}) : settings;
  client.shows_degrees = flag_at(own, {"inlayHints", "degrees"}, client.shows_degrees);
  client.shows_defaults = flag_at(own, {"inlayHints", "defaults"}, client.shows_defaults);
}

void read_client(const Json& params, Client& client) {
  const Json& can = at(params, {"capabilities"});
  client.encoding = encoding_of(at(can, {"general", "positionEncodings"}));
  client.pulls_diagnostics = at(can, {"textDocument", "diagnostic"}).is_object();
  client.takes_related_documents =
      flag_at(can, {"textDocument", "diagnostic", "relatedDocumentSupport"});
  client.takes_document_changes = flag_at(can, {"workspace", "workspaceEdit", "documentChanges"});
  client.takes_snippets =
      flag_at(can, {"textDocument", "completion", "completionItem", "snippetSupport"});
  client.takes_progress = flag_at(can, {"window", "workDoneProgress"});
  client.takes_watchers =
      flag_at(can, {"workspace", "didChangeWatchedFiles", "dynamicRegistration"});
  client.takes_deep_symbols =
      flag_at(can, {"textDocument", "documentSymbol", "hierarchicalDocumentSymbolSupport"});
  client.refreshes_diagnostics = flag_at(can, {"workspace", "diagnostics", "refreshSupport"});
  client.refreshes_hints = flag_at(can, {"workspace", "inlayHint", "refreshSupport"});
  client.refreshes_tokens = flag_at(can, {"workspace", "semanticTokens", "refreshSupport"});
  const Json& operations = at(can, {"workspace", "workspaceEdit", "resourceOperations"});
  client.renames_files =
      client.takes_document_changes && operations.is_array() &&
      std::find(operations.begin(), operations.end(), "rename") != operations.end();
  read_settings(at(params, {"initializationOptions"}), client);
}

std::vector<std::string> folders_in(const Json& params) {
  std::vector<std::string> folders;
  const Json& list = at(params, {"workspaceFolders"});
  if (list.is_array()) {
    for (const Json& one : list) folders.push_back(path_of_uri(text_at(one, {"uri"})));
  } else {
    folders.push_back(path_of_uri(text_at(params, {"rootUri"})));
  }
  std::erase(folders, std::string());
  return folders;
}

void change_folders(Context& context, const Json& params) {
  std::vector<std::string> folders = context.workspace.folders();
  for (const std::string& gone :
       folders_in({{"workspaceFolders", at(params, {"event", "removed"})}})) {
    std::erase(folders, gone);
  }
  for (std::string& added : folders_in({{"workspaceFolders", at(params, {"event", "added"})}})) {
    folders.push_back(std::move(added));
  }
  context.workspace.set_folders(std::move(folders));
}

void open(Context& context, const Json& params) {
  const std::string path = path_in(params);
  if (path.empty()) return;
  context.workspace.open(path, {text_at(params, {"textDocument", "uri"}),
                                number_at(params, {"textDocument", "version"}).value_or(0),
                                text_at(params, {"textDocument", "text"})});
}

void change(Context& context, const Json& params) {
  context.workspace.change(path_in(params),
                           number_at(params, {"textDocument", "version"}).value_or(0),
                           at(params, {"contentChanges"}), context.client.encoding);
}

/// Asks the client to report changes of files that belong to models.
void watch_files(Context& context) {
  if (!context.client.takes_watchers) return;
  Json watchers = Json::array();
  // Models, scenes and schemas; meshes and what they name; textures; lists of files.
  for (const char* pattern :
       {"**/*.{smurf,smurfs,smurfa,urdf,xacro,srdf,yml,yaml,svg,scn,scene,json}",
        "**/*.{stl,obj,dae,bobj,gltf,glb,bin,mtl,STL,OBJ,DAE,GLTF,GLB}",
        "**/*.{png,jpg,jpeg,bmp,tga,tif,tiff,dds,PNG,JPG,JPEG}",
        "**/{.gitignore,.smurf-lintignore,package.xml}"}) {
    watchers.push_back({{"globPattern", pattern}});
  }
  const Json registration = {{"id", "files"},
                             {"method", "workspace/didChangeWatchedFiles"},
                             {"registerOptions", {{"watchers", std::move(watchers)}}}};
  context.ask("client/registerCapability", {{"registrations", {registration}}});
}

/// A client that requests findings is not aware of changed files on disk.
void refresh(Context& context) {
  const Client& client = context.client;
  if (client.pulls_diagnostics && client.refreshes_diagnostics) {
    context.ask("workspace/diagnostic/refresh", nullptr);
  }
  if (client.refreshes_tokens) context.ask("workspace/semanticTokens/refresh", nullptr);
  if (client.refreshes_hints) context.ask("workspace/inlayHint/refresh", nullptr);
}

}  // namespace

Server::Server(Send send, Log log, ServerOptions options) : log_(std::move(log)) {
  context_.write = std::move(send);
  context_.name = std::move(options.name);
  max_seconds_ = options.max_seconds;
  if (options.is_cancelled) context_.is_cancelled = std::move(options.is_cancelled);
}

void Server::reply(const Json& id, Json result) {
  context_.send({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

void Server::refuse(const Json& id, int code, std::string_view message) {
  log_("error " + std::to_string(code) + ": " + std::string(message));
  context_.send({{"jsonrpc", "2.0"},
                 {"id", id},
                 {"error", {{"code", code}, {"message", std::string(message)}}}});
}

void Server::begin(const Json& params) {
  is_initialized_ = true;
  read_client(params, context_.client);
  context_.workspace.set_folders(folders_in(params));
}

void Server::initialize(const Json& id, const Json& params) {
  if (is_initialized_) return refuse(id, kInvalidRequest, "`initialize` was already sent");
  begin(params);
  reply(id, {{"capabilities", capabilities(context_.client)},
             {"serverInfo", {{"name", "smurf-lsp"}, {"version", tools::kVersion}}}});
}

Json Server::answer(const std::string& method, const Json& params) {
  const auto* handler = std::find_if(std::begin(kHandlers), std::end(kHandlers),
                                     [&](const auto& one) { return one.first == method; });
  if (handler == std::end(kHandlers)) {
    throw RequestError(kMethodNotFound, "`" + method + "` is not known here");
  }
  return handler->second(context_, params);
}

void Server::note(const std::string& method, const Json& params) {
  Workspace& workspace = context_.workspace;
  if (method == "textDocument/didOpen") return open(context_, params);
  if (method == "textDocument/didChange") return change(context_, params);
  if (method == "textDocument/didClose") return workspace.close(path_in(params));
  if (method == "textDocument/didSave") return workspace.forget_files();
  if (method == "workspace/didChangeWatchedFiles") return workspace.forget_files();
  if (method == "workspace/didChangeWorkspaceFolders") return change_folders(context_, params);
  if (method == "workspace/didChangeConfiguration") {
    return read_settings(at(params, {"settings"}), context_.client);
  }
}

void Server::notify(const std::string& method, const Json& params) {
  note(method, params);
  if (method == "initialized") return watch_files(context_);
  if (method == "workspace/didChangeWatchedFiles") return refresh(context_);
  if (method == "workspace/didChangeConfiguration" && context_.client.refreshes_hints) {
    context_.ask("workspace/inlayHint/refresh", nullptr);
  }
}

void Server::follow(const Json& message) {
  const std::string method = text_at(message, {"method"});
  const Json& params = at(message, {"params"});
  if (!is_request(message)) {
    if (is_running()) note(method, params);
  } else if (method == "initialize" && !is_initialized_) {
    begin(params);
  } else if (method == "shutdown" && is_initialized_) {
    is_shut_down_ = true;
  }
}

void Server::handle(const Json& message) {
  if (message.is_discarded()) return refuse(nullptr, kParseError, "this is not JSON");
  const Json& id = at(message, {"id"});
  const std::string method = text_at(message, {"method"});
  const Json& params = at(message, {"params"});
  const bool is_answered = is_request(message);
  log_((is_answered ? "request " : "notification ") + method);
  if (method.empty()) {  // an answer to a request of ours, or nothing at all
    const bool is_answer = message.contains("result") || message.contains("error");
    if (!is_answer) refuse(nullptr, kInvalidRequest, "this is not a message");
    return;
  }
  if (method == "exit") {
    exit_code_ = is_shut_down_ ? 0 : 1;
    return;
  }
  if (!is_answered) {
    if (is_running()) notify(method, params);
    return;
  }
  if (flag_at(message, {kCancelled})) return refuse(id, kRequestCancelled, "cancelled");
  if (method == "initialize") return initialize(id, params);
  if (!is_initialized_) return refuse(id, kNotInitialized, "`initialize` must come first");
  if (is_shut_down_) return refuse(id, kInvalidRequest, "the server is shut down");
  if (method == "shutdown") {
    is_shut_down_ = true;
    return reply(id, nullptr);
  }
  try {
    const Deadline deadline(max_seconds_);
    reply(id, answer(method, params));
  } catch (const OutOfTime&) {
    context_.workspace.forget_files();  // they may be half read
    refuse(id, kRequestFailed,
           "`" + method + "` took more than " + std::to_string(max_seconds_) +
               " s of processor time and was stopped; close the file that takes so long, or name "
               "it in `exclude` of .smurf-lint.yaml");
  } catch (const RequestError& error) {
    refuse(id, error.code, error.what());
  } catch (const Json::exception& error) {
    refuse(id, kInvalidParams, error.what());
  }
}

void Server::rest() {
  Workspace& workspace = context_.workspace;
  if (!is_running() || workspace.is_checked()) return;
  if (context_.client.pulls_diagnostics) return;  // it asks
  const Report& report = workspace.report();
  std::map<std::string, std::string> files =
      diagnostics_by_file(context_, report, workspace.sources());
  // A file without findings is published once more, to clear the old ones.
  for (const std::string& path : shown_) files.try_emplace(path, kNoDiagnostics);
  for (const auto& [path, document] : workspace.documents()) {
    files.try_emplace(path, kNoDiagnostics);
  }
  shown_.clear();
  for (auto& [path, list] : files) {
    if (list != kNoDiagnostics) shown_.insert(path);
    Json params = {{"uri", workspace.uri_of(path)},
                   {"diagnostics", context_.lists.add(std::move(list))}};
    const OpenDocument* open = workspace.document(path);
    if (open != nullptr) params["version"] = open->version;
    context_.send({{"jsonrpc", "2.0"},
                   {"method", "textDocument/publishDiagnostics"},
                   {"params", std::move(params)}});
  }
}

}  // namespace smurf::lsp
