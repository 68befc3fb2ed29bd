// SPDX-License-Identifier: BSD-3-Clause
// Compares our number conversions, for standard libraries that lack them, with the standard
// library.
#include "base/numbers/floating.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/numbers/bits.hpp"
#include "unit/random.hpp"

using namespace smurf;

namespace {

constexpr int kRandom = 10000;

std::vector<double> doubles() {
  using Limits = std::numeric_limits<double>;
  std::vector<double> values = {0.0,
                                -0.0,
                                1.0,
                                0.1,
                                1e22,
                                1e23,
                                9007199254740993.0,
                                Limits::max(),
                                Limits::min(),
                                Limits::denorm_min(),
                                3 * Limits::denorm_min()};
  for (int exponent = -1074; exponent < 1024; ++exponent) {
    values.push_back(std::ldexp(1, exponent));
    values.push_back(std::nextafter(values.back(), 0));
  }
  test::Random random(7);
  for (int i = 0; i < kRandom; ++i) {
    const auto value = bit_cast<double>(random.bits());
    if (std::isfinite(value)) values.push_back(value);
    values.push_back(static_cast<double>(random.bits() % 2000001) / 1000 - 1000);
    values.push_back(bit_cast<double>(random.bits() % (std::uint64_t{1} << 54U)));  // tiny
  }
  return values;
}

struct Read {
  std::ptrdiff_t length;
  std::errc error;
  std::uint64_t value;
  bool operator==(const Read&) const = default;
};

using Reader = std::from_chars_result (*)(std::string_view, double&);

Read read_by(Reader reader, std::string_view text) {
  double value = 0.25;
  const auto [end, error] = reader(text, value);
  // NaN has many bit patterns; they do not matter.
  return {end - text.data(), error, std::isnan(value) ? 1 : bit_cast<std::uint64_t>(value)};
}

const std::string kNumbers[] = {"",
                                "-",
                                "+1",
                                "1e",
                                "1e+",
                                "1.e5",
                                ".5",
                                "-.5e-3x",
                                "..5",
                                "e5",
                                "1e400",
                                "-1e400",
                                "1e-400",
                                "2e-324",
                                "3e-324",
                                "0e-9999",
                                "0e9999",
                                "-0",
                                "0x10",
                                "1 ",
                                " 1",
                                "inf",
                                "-INF",
                                "infinity",
                                "infin",
                                "nan",
                                "-nan",
                                "i",
                                "1,5",
                                "1.5.2",
                                "1e5e5",
                                "1e99999999999999999999",
                                "0.000000000000000000e400",
                                "1e-99999999999999999999",
                                "123456789012345678901234567890",
                                "4.9e-324",
                                "2.4703282292062327208e-324",
                                "2.4703282292062328e-324",
                                "179769313486231580793e289"};

const std::string kHexadecimal[] = {"",
                                    "1p3",
                                    "0x1",
                                    "1.8",
                                    "1p-2000",
                                    "1p2000",
                                    "1p-1074",
                                    "1p-1075",
                                    "1.8p-1075",
                                    "ffffffffffffffffffffff",
                                    "1.00000000000008p0",
                                    "1.000000000000080001",
                                    "inf",
                                    "nan",
                                    ".8",
                                    "8.",
                                    "1p",
                                    "-a",
                                    "p3",
                                    ".",
                                    "1.8P+1",
                                    "fffffffffffff8p971"};

}  // namespace

TEST_CASE("floating: shortest doubles are those of std::to_chars") {
  for (const double value : doubles()) {
    for (const Notation notation : {Notation::shorter, Notation::fixed, Notation::scientific}) {
      REQUIRE(portable::shortest(value, notation) == shortest(value, notation));
    }
  }
}

TEST_CASE("floating: shortest floats are those of std::to_chars") {
  test::Random random(8);
  std::vector<float> values = {0.0F, -0.0F, 16777216.0F, 123456789.0F, 1e10F, 0.1F};
  for (int exponent = -149; exponent < 128; ++exponent)
    values.push_back(std::ldexp(1.0F, exponent));
  for (int i = 0; i < kRandom; ++i) {
    const auto value = bit_cast<float>(static_cast<std::uint32_t>(random.bits()));
    if (std::isfinite(value)) values.push_back(value);
  }
  for (const float value : values) REQUIRE(portable::shortest(value) == shortest(value));
}

TEST_CASE("floating: rounded texts are those of std::to_chars") {
  for (const double value : doubles()) {
    for (const int digits : {1, 3, 6, 12}) {
      REQUIRE(portable::general(value, digits) == general(value, digits));
    }
  }
}

TEST_CASE("floating: numbers are read as std::from_chars reads them") {
  for (const std::string& text : kNumbers) {
    CAPTURE(text);
    CHECK((read_by(portable::read_floating, text) == read_by(read_floating, text)));
  }
  for (const std::string& text : kHexadecimal) {
    CAPTURE(text);
    CHECK((read_by(portable::read_hexadecimal, text) == read_by(read_hexadecimal, text)));
  }
  for (const double value : doubles()) {
    for (const std::string& text : {shortest(value, Notation::fixed), general(value, 7),
                                    general(value, 18), general(value, 60)}) {
      REQUIRE((read_by(portable::read_floating, text) == read_by(read_floating, text)));
    }
  }
}
