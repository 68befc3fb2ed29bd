// SPDX-License-Identifier: BSD-3-Clause
// std::bit_cast, which libc++ lacks before version 14.
#pragma once

#include <cstring>
#include <type_traits>

namespace smurf {

template <class To, class From>
To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
                std::is_trivially_copyable_v<From>);
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

}  // namespace smurf
