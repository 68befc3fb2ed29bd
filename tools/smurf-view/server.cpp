// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-view/server.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "common/files/random_word.hpp"
#include "smurf-view/frame_page.hpp"
#include "write/text/json_text.hpp"

namespace smurf::tools {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMostClients = 64;
constexpr std::size_t kMostRequest = 16384;  ///< bytes
constexpr auto kLongestRequest = 10s;        ///< browsers connect before they have a question
constexpr auto kLongestWait = 25s;           ///< for a change; then the page asks again
constexpr std::size_t kSecretLetters = 24;

struct Request {
  std::string_view method, target, host;
};

/// The first line and the host of a request that has all of its headers.
std::optional<Request> parse(std::string_view text) {
  const std::size_t end = text.find("\r\n");
  const std::string_view line = text.substr(0, end);
  const std::size_t first = line.find(' ');
  const std::size_t second = first == std::string_view::npos ? first : line.find(' ', first + 1);
  if (second == std::string_view::npos || line.substr(second, 8) != " HTTP/1.") return {};
  Request request{line.substr(0, first), line.substr(first + 1, second - first - 1), {}};
  for (std::size_t at = end + 2; at < text.size();) {
    const std::size_t next = std::min(text.find("\r\n", at), text.size());
    const std::string_view header = text.substr(at, next - at);
    constexpr std::string_view kHost = "host:";
    const auto is_same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; };
    if (header.size() > kHost.size() &&
        std::equal(kHost.begin(), kHost.end(), header.begin(),
                   [&](char wanted, char written) { return is_same(written, wanted); })) {
      if (!request.host.empty()) return {};
      request.host = header.substr(kHost.size());
      while (request.host.starts_with(' ')) request.host.remove_prefix(1);
      while (request.host.ends_with(' ')) request.host.remove_suffix(1);
    }
    at = next + 2;
  }
  return request;
}

std::string response(std::string_view status, std::string_view type, std::string_view body) {
  std::string text = "HTTP/1.1 ";
  text.append(status).append("\r\nContent-Type: ").append(type);
  text += "; charset=utf-8\r\nContent-Length: " + std::to_string(body.size()) +
          "\r\nConnection: close\r\nCache-Control: no-store\r\nReferrer-Policy: no-referrer"
          "\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: SAMEORIGIN"
          "\r\nCross-Origin-Resource-Policy: same-origin\r\n\r\n";
  return text.append(body);
}

/// The data of a page of the viewer, which contain no "<".
std::string_view scene_in(std::string_view page) {
  const std::size_t name = page.find("id=\"scene\" ");
  const std::size_t begin = name == std::string_view::npos ? name : page.find('>', name);
  if (begin == std::string_view::npos) return {};
  const std::size_t end = page.find('<', begin);
  return page.substr(begin + 1, end == std::string_view::npos ? end : end - begin - 1);
}

}  // namespace

PageServer::~PageServer() {
  for (const auto& [socket, client] : clients_) sockets::close(socket);
  if (listener_ != sockets::kNone) sockets::close(listener_);
}

std::string PageServer::start() {
  std::string reason;
  listener_ = sockets::listen_on_loopback(port_, reason);
  secret_ = random_word(kSecretLetters);
  return reason;
}

std::string PageServer::address() const {
  return "http://127.0.0.1:" + std::to_string(port_) + "/" + secret_ + "/";
}

void PageServer::show(Shown shown) {
  ++version_;
  if (shown.page.empty()) shown.page = std::move(shown_.page);
  shown_ = std::move(shown);
  for (auto& [socket, client] : clients_) {
    if (client.known) answer_change(client);
  }
}

void PageServer::serve(std::chrono::milliseconds time) {
  const Clock::time_point until = Clock::now() + time;
  for (;;) {
    std::vector<sockets::Interest> interests{{listener_, false, false}};
    for (const auto& [socket, client] : clients_) {
      interests.push_back({socket, !client.to_send.empty(), false});
    }
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) return;
    sockets::wait(interests, static_cast<int>(left));
    if (interests.front().is_ready) take_clients();
    for (const sockets::Interest& one : interests) {
      const auto client = clients_.find(one.socket);
      if (!one.is_ready || client == clients_.end()) continue;
      if (one.is_writing) {
        write(one.socket, client->second);
      } else {
        read(one.socket, client->second);
      }
    }
    drop_clients();
  }
}

