// SPDX-License-Identifier: BSD-3-Clause
// Messages on streams: Content-Length, an empty line, JSON.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <iosfwd>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "smurf-lsp/json.hpp"

namespace smurf::lsp {

/// The content of the next message; none at the end of the stream, or where no message can be told
/// any more.
std::optional<std::string> read_message(std::istream& in);
void write_message(std::ostream& out, const Json& message);

/// The member of a request that was cancelled before anybody looked at it.
inline constexpr const char* kCancelled = "cancelled";

/// Messages that a thread reads ahead, so that a request can be cancelled before it is begun.
class Inbox {
 public:
  explicit Inbox(std::istream& in);
  /// Waits for `exit` or the end of the stream.
  ~Inbox();
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  /// Waits for the next one; none at the end of the stream. What is no JSON is discarded as JSON.
  std::optional<Json> next();
  /// Whether there is nothing to do at the moment.
  bool is_empty();

 private:
  void read(std::istream& in);
  void take(Json message);

  std::mutex mutex_;
  std::condition_variable has_more_;
  std::deque<Json> messages_;
  bool is_over_ = false;
  std::thread reader_;
};

}  // namespace smurf::lsp
