// SPDX-License-Identifier: BSD-3-Clause
#include "base/deadline.hpp"

#include <algorithm>

#include "base/files/system.hpp"

namespace smurf {
namespace {

thread_local Deadline* innermost = nullptr;

}  // namespace

Deadline::Deadline(std::uint64_t seconds) : outer_(innermost) {
  if (seconds > 0) end_ = sys::thread_seconds() + static_cast<double>(seconds);
  if (outer_ != nullptr && outer_->end_ > 0) {
    end_ = end_ > 0 ? std::min(end_, outer_->end_) : outer_->end_;
  }
  innermost = this;
}

Deadline::~Deadline() { innermost = outer_; }

void Deadline::look(std::uint64_t work) {
  Deadline* const at = innermost;
  if (at == nullptr || at->end_ == 0) return;
  at->work_ += work;
  if (at->work_ < kWorkOfLook) return;
  at->work_ = 0;
  if (sys::thread_seconds() > at->end_) throw OutOfTime{};
}

}  // namespace smurf
