// SPDX-License-Identifier: BSD-3-Clause
// Division and texts of large integers, by what must hold for them.
#include <doctest/doctest.h>

#include <random>
#include <string>

#include "smurf/limits.hpp"
#include "xacro/bigint.hpp"
#include "xacro/meter.hpp"

using namespace smurf;
using xacro::BigInt;

namespace {

/// With many limbs that are 0, 1, all ones or the highest bit: where estimates of quotients are
/// wrong.
BigInt random_integer(std::mt19937& dice, std::size_t most_limbs) {
  constexpr std::uint32_t kSpecial[] = {0, 1, 0xffffffff, 0xfffffffe, 0x80000000, 0x7fffffff};
  BigInt value;
  for (std::size_t i = dice() % (most_limbs + 1); i > 0; --i) {
    const std::uint32_t limb = dice() % 3 == 0 ? static_cast<std::uint32_t>(dice())
                                               : kSpecial[dice() % std::size(kSpecial)];
    value = value.shifted_left(32) + BigInt(static_cast<std::int64_t>(limb));
  }
  return dice() % 4 == 0 ? value.negated() : value;
}

}  // namespace

TEST_CASE("quotient and remainder make the dividend") {
  std::mt19937 dice(2);
  Limits limits;
  limits.xacro_steps = ~0ULL;
  xacro::Meter meter(limits);
  for (int i = 0; i < 200'000; ++i) {
    const BigInt a = random_integer(dice, 9);
    const BigInt b = random_integer(dice, 5);
    if (b.is_zero()) continue;
    INFO(a.to_text(meter) << " / " << b.to_text(meter));
    const BigInt::Division division = BigInt::divide(a, b, meter);
    REQUIRE(BigInt::product(division.quotient, b, meter) + division.remainder == a);
    // Rounded down: the remainder has the sign of the divisor, and is smaller.
    REQUIRE((division.remainder.is_zero() || division.remainder.is_negative() == b.is_negative()));
    const BigInt left = b.is_negative() ? b - division.remainder : division.remainder - b;
    REQUIRE((b.is_negative() ? BigInt::compare(division.remainder, b) > 0
                             : BigInt::compare(division.remainder, b) < 0));
    REQUIRE(left.is_negative());
  }
}

TEST_CASE("texts in every base read back") {
  std::mt19937 dice(3);
  Limits limits;
  limits.xacro_steps = ~0ULL;
  xacro::Meter meter(limits);
  for (int i = 0; i < 20'000; ++i) {
    BigInt value = random_integer(dice, 9);
    if (value.is_negative()) value = value.negated();
    for (const unsigned base : {2U, 8U, 10U, 16U}) {
      const std::string text = value.to_text(meter, base);
      INFO(text);
      REQUIRE(BigInt::from_digits(text, base, meter) == value);
      REQUIRE((text == "0" || text.front() != '0'));
    }
  }
}
