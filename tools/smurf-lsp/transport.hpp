// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes messages on streams: Content-Length, an empty line, JSON.
#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>

#include "smurf-lsp/json.hpp"
#include "smurf-lsp/messages.hpp"

namespace smurf::lsp {

/// The content of the next message; none at the end of the stream, and after a header that cannot
/// be read.
std::optional<std::string> read_message(std::istream& in);
/// `parts` follow each other in the text of the message.
void write_message(std::ostream& out, std::span<const std::string_view> parts);

/// Reads messages ahead in a thread, so that a waiting request can be cancelled. Invalid JSON
/// becomes a discarded value.
class Inbox {
 public:
  explicit Inbox(std::istream& in);
  /// Waits for `exit` or the end of the stream.
  ~Inbox();
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  Messages& messages() { return messages_; }

 private:
  void read(std::istream& in);

  Messages messages_;
  std::thread reader_;
};

}  // namespace smurf::lsp
