// SPDX-License-Identifier: BSD-3-Clause
#include "base/recent_map.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace smurf;

TEST_CASE("the last names are known, and old ones are forgotten") {
  using Numbers = RecentMap<std::size_t>;
  Numbers numbers;
  CHECK(numbers.find("used") == nullptr);
  CHECK(numbers.add("used", 7) == 7);
  CHECK(numbers.add("used", 8) == 7);
  const std::size_t count = 5 * Numbers::kMost;
  std::size_t most = 0;
  for (std::size_t i = 0; i < count; ++i) {
    REQUIRE(numbers.add(std::to_string(i), i) == i);
    // What is used again and again stays.
    if (i % 100 == 0) {
      REQUIRE(numbers.find("used") != nullptr);
      REQUIRE(*numbers.find("used") == 7);
    }
    most = std::max(most, numbers.size());
  }
  CHECK(most <= 2 * Numbers::kMost);
  for (std::size_t i = count - Numbers::kMost / 2; i < count; ++i) {
    const std::size_t* const found = numbers.find(std::to_string(i));
    REQUIRE(found != nullptr);
    CHECK(*found == i);
  }
  CHECK(numbers.find("0") == nullptr);
  CHECK(numbers.add("0", 9) == 9);
}
