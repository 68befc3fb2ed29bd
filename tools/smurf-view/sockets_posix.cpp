// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-view/sockets.hpp"

#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

namespace smurf::tools::sockets {
namespace {

constexpr int kWaiting = 16;  // clients

bool make_quick(int socket) {
  return ::fcntl(socket, F_SETFD, FD_CLOEXEC) == 0 && ::fcntl(socket, F_SETFL, O_NONBLOCK) == 0;
}

std::optional<std::size_t> moved(ssize_t bytes) {
  if (bytes >= 0) return static_cast<std::size_t>(bytes);
  if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) return std::nullopt;
  return 0;
}

}  // namespace

Socket listen_on_loopback(unsigned& port, std::string& reason) {
  const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  if (listener >= 0 && make_quick(listener) && ::bind(listener, any, size) == 0 &&
      ::listen(listener, kWaiting) == 0 && ::getsockname(listener, any, &size) == 0) {
    port = ntohs(address.sin_port);
    return listener;
  }
  reason = std::strerror(errno);
  if (listener >= 0) ::close(listener);
  return kNone;
}

Socket accept(Socket listener) {
  const int client = ::accept(static_cast<int>(listener), nullptr, nullptr);
  if (client < 0 || make_quick(client)) return client < 0 ? kNone : client;
  ::close(client);
  return kNone;
}

void close(Socket socket) { ::close(static_cast<int>(socket)); }

std::optional<std::size_t> receive(Socket socket, std::span<char> to) {
  return moved(::recv(static_cast<int>(socket), to.data(), to.size(), 0));
}

std::optional<std::size_t> send(Socket socket, std::string_view text) {
  return moved(::send(static_cast<int>(socket), text.data(), text.size(), 0));
}

void wait(std::span<Interest> interests, int milliseconds) {
  std::vector<pollfd> polled;
  for (const Interest& one : interests) {
    polled.push_back(
        {static_cast<int>(one.socket), static_cast<short>(one.is_writing ? POLLOUT : POLLIN), 0});
  }
  if (::poll(polled.data(), static_cast<nfds_t>(polled.size()), milliseconds) < 0) {
    for (pollfd& one : polled) one.revents = 0;  // a signal
  }
  for (std::size_t i = 0; i < polled.size(); ++i) interests[i].is_ready = polled[i].revents != 0;
}

}  // namespace smurf::tools::sockets
