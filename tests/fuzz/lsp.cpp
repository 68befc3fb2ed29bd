// SPDX-License-Identifier: BSD-3-Clause
// The language server: a stream of messages, or a document that is asked about everywhere and then
// edited. Each request gets one answer, and after an edit the same is found as in a server that
// sees the text for the first time.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <string_view>

#include "smurf-lsp/server.hpp"
#include "smurf-lsp/transport.hpp"

using namespace smurf::lsp;

namespace {

constexpr const char* kMain = "file:///nowhere-at-all/m.smurf";

constexpr const char* kMethods[] = {"textDocument/hover",
                                    "textDocument/completion",
                                    "textDocument/definition",
                                    "textDocument/references",
                                    "textDocument/documentHighlight",
                                    "textDocument/prepareRename",
                                    "textDocument/rename",
                                    "textDocument/codeAction",
                                    "textDocument/documentSymbol",
                                    "textDocument/foldingRange",
                                    "textDocument/selectionRange",
                                    "textDocument/documentLink",
                                    "textDocument/documentColor",
                                    "textDocument/semanticTokens/full",
                                    "textDocument/inlayHint",
                                    "workspace/symbol"};

void require(bool is_kept, const char* promise) {
  if (is_kept) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

/// A server, and what it has said.
struct Talk {
  std::size_t answers = 0;
  std::map<std::string, Json> found;  ///< by URI
  Server server{[this](const Json& message) { take(message); }, [](std::string_view) {}};
  int last_id = 0;

  Talk() {
    ask("initialize", {{"capabilities", Json::object()}});
    tell("initialized", Json::object());
  }

  void take(const Json& message) {
    dump(message);
    if (message.contains("id") && !message.contains("method")) ++answers;
    if (text_at(message, {"method"}) == "textDocument/publishDiagnostics") {
      found[text_at(message, {"params", "uri"})] = at(message, {"params", "diagnostics"});
    }
  }

  void ask(const std::string& method, const Json& params) {
    const std::size_t before = answers;
    server.handle({{"jsonrpc", "2.0"}, {"id", ++last_id}, {"method", method}, {"params", params}});
    require(answers == before + 1, "a request has one answer");
  }

  void tell(const std::string& method, const Json& params) {
    server.handle({{"jsonrpc", "2.0"}, {"method", method}, {"params", params}});
  }

  void open(const std::string& uri, std::string_view text) {
    tell("textDocument/didOpen",
         {{"textDocument", {{"uri", uri}, {"version", 1}, {"text", std::string(text)}}}});
  }
};

void replay_stream(std::string_view bytes) {
  Talk talk;
  std::istringstream in{std::string(bytes)};
  while (const auto text = read_message(in)) {
    talk.server.handle(Json::parse(*text, nullptr, false));
    talk.server.rest();
    if (talk.server.exit_code()) return;
  }
}

Json place(std::minstd_rand& random, std::size_t lines) {
  return {{"line", random() % (lines + 1)}, {"character", random() % 60}};
}

void edit_document(std::string_view text) {
  const bool is_xml = text.starts_with('<');
  const std::string path = std::string("/nowhere-at-all/") + (is_xml ? "r.urdf" : "a.yml");
  const std::string uri = "file://" + path;
  const std::string main = is_xml ? "files: [r.urdf]\n" : "files: [a.yml]\n";
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  std::minstd_rand random(static_cast<unsigned>(text.size() * 31 + lines));
  Talk talk;
  talk.open(kMain, main);
  talk.open(uri, text);
  talk.server.rest();
  for (const char* method : kMethods) {
    const Json at = place(random, lines);
    talk.ask(method, {{"textDocument", {{"uri", uri}}},
                      {"position", at},
                      {"positions", {at}},
                      {"range", {{"start", at}, {"end", place(random, lines)}}},
                      {"newName", "another"},
                      {"query", ""}});
  }
  const std::size_t from = text.empty() ? 0 : random() % text.size();
  const std::string inserted(text.substr(from, random() % 40));
  talk.tell("textDocument/didChange",
            {{"textDocument", {{"uri", uri}, {"version", 2}}},
             {"contentChanges",
              {{{"range", {{"start", place(random, lines)}, {"end", place(random, lines)}}},
                {"text", inserted}}}}});
  talk.server.rest();
  Talk fresh;
  fresh.open(kMain, main);
  fresh.open(uri, talk.server.workspace().document(path)->text);
  fresh.server.rest();
  require(talk.found[uri] == fresh.found[uri], "an edit changes what a fresh check finds");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.starts_with("Content-Length")) {
    replay_stream(bytes);
  } else {
    edit_document(bytes);
  }
  return 0;
}
