// SPDX-License-Identifier: BSD-3-Clause
// Owns an open file.
#pragma once

#include <utility>

#include "base/files/system.hpp"

namespace smurf {

/// An open file or folder; negative: none.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { reset(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    reset(std::exchange(other.number_, -1));
    return *this;
  }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void reset(int number = -1) {
    if (number_ >= 0) sys::close(number_);
    number_ = number;
  }

 private:
  int number_;
};

}  // namespace smurf
