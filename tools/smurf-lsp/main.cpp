// SPDX-License-Identifier: BSD-3-Clause
// smurf-lsp: a language server with the engine of smurf-lint.
#include <fstream>
#include <iostream>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "common/cli/command.hpp"
#include "common/cli/process.hpp"
#include "common/files/output.hpp"
#include "smurf-lsp/background.hpp"
#include "smurf-lsp/server.hpp"
#include "smurf-lsp/transport.hpp"

using namespace smurf::tools;
using namespace smurf::lsp;

namespace {

constexpr std::string_view kTool = "smurf-lsp";

struct Options {
  std::string log;
  bool stdio = false;
};

Command lsp_command(Options& options) {
  Command command;
  command.name = kTool;
  command.summary =
      "A language server for SMURF and URDF: shows the findings of smurf-lint and the "
      "meaning of names and keys in an editor.";
  command.details =
      "An editor starts the server and sends it messages of the Language Server Protocol on "
      "standard input. The server reads the same configurations and comments as smurf-lint.";
  command.exit_with_1 = "the editor sent `exit` without `shutdown`";
  command.options = {
      {.group = "Server",
       .name = "log",
       .metavar = "FILE",
       .help = "Write a line for each message to FILE.",
       .set = set_text(options.log)},
      {.group = "Server",
       .name = "stdio",
       .help = "Use standard input and output. This is the default; some editors pass the option.",
       .set = set_flag(options.stdio)},
  };
  command.examples = {{"smurf-lsp", "Start the server, as editors do:"},
                      {"smurf-lsp --log /tmp/smurf-lsp.log", "Write a log of all messages:"}};
  return command;
}

int serve(std::ostream* log) {
  std::ios::sync_with_stdio(false);
  std::cin.tie(nullptr);
  std::mutex mutex;  // several threads send messages and write the log
  const auto send = [&](std::span<const std::string_view> parts) {
    const std::lock_guard lock(mutex);
    write_message(std::cout, parts);
  };
  const auto note = [&](std::string_view line) {
    const std::lock_guard lock(mutex);
    if (log != nullptr) *log << line << std::endl;
  };
  Server server(send, note);
  Background checks(send, note, "checks", {"workspace/diagnostic"});
  Background names(send, note, "names", {"workspace/symbol", "textDocument/rename"});
  Background pictures(send, note, "pictures", {"smurf/picture"});
  Inbox inbox(std::cin);
  Messages& messages = inbox.messages();
  while (!server.exit_code()) {
    if (messages.is_empty()) server.rest();
    const std::optional<Json> message = messages.next();
    if (!message) return kFailed;  // the editor is gone
    const bool is_check = checks.take(*message, server.workspace());
    const bool is_of_names = names.take(*message, server.workspace());
    const bool is_picture = pictures.take(*message, server.workspace());
    if (!is_check && !is_of_names && !is_picture) server.handle(*message);
  }
  return *server.exit_code();
}

}  // namespace

int smurf_lsp_main(int argc, char** argv) {
  prepare_process();
  Options options;
  if (const auto code = parse_command_line(lsp_command(options), argc, argv)) return *code;
  if (options.log.empty()) return serve(nullptr);
  std::ofstream log(options.log, std::ios::app);
  if (!log) {
    complain(kTool, "cannot write '" + options.log + "'");
    return kFailed;
  }
  return serve(&log);
}
