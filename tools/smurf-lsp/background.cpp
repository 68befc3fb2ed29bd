// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/background.hpp"

#include <string>
#include <utility>

namespace smurf::lsp {
namespace {

bool is_about_folders(const Json& message) {
  const std::string method = text_at(message, {"method"});
  return is_request(message) && (method == "workspace/diagnostic" || method == "workspace/symbol");
}

bool changes_state(const Json& message) {
  const std::string method = text_at(message, {"method"});
  return !is_request(message) || method == "initialize" || method == "shutdown";
}

}  // namespace

Background::Background(Send send, Log log)
    : server_(std::move(send), std::move(log),
              {"folders", [this] { return messages_.is_cancelled(); }}),
      thread_([this] { run(); }) {}

Background::~Background() {
  messages_.cancel_all();
  thread_.join();
}

bool Background::take(const Json& message) {
  const bool is_own = is_about_folders(message);
  if (is_own || changes_state(message)) messages_.push(message);
  return is_own;
}

void Background::run() {
  while (const std::optional<Json> message = messages_.next()) {
    if (is_about_folders(*message)) {
      server_.handle(*message);
    } else {
      server_.follow(*message);
    }
  }
}

}  // namespace smurf::lsp
