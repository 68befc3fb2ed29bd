// SPDX-License-Identifier: BSD-3-Clause
// Serves one page, and what changes of it, to browsers on this machine. Answers GET of three
// addresses below a random one, so that no other page and no other user can ask for it, and no
// request that names another host.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "smurf-view/sockets.hpp"

namespace smurf::tools {

/// What a browser shows.
struct Shown {
  std::string page;     ///< the last one; "": there was none
  std::string problem;  ///< why there is no newer one, or ""
};

class PageServer {
 public:
  PageServer() = default;
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// "" or the reason why that failed.
  std::string start();
  /// "http://127.0.0.1:40123/jx83.../"
  std::string address() const;
  /// Answers those that wait for a change.
  void show(Shown shown);
  /// Answers requests until the time has passed.
  void serve(std::chrono::milliseconds time);

 private:
  using Clock = std::chrono::steady_clock;
  struct Client {
    std::string received;
    std::string to_send;  ///< the rest of the answer
    std::size_t sent = 0;
    std::optional<std::size_t> known;  ///< waits for a version that is not this one
    Clock::time_point since = Clock::now();
    bool is_over = false;
  };

  void take_clients();
  /// Makes room for a client: any page in a browser can open connections and say nothing.
  void drop_silent_client();
  void read(sockets::Socket socket, Client& client);
  void answer(Client& client);
  void answer_change(Client& client);
  static void write(sockets::Socket socket, Client& client);
  void drop_clients();

  sockets::Socket listener_ = sockets::kNone;
  unsigned port_ = 0;
  std::string secret_;
  std::size_t version_ = 0;
  Shown shown_;
  std::map<sockets::Socket, Client> clients_;
};

}  // namespace smurf::tools
