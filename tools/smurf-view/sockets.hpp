// SPDX-License-Identifier: BSD-3-Clause
// The few calls on sockets that a server on this machine needs; nothing blocks but wait().
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace smurf::tools::sockets {

using Socket = std::intptr_t;
inline constexpr Socket kNone = -1;

/// Listens on a free port of 127.0.0.1, which it stores in `port`. kNone with the reason if that
/// fails.
Socket listen_on_loopback(unsigned& port, std::string& reason);
/// The next client, or kNone.
Socket accept(Socket listener);
void close(Socket socket);

/// The number of bytes; 0 at the end; none when there is nothing yet.
std::optional<std::size_t> receive(Socket socket, std::span<char> to);
/// The number of sent bytes; 0 when the client is gone; none when it accepts no more yet.
std::optional<std::size_t> send(Socket socket, std::string_view text);

struct Interest {
  Socket socket = kNone;
  bool is_writing = false;  ///< wait until it accepts bytes, not until it has some
  bool is_ready = false;    ///< the answer
};
/// Waits until a socket is ready, or for so many milliseconds.
void wait(std::span<Interest> interests, int milliseconds);

}  // namespace smurf::tools::sockets
