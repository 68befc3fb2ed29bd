// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/messages.hpp"

#include <utility>

namespace smurf::lsp {

bool is_request(const Json& message) { return message.is_object() && message.contains("id"); }

void Messages::push(Json message) {
  const std::lock_guard lock(mutex_);
  if (text_at(message, {"method"}) == "$/cancelRequest") {
    const Json& id = at(message, {"params", "id"});
    for (Json& waiting : waiting_) {
      if (!id.is_null() && at(waiting, {"id"}) == id) waiting[kCancelled] = true;
    }
    if (!id.is_null() && id == current_id_) is_current_cancelled_ = true;
  }
  waiting_.push_back(std::move(message));
  has_more_.notify_one();
}

void Messages::end() {
  const std::lock_guard lock(mutex_);
  is_over_ = true;
  has_more_.notify_one();
}

void Messages::cancel_all() {
  const std::lock_guard lock(mutex_);
  for (Json& waiting : waiting_) {
    if (is_request(waiting)) waiting[kCancelled] = true;
  }
  is_current_cancelled_ = true;
  is_over_ = true;
  has_more_.notify_one();
}

std::optional<Json> Messages::next() {
  std::unique_lock lock(mutex_);
  has_more_.wait(lock, [this] { return is_over_ || !waiting_.empty(); });
  if (waiting_.empty()) return std::nullopt;
  Json message = std::move(waiting_.front());
  waiting_.pop_front();
  current_id_ = at(message, {"id"});
  is_current_cancelled_ = false;
  return message;
}

bool Messages::is_empty() {
  const std::lock_guard lock(mutex_);
  return waiting_.empty();
}

bool Messages::is_cancelled() {
  const std::lock_guard lock(mutex_);
  return is_current_cancelled_;
}

}  // namespace smurf::lsp
