// SPDX-License-Identifier: BSD-3-Clause
// Integers of any size, as Python has them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::xacro {

class Meter;

/// What costs more than its result is large counts its work.
class BigInt {
 public:
  BigInt() = default;
  explicit BigInt(std::int64_t value);
  /// Digits of a base up to 36, without sign. Precondition: only such digits.
  static BigInt from_digits(std::string_view digits, unsigned base, Meter& meter);
  /// Without the fraction. Precondition: finite.
  static BigInt from_double(double value);

  bool is_negative() const { return negative_; }
  bool is_zero() const { return limbs_.empty(); }
  /// Of the magnitude.
  std::size_t bits() const;
  std::size_t bytes() const { return limbs_.size() * sizeof(std::uint32_t); }
  std::optional<std::int64_t> to_int64() const;
  /// Rounded to the nearest; none if it is too large.
  std::optional<double> to_double() const;
  /// In a base up to 16, with the sign.
  std::string to_text(Meter& meter, unsigned base = 10) const;

  BigInt negated() const;
  friend BigInt operator+(const BigInt& a, const BigInt& b);
  friend BigInt operator-(const BigInt& a, const BigInt& b);
  static BigInt product(const BigInt& a, const BigInt& b, Meter& meter);
  friend bool operator==(const BigInt&, const BigInt&) = default;
  /// Negative, 0 or positive.
  static int compare(const BigInt& a, const BigInt& b);

  struct Division;
  /// Rounds down, as Python does. Precondition: the divisor is not 0.
  static Division divide(const BigInt& a, const BigInt& b, Meter& meter);
  BigInt shifted_left(std::size_t bits) const;
  /// Rounds down.
  BigInt shifted_right(std::size_t bits) const;
  /// '&', '|' or '^' of numbers in two's complement of unlimited width.
  static BigInt bitwise(char operation, const BigInt& a, const BigInt& b);

 private:
  using Limbs = std::vector<std::uint32_t>;
  static int compare_limbs(const Limbs& a, const Limbs& b);
  static Limbs add_limbs(const Limbs& a, const Limbs& b);
  /// Precondition: a >= b.
  static Limbs subtract_limbs(const Limbs& a, const Limbs& b);
  static BigInt sum(const BigInt& a, const BigInt& b, bool negate_b);
  static std::uint32_t divide_small(Limbs& limbs, std::uint32_t by);
  /// Divides magnitudes; `rest` becomes the remainder. Precondition: the divisor is not 0.
  static Limbs divide_limbs(Limbs& rest, const Limbs& by);
  static void trim(Limbs& limbs);
  Limbs complement(std::size_t count) const;

  bool negative_ = false;
  Limbs limbs_;  ///< the lowest first, without zeros at the end
};

struct BigInt::Division {
  BigInt quotient;
  BigInt remainder;
};

/// The quotient as a number, rounded to the nearest; none if it is too large. Precondition: the
/// divisor is not 0.
std::optional<double> true_quotient(const BigInt& a, const BigInt& b, Meter& meter);

}  // namespace smurf::xacro
