// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-view/sockets.hpp"

#include <vector>

#include <winsock2.h>

namespace smurf::tools::sockets {
namespace {

constexpr int kWaiting = 16;  // clients

SOCKET to_windows(Socket socket) { return static_cast<SOCKET>(socket); }

bool make_quick(SOCKET socket) {
  u_long is_quick = 1;
  return ::ioctlsocket(socket, FIONBIO, &is_quick) == 0;
}

std::optional<std::size_t> moved(int bytes) {
  if (bytes >= 0) return static_cast<std::size_t>(bytes);
  if (::WSAGetLastError() == WSAEWOULDBLOCK) return std::nullopt;
  return 0;
}

int at_most(std::size_t size) {
  constexpr std::size_t kMost = 1U << 20U;
  return static_cast<int>(size < kMost ? size : kMost);
}

}  // namespace

Socket listen_on_loopback(unsigned& port, std::string& reason) {
  WSADATA data{};
  if (::WSAStartup(MAKEWORD(2, 2), &data) != 0) {
    reason = "this Windows has no network";
    return kNone;
  }
  const SOCKET listener = ::socket(AF_INET, SOCK_STREAM, IPPROTO_TCP);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = ::htonl(INADDR_LOOPBACK);
  int size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  if (listener != INVALID_SOCKET && make_quick(listener) && ::bind(listener, any, size) == 0 &&
      ::listen(listener, kWaiting) == 0 && ::getsockname(listener, any, &size) == 0) {
    port = ::ntohs(address.sin_port);
    return static_cast<Socket>(listener);
  }
  reason = "error " + std::to_string(::WSAGetLastError());
  if (listener != INVALID_SOCKET) ::closesocket(listener);
  return kNone;
}

Socket accept(Socket listener) {
  const SOCKET client = ::accept(to_windows(listener), nullptr, nullptr);
  if (client == INVALID_SOCKET) return kNone;
  if (make_quick(client)) return static_cast<Socket>(client);
  ::closesocket(client);
  return kNone;
}

void close(Socket socket) { ::closesocket(to_windows(socket)); }

std::optional<std::size_t> receive(Socket socket, std::span<char> to) {
  return moved(::recv(to_windows(socket), to.data(), at_most(to.size()), 0));
}

std::optional<std::size_t> send(Socket socket, std::string_view text) {
  return moved(::send(to_windows(socket), text.data(), at_most(text.size()), 0));
}

void wait(std::span<Interest> interests, int milliseconds) {
  std::vector<WSAPOLLFD> polled;
  for (const Interest& one : interests) {
    polled.push_back(
        {to_windows(one.socket), static_cast<SHORT>(one.is_writing ? POLLOUT : POLLIN), 0});
  }
  if (::WSAPoll(polled.data(), static_cast<ULONG>(polled.size()), milliseconds) < 0) {
    for (WSAPOLLFD& one : polled) one.revents = 0;
  }
  for (std::size_t i = 0; i < polled.size(); ++i) interests[i].is_ready = polled[i].revents != 0;
}

}  // namespace smurf::tools::sockets
