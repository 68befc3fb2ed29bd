// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/numbers.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "unit/random.hpp"

using namespace smurf;

TEST_CASE("numbers: the grammar") {
  struct Row {
    std::string text;
    std::optional<double> value;
  };
  const Row rows[] = {{"0", 0.0},
                      {"-0", -0.0},
                      {"1", 1.0},
                      {"+1", 1.0},
                      {"1.", 1.0},
                      {".5", 0.5},
                      {"-.5", -0.5},
                      {"+.5", 0.5},
                      {"1.5e3", 1500.0},
                      {"1E-2", 0.01},
                      {"1e+2", 100.0},
                      {"007", 7.0},
                      {"1e22", 1e22},
                      {"5e-324", 5e-324},
                      {"1.7976931348623157e308", 1.7976931348623157e308},
                      {"", {}},
                      {" 1", {}},
                      {"1 ", {}},
                      {".", {}},
                      {"+", {}},
                      {"-", {}},
                      {"e5", {}},
                      {"1e", {}},
                      {"1e+", {}},
                      {"1e1.5", {}},
                      {"1,5", {}},
                      {"1_000", {}},
                      {"0x10", {}},
                      {"1f", {}},
                      {"inf", {}},
                      {"-inf", {}},
                      {"nan", {}},
                      {"NaN", {}},
                      {"--1", {}},
                      {"+-1", {}},
                      {"-+1", {}},
                      {"++1", {}},
                      {"1e400", {}},
                      {"1.2.3", {}},
                      {"1 2", {}},
                      {"\xE2\x88\x92"
                       "1",
                       {}},
                      {"1\n", {}},
                      {"infinity", {}}};
  for (const Row& row : rows) {
    CAPTURE(row.text);
    const std::optional<double> value = parse_number(row.text);
    CHECK(value.has_value() == row.value.has_value());
    if (value && row.value) {
      CHECK(std::bit_cast<std::uint64_t>(*value) == std::bit_cast<std::uint64_t>(*row.value));
    }
  }
}

TEST_CASE("numbers: integers") {
  struct Row {
    std::string text;
    std::optional<std::int64_t> value;
  };
  const Row rows[] = {{"0", 0},
                      {"-0", 0},
                      {"+12", 12},
                      {"-12", -12},
                      {"012", 12},
                      {"9223372036854775807", 9223372036854775807},
                      {"-9223372036854775808", std::numeric_limits<std::int64_t>::min()},
                      {"9223372036854775808", {}},
                      {"", {}},
                      {"+", {}},
                      {"-", {}},
                      {"+-1", {}},
                      {"--1", {}},
                      {"++1", {}},
                      {"1.0", {}},
                      {"1e3", {}},
                      {"0x1", {}},
                      {" 1", {}},
                      {"1 ", {}}};
  for (const Row& row : rows) {
    CAPTURE(row.text);
    CHECK(parse_integer(row.text) == row.value);
  }
}

TEST_CASE("numbers: the shortest text") {
  struct Row {
    double value;
    std::string text;
  };
  const Row rows[] = {{0, "0"},
                      {-0.0, "0"},
                      {1, "1"},
                      {-2.5, "-2.5"},
                      {0.1, "0.1"},
                      {0.1 + 0.2, "0.30000000000000004"},
                      {100000, "100000"},
                      {1e14, "100000000000000"},
                      {1e15, "1e+15"},
                      {1e-5, "0.00001"},
                      {9.9e-6, "9.9e-06"},
                      {1.5707963267948966, "1.5707963267948966"},
                      {5e-324, "5e-324"},
                      {1.7976931348623157e308, "1.7976931348623157e+308"},
                      {123456789012345.0, "123456789012345"},
                      {0.000012345678901234567, "0.000012345678901234568"}};
  for (const Row& row : rows) {
    CAPTURE(row.value);
    CHECK(format_number(row.value) == row.text);
  }
}

TEST_CASE("numbers: a million doubles survive being written and read") {
  MESSAGE("seed " << test::seed());
  test::Random random;
  int wrong = 0;
  double culprit = 0;
  for (int i = 0; i < 1000000; ++i) {
    // Half of the numbers have random bits, half of them have sizes that occur in robots.
    double value = i % 2 == 0 ? std::bit_cast<double>(random.bits()) : random.between(-1e3, 1e3);
    if (!std::isfinite(value) || value == 0) value = 1.0 / (i + 3);
    const std::optional<double> back = parse_number(format_number(value));
    if (back && std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(value))
      continue;
    ++wrong;
    culprit = value;
  }
  CAPTURE(culprit);
  CHECK(wrong == 0);
}

TEST_CASE("numbers: rounded for messages") {
  CHECK(format_rounded(0.1 + 0.2) == "0.3");
  CHECK(format_rounded(1.0) == "1");
  CHECK(format_rounded(1234567.0) == "1234570");
  CHECK(format_rounded(-2134.0, 2) == "-2100");
  CHECK(format_rounded(12345678.0) == "1.23457e+07");
  CHECK(format_rounded(0.333333333, 2) == "0.33");
  CHECK(format_rounded(-2.50) == "-2.5");
}
