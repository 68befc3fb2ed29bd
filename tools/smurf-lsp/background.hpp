// SPDX-License-Identifier: BSD-3-Clause
// Answers requests about whole folders in other threads: typing never waits for them.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "smurf-lsp/messages.hpp"
#include "smurf-lsp/server.hpp"

namespace smurf::lsp {

/// A second server in a thread, with its own copies of the documents, so that the threads share no
/// data. Both servers send messages and write the log.
class Background {
 public:
  /// `name` begins the ids of its own requests; `methods` are the requests that it answers.
  Background(Send send, Log log, std::string name, std::vector<std::string_view> methods);
  /// Cancels the requests that have no answer yet, and waits for these answers.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Whether the message is a request that this server answers. From other messages, which the
  /// first server answers, notes the data about the client and the documents. `current` has the
  /// documents with all changes before this message.
  bool take(const Json& message, const Workspace& current);

 private:
  bool is_own(const Json& message) const;
  void run();

  const std::vector<std::string_view> methods_;
  std::set<std::string> changed_;  ///< documents whose new text this server does not have yet
  Messages messages_;
  Server server_;
  std::thread thread_;
};

}  // namespace smurf::lsp
