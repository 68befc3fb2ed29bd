// SPDX-License-Identifier: BSD-3-Clause
// The language server: a stream of messages, or a document that is asked about everywhere and then
// edited, as is another file of its model. Each request gets one answer, and after the edits the
// findings equal those of a new server.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

#include "fuzz/clock.hpp"
#include "smurf-lsp/server.hpp"
#include "smurf-lsp/transport.hpp"

using namespace smurf::lsp;

namespace {

constexpr const char* kMain = "file:///nowhere-at-all/m.smurf";
constexpr const char* kUrdf = "file:///nowhere-at-all/r.urdf";
constexpr const char* kMotors = "file:///nowhere-at-all/a.yml";
constexpr std::string_view kUris[] = {kMain, kUrdf, kMotors};
constexpr std::size_t kFolder = std::string_view("file://").size();

constexpr const char* kSomeRobot =
    "<robot name=\"r\">\n<link name=\"a\"/>\n<link name=\"b\"/>\n"
    "<joint name=\"j\" type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/></joint>\n"
    "</robot>\n";
constexpr const char* kSomeMotors = "motors:\n- {name: m, joint: j, maxSpeed: 1}\n";

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

/// A server and its messages.
struct Talk {
  std::size_t answers = 0;
  std::map<std::string, Json> found;  ///< by URI
  Server server{[this](std::span<const std::string_view> parts) { take(parts); },
                [](std::string_view) {}};
  int last_id = 0;

  Talk() {
    ask("initialize", {{"capabilities", Json::object()}});
    tell("initialized", Json::object());
  }

  void take(std::span<const std::string_view> parts) {
    std::string text;
    for (const std::string_view part : parts) text += part;
    const Json message = Json::parse(text);
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

/// Usually within the text.
Json place(std::minstd_rand& random, std::size_t lines) {
  if (random() % 20 == 0) return {{"line", -1}, {"character", 4294967296}};
  return {{"line", random() % (lines + 2)}, {"character", random() % 60}};
}

std::size_t count_lines(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

void ask_everything(Talk& talk, std::string_view uri, std::size_t lines, std::minstd_rand& random) {
  for (const char* method : kMethods) {
    const Json at = place(random, lines);
    talk.ask(method, {{"textDocument", {{"uri", uri}}},
                      {"position", at},
                      {"positions", {at}},
                      {"range", {{"start", at}, {"end", place(random, lines)}}},
                      {"newName", "another"},
                      {"query", ""}});
  }
}

std::string text_of(const Talk& talk, std::string_view uri) {
  return talk.server.workspace().document(std::string(uri.substr(kFolder)))->text;
}

/// Replaces a part of the text by another part, sometimes many times.
void edit(Talk& talk, std::string_view uri, std::minstd_rand& random) {
  const std::string text = text_of(talk, uri);
  const std::size_t lines = count_lines(text);
  const std::size_t from = text.empty() ? 0 : random() % text.size();
  const std::string part = text.substr(from, random() % 40);
  std::string inserted;
  const std::size_t times = random() % 50 == 0 ? 500 : 1;
  for (std::size_t i = 0; i < times; ++i) inserted += part;
  talk.tell("textDocument/didChange",
            {{"textDocument", {{"uri", uri}, {"version", 2}}},
             {"contentChanges",
              {{{"range", {{"start", place(random, lines)}, {"end", place(random, lines)}}},
                {"text", inserted}}}}});
  talk.server.rest();
}

void require_as_fresh(Talk& talk) {
  Talk fresh;
  for (const std::string_view uri : kUris) fresh.open(std::string(uri), text_of(talk, uri));
  fresh.server.rest();
  for (const std::string_view uri : kUris) {
    require(talk.found[std::string(uri)] == fresh.found[std::string(uri)],
            "an edit changes what a fresh check finds");
  }
}

void edit_document(std::string_view text) {
  const bool is_xml = text.starts_with('<');
  const std::string uri = is_xml ? kUrdf : kMotors;
  const std::string other = is_xml ? kMotors : kUrdf;
  std::minstd_rand random(static_cast<unsigned>(text.size() * 31 + count_lines(text)));
  Talk talk;
  talk.open(kMain, "files: [r.urdf, a.yml]\n");
  talk.open(uri, text);
  talk.open(other, is_xml ? kSomeMotors : kSomeRobot);
  talk.server.rest();
  ask_everything(talk, uri, count_lines(text), random);
  // Unchanged parts are parsed for the last time in the second check after a change.
  for (const std::string& edited : {other, other, uri}) edit(talk, edited, random);
  require_as_fresh(talk);
  for (const std::string& edited : {uri, other}) edit(talk, edited, random);
  require_as_fresh(talk);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.starts_with("Content-Length")) {
    replay_stream(bytes);
  } else {
    edit_document(bytes);
  }
  return 0;
}
