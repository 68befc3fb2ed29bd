// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes messages on streams: Content-Length, an empty line, JSON.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <iosfwd>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>

#include "smurf-lsp/json.hpp"

namespace smurf::lsp {

/// The content of the next message; none at the end of the stream, and after a header that cannot
/// be read.
std::optional<std::string> read_message(std::istream& in);
/// `parts` follow each other in the text of the message.
void write_message(std::ostream& out, std::span<const std::string_view> parts);

/// The member that marks a request that was cancelled before it was handled.
inline constexpr const char* kCancelled = "cancelled";

/// Reads messages ahead in a thread, so that a waiting request can be cancelled.
class Inbox {
 public:
  explicit Inbox(std::istream& in);
  /// Waits for `exit` or the end of the stream.
  ~Inbox();
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  /// Waits for the next message; none at the end of the stream. Invalid JSON becomes a discarded
  /// value.
  std::optional<Json> next();
  /// Whether no message waits.
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
