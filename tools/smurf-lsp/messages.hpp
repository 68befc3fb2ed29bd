// SPDX-License-Identifier: BSD-3-Clause
// Messages from one thread to another.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

#include "smurf-lsp/json.hpp"

namespace smurf::lsp {

/// The member that marks a request that was cancelled before it was handled.
inline constexpr const char* kCancelled = "cancelled";

/// Whether the sender of a message waits for an answer.
bool is_request(const Json& message);

/// Messages that wait, first in, first out.
class Messages {
 public:
  /// `$/cancelRequest` cancels a request that waits or that next() has returned last. The message
  /// itself is added, too.
  void push(Json message);
  /// No more messages will come.
  void end();
  /// The same, and also cancels all requests without an answer.
  void cancel_all();

  /// Waits for the next message; none after the end.
  std::optional<Json> next();
  bool is_empty();
  /// Whether the message that next() has returned last is cancelled.
  bool is_cancelled();

 private:
  std::mutex mutex_;
  std::condition_variable has_more_;
  std::deque<Json> waiting_;
  Json current_id_;  ///< null: a notification
  bool is_current_cancelled_ = false;
  bool is_over_ = false;
};

}  // namespace smurf::lsp
