// SPDX-License-Identifier: BSD-3-Clause
// Memory for the trees of an expansion, which all end together: taken in large pieces, and given
// back as a whole. What is in it is not destroyed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace smurf::xacro {

class Arena {
 public:
  void* take(std::size_t bytes) {
    constexpr std::size_t kAlignment = alignof(std::max_align_t);
    const std::size_t size = (bytes + kAlignment - 1) / kAlignment * kAlignment;
    if (size > left_) {
      left_ = std::max(size, next_);
      next_ = std::min(next_ * 2, kLargest);
      // libc++ 14 has no make_unique_for_overwrite.
      pieces_.push_back(std::unique_ptr<std::byte[]>(new std::byte[left_]));
      at_ = pieces_.back().get();
    }
    void* place = at_;
    at_ += size;
    left_ -= size;
    return place;
  }

  /// Copies of a text, and of values that need not be destroyed.
  std::string_view keep(std::string_view text) {
    char* const place = static_cast<char*>(take(text.size()));
    std::copy_n(text.data(), text.size(), place);
    return {place, text.size()};
  }
  template <class T>
  std::span<const T> keep(std::span<const T> values) {
    T* const place = static_cast<T*>(take(values.size_bytes()));
    std::uninitialized_copy(values.begin(), values.end(), place);
    return {place, values.size()};
  }

  template <class T, class... Parameters>
  T& make(Parameters&&... parameters) {
    return *new (take(sizeof(T))) T(std::forward<Parameters>(parameters)...);
  }

 private:
  static constexpr std::size_t kLargest = std::size_t{1} << 20U;
  std::vector<std::unique_ptr<std::byte[]>> pieces_;
  std::byte* at_ = nullptr;
  std::size_t left_ = 0;
  std::size_t next_ = std::size_t{1} << 15U;
};

template <class T>
class ArenaAllocator {
 public:
  using value_type = T;
  explicit ArenaAllocator(Arena& arena) : arena_(&arena) {}
  template <class U>
  explicit(false) ArenaAllocator(const ArenaAllocator<U>& other) : arena_(&other.arena()) {}

  T* allocate(std::size_t count) { return static_cast<T*>(arena_->take(count * sizeof(T))); }
  void deallocate(T*, std::size_t) {}
  Arena& arena() const { return *arena_; }
  template <class U>
  bool operator==(const ArenaAllocator<U>& other) const {
    return arena_ == &other.arena();
  }

 private:
  Arena* arena_;
};

template <class T>
using ArenaVector = std::vector<T, ArenaAllocator<T>>;

}  // namespace smurf::xacro
