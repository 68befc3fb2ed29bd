// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <string>

#include "base/text/count.hpp"
#include "unit/random.hpp"

using namespace smurf;

TEST_CASE("count: as one by one, whatever the length") {
  test::Random random;
  for (std::size_t size = 0; size < 600; ++size) {
    std::string text(size, 'x');
    for (char& c : text) c = "a:\xFF b"[random.below(6)];
    std::size_t signs = 0;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < size; ++i) {
      signs += text[i] == ':' ? 1U : 0U;
      pairs += i + 1 < size && text[i] == ':' && text[i + 1] == ' ' ? 1U : 0U;
    }
    CAPTURE(text);
    CHECK(count_of(text, ':') == signs);
    CHECK(count_of(text, ':', ' ') == pairs);
  }
}

TEST_CASE("count: a block of nothing else") {
  const std::string text(1000, ':');
  CHECK(count_of(text, ':') == 1000);
  CHECK(count_of(text, ':', ':') == 999);
  CHECK(count_of({}, ':') == 0);
  CHECK(count_of({}, ':', ':') == 0);
}
