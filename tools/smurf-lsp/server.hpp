// SPDX-License-Identifier: BSD-3-Clause
// Receives messages of a client and answers them.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "smurf-lsp/context.hpp"

namespace smurf::lsp {

struct ServerOptions {
  std::string name = "server";         ///< begins the ids of the server's own requests
  std::function<bool()> is_cancelled;  ///< whether the current request is cancelled
  /// Seconds of processor time for a request; 0: as many as its files may take, each of them
  /// kSecondsInEditor.
  std::uint64_t max_seconds = kSecondsInEditor;
};

class Server {
 public:
  Server(Send send, Log log, ServerOptions options = {});

  void handle(const Json& message);
  /// Stores the data of a message about the client and the documents, without sending anything.
  void follow(const Json& message);
  /// Publishes the findings of the current texts. Call it when no message waits.
  void rest();

  const Workspace& workspace() const { return context_.workspace; }
  /// The exit code after `exit`: 0 if `shutdown` came before it.
  std::optional<int> exit_code() const { return exit_code_; }

 private:
  bool is_running() const { return is_initialized_ && !is_shut_down_; }
  /// The reaction of follow() to a notification.
  void note(const std::string& method, const Json& params);
  void notify(const std::string& method, const Json& params);
  Json answer(const std::string& method, const Json& params);
  void reply(const Json& id, Json result);
  void refuse(const Json& id, int code, std::string_view message);
  void begin(const Json& params);
  void initialize(const Json& id, const Json& params);

  Context context_;
  Log log_;
  std::uint64_t max_seconds_ = 0;  ///< for each request; see ServerOptions
  bool is_initialized_ = false;
  bool is_shut_down_ = false;
  std::optional<int> exit_code_;
  std::set<std::string> shown_;  ///< files with published findings
};

}  // namespace smurf::lsp
