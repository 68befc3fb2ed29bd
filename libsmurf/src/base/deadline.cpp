// SPDX-License-Identifier: BSD-3-Clause
#include "base/deadline.hpp"

#include <chrono>

#include "base/files/system.hpp"

namespace smurf {
namespace {

thread_local Deadline* innermost = nullptr;
thread_local std::uint64_t calls = 0;

/// s, on the clock of the machine, which is read without a system call.
double machine_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

double thread_seconds() {
  ++calls;
  return sys::thread_seconds();
}

}  // namespace

Deadline::Deadline(std::uint64_t seconds) : outer_(innermost) {
  if (seconds > 0) {
    earliest_ = machine_seconds() + static_cast<double>(seconds);
    end_ = thread_seconds() + static_cast<double>(seconds);
  }
  if (outer_ != nullptr && outer_->end_ > 0 && (end_ == 0 || outer_->end_ < end_)) {
    end_ = outer_->end_;
    earliest_ = outer_->earliest_;
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
  // A thread cannot use more processor time than passes on the clock of the machine.
  const double now = machine_seconds();
  if (now < at->earliest_) return;
  const double left = at->end_ - thread_seconds();
  if (left < 0) throw OutOfTime{};
  at->earliest_ = now + left;
}

std::uint64_t Deadline::count_of_calls() { return calls; }

}  // namespace smurf
