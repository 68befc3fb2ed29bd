// SPDX-License-Identifier: BSD-3-Clause
// The linear search of texts against that of the standard library.
#include <doctest/doctest.h>

#include <random>
#include <string>

#include "smurf/limits.hpp"
#include "xacro/text_search.hpp"

using namespace smurf;
using xacro::TextSearch;

namespace {

/// A text of few letters, parts of which often repeat.
std::string random_text(std::mt19937& dice, std::size_t most, char letters) {
  std::string text;
  const std::size_t size = dice() % (most + 1);
  while (text.size() < size) {
    const std::size_t begin = text.empty() ? 0 : dice() % text.size();
    if (dice() % 4 == 0) {
      text += text.substr(begin, 1 + dice() % 9);
    } else {
      text.push_back(
          static_cast<char>('a' + static_cast<char>(dice() % static_cast<unsigned>(letters))));
    }
  }
  return text;
}

}  // namespace

TEST_CASE("the search finds what the standard library finds") {
  std::mt19937 dice(1);
  Limits limits;
  limits.xacro_steps = ~0ULL;
  xacro::Meter meter(limits);
  for (int i = 0; i < 300'000; ++i) {
    const char letters = static_cast<char>(1 + dice() % 3);
    const std::string text = random_text(dice, 60, letters);
    std::string wanted = random_text(dice, dice() % 2 == 0 ? 5 : 20, letters);
    if (dice() % 2 == 0 && !text.empty()) {
      const std::size_t begin = dice() % text.size();
      wanted = text.substr(begin, dice() % 15);
    }
    const std::size_t from = dice() % 4 == 0 ? dice() % (text.size() + 3) : 0;
    INFO(text << " / " << wanted << " from " << from);
    REQUIRE(TextSearch(wanted, meter).find(text, from) == text.find(wanted, from));
    REQUIRE(TextSearch(wanted, meter, TextSearch::Direction::backwards).find(text) ==
            text.rfind(wanted));
  }
}
