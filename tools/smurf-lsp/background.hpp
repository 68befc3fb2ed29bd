// SPDX-License-Identifier: BSD-3-Clause
// Requests about whole folders, answered in a thread of their own: typing never waits for them.
#pragma once

#include <thread>

#include "smurf-lsp/messages.hpp"
#include "smurf-lsp/server.hpp"

namespace smurf::lsp {

/// A second server, with its own copies of the documents, so that the threads share no data. Both
/// send messages and write the log.
class Background {
 public:
  Background(Send send, Log log);
  /// Cancels the requests that have no answer yet, and waits for these answers.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Whether the message is a request that is answered here. Others are for the first server; what
  /// they tell about the documents and the client is noted here, too.
  bool take(const Json& message);

 private:
  void run();

  Messages messages_;
  Server server_;
  std::thread thread_;
};

}  // namespace smurf::lsp