void PageServer::take_clients() {
  for (;;) {
    const sockets::Socket socket = sockets::accept(listener_);
    if (socket == sockets::kNone) return;
    if (clients_.size() >= kMostClients) drop_silent_client();
    if (clients_.size() < kMostClients) {
      clients_[socket] = {};
    } else {
      sockets::close(socket);
    }
  }
}

void PageServer::drop_silent_client() {
  auto longest = clients_.end();
  for (auto one = clients_.begin(); one != clients_.end(); ++one) {
    const bool is_silent = !one->second.known && one->second.to_send.empty();
    const bool is_longer = longest == clients_.end() || one->second.since < longest->second.since;
    if (is_silent && is_longer) longest = one;
  }
  if (longest == clients_.end()) return;
  sockets::close(longest->first);
  clients_.erase(longest);
}

void PageServer::read(sockets::Socket socket, Client& client) {
  std::array<char, 4096> bytes{};
  const std::optional<std::size_t> size = sockets::receive(socket, bytes);
  if (!size) return;
  client.received.append(bytes.data(), *size);
  // A client that waits for a change has nothing more to say.
  client.is_over = *size == 0 || client.received.size() > kMostRequest || client.known;
  const std::size_t end = client.received.find("\r\n\r\n");
  if (client.is_over || end == std::string::npos) return;
  client.received.resize(end + 2);
  answer(client);
}

void PageServer::answer(Client& client) {
  constexpr std::string_view kText = "text/plain", kPage = "text/html";
  const std::optional<Request> request = parse(client.received);
  const std::string host = "127.0.0.1:" + std::to_string(port_);
  const std::string folder = "/" + secret_ + "/";
  if (!request) {
    client.to_send = response("400 Bad Request", kText, "smurf-view cannot read this request\n");
  } else if (request->host != host) {
    client.to_send = response("421 Misdirected Request", kText, "smurf-view has another address\n");
  } else if (request->method != "GET") {
    client.to_send = response("405 Method Not Allowed", kText, "smurf-view only shows\n");
  } else if (request->target == folder) {
    client.to_send = response("200 OK", kPage, frame_page(random_word(kSecretLetters)));
  } else if (request->target == folder + "page" && !shown_.page.empty()) {
    client.to_send = response("200 OK", kPage, shown_.page);
  } else if (const std::string ask = folder + "changes?after="; request->target.starts_with(ask)) {
    const std::string_view number = request->target.substr(ask.size());
    std::size_t known = 0;
    std::from_chars(number.data(), number.data() + number.size(), known);
    client.known = known;
    client.since = Clock::now();
    if (known != version_) answer_change(client);
  } else {
    client.to_send = response("404 Not Found", kText, "smurf-view has no such page\n");
  }
}

void PageServer::answer_change(Client& client) {
  client.known.reset();
  std::string body = "{";
  append_key(body, "version", true);
  body += std::to_string(version_);
  append_key(body, "scene");
  append_json(body, scene_in(shown_.page));
  append_key(body, "problem");
  append_json(body, shown_.problem);
  body += "}";
  client.to_send = response("200 OK", "application/json", body);
}

void PageServer::write(sockets::Socket socket, Client& client) {
  const std::string_view rest = std::string_view(client.to_send).substr(client.sent);
  const std::optional<std::size_t> size = sockets::send(socket, rest);
  if (!size) return;
  client.sent += *size;
  client.since = Clock::now();
  client.is_over = *size == 0 || client.sent == client.to_send.size();
}

void PageServer::drop_clients() {
  const Clock::time_point now = Clock::now();
  for (auto& [socket, client] : clients_) {
    const auto time = now - client.since;
    if (client.known && time > kLongestWait) answer_change(client);
    if (!client.known && time > kLongestRequest) client.is_over = true;
  }
  for (auto one = clients_.begin(); one != clients_.end();) {
    if (one->second.is_over) sockets::close(one->first);
    one = one->second.is_over ? clients_.erase(one) : std::next(one);
  }
}

}  // namespace smurf::tools
