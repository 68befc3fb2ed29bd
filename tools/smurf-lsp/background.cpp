// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/background.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace smurf::lsp {
namespace {

bool changes_state(const Json& message) {
  const std::string method = text_at(message, {"method"});
  return !is_request(message) || method == "initialize" || method == "shutdown";
}

/// Waits for the last text, so key strokes cost nothing here.
Json change_to(const OpenDocument& document) {
  return {{"method", "textDocument/didChange"},
          {"params",
           {{"textDocument", {{"uri", document.uri}, {"version", document.version}}},
            {"contentChanges", {{{"text", document.text}}}}}}};
}

}  // namespace

Background::Background(Send send, Log log, std::string name, std::vector<std::string_view> methods)
    : methods_(std::move(methods)),
      server_(std::move(send), std::move(log),
              {std::move(name), [this] { return messages_.is_cancelled(); }, 0}),
      thread_([this] { run(); }) {}

Background::~Background() {
  messages_.cancel_all();
  thread_.join();
}

bool Background::is_own(const Json& message) const {
  const std::string method = text_at(message, {"method"});
  return is_request(message) &&
         std::find(methods_.begin(), methods_.end(), method) != methods_.end();
}

bool Background::take(const Json& message, const Workspace& current) {
  if (text_at(message, {"method"}) == "textDocument/didChange") {
    changed_.insert(path_in(at(message, {"params"})));
    return false;
  }
  const bool is_taken = is_own(message);
  if (is_taken) {
    for (const std::string& path : changed_) {
      const OpenDocument* document = current.document(path);
      if (document != nullptr) messages_.push(change_to(*document));
    }
    changed_.clear();
  }
  if (is_taken || changes_state(message)) messages_.push(message);
  return is_taken;
}

void Background::run() {
  while (const std::optional<Json> message = messages_.next()) {
    if (is_own(*message)) {
      server_.handle(*message);
    } else {
      server_.follow(*message);
    }
  }
}

}  // namespace smurf::lsp
