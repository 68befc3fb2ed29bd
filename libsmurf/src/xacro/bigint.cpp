// SPDX-License-Identifier: BSD-3-Clause
#include "xacro/bigint.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "xacro/meter.hpp"

namespace smurf::xacro {
namespace {

constexpr unsigned kLimbBits = 32;

unsigned digit_value(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'z') return static_cast<unsigned>(c - 'a') + 10;
  return static_cast<unsigned>(c - 'A') + 10;
}

constexpr std::uint64_t kLimbsOfStep = 16;  // products of limbs, and divisions by one

/// The largest power of a base that a limb holds, and its exponent.
struct Chunk {
  std::uint32_t value = 1;
  std::size_t digits = 0;
};
Chunk chunk_of(unsigned base) {
  Chunk chunk;
  while (std::uint64_t{chunk.value} * base <= std::numeric_limits<std::uint32_t>::max()) {
    chunk.value *= base;
    ++chunk.digits;
  }
  return chunk;
}

}  // namespace

BigInt::BigInt(std::int64_t value) : negative_(value < 0) {
  auto magnitude = static_cast<std::uint64_t>(value);
  if (negative_) magnitude = ~magnitude + 1;
  for (; magnitude != 0; magnitude >>= kLimbBits) {
    limbs_.push_back(static_cast<std::uint32_t>(magnitude));
  }
}

BigInt BigInt::from_digits(std::string_view digits, unsigned base, Meter& meter) {
  const Chunk chunk = chunk_of(base);
  BigInt result;
  while (!digits.empty()) {
    const std::string_view part = digits.substr(0, chunk.digits);
    digits.remove_prefix(part.size());
    std::uint64_t carry = 0;
    std::uint64_t factor = 1;
    for (const char c : part) {
      carry = carry * base + digit_value(c);
      factor *= base;
    }
    meter.step(1 + result.limbs_.size() / kLimbsOfStep);
    for (std::uint32_t& limb : result.limbs_) {
      carry += limb * factor;
      limb = static_cast<std::uint32_t>(carry);
      carry >>= kLimbBits;
    }
    if (carry != 0) result.limbs_.push_back(static_cast<std::uint32_t>(carry));
  }
  return result;
}

BigInt BigInt::from_double(double value) {
  int exponent = 0;
  const double fraction = std::frexp(std::trunc(std::fabs(value)), &exponent);
  constexpr int kDigits = std::numeric_limits<double>::digits;
  BigInt result(static_cast<std::int64_t>(std::ldexp(fraction, kDigits)));
  exponent -= kDigits;
  result = exponent >= 0 ? result.shifted_left(static_cast<std::size_t>(exponent))
                         : result.shifted_right(static_cast<std::size_t>(-exponent));
  result.negative_ = value < 0 && !result.is_zero();
  return result;
}

std::size_t BigInt::bits() const {
  if (limbs_.empty()) return 0;
  return limbs_.size() * kLimbBits - static_cast<std::size_t>(std::countl_zero(limbs_.back()));
}

std::optional<std::int64_t> BigInt::to_int64() const {
  if (bits() > 64) return std::nullopt;
  std::uint64_t magnitude = 0;
  for (std::size_t i = 0; i < limbs_.size(); ++i) {
    magnitude |= static_cast<std::uint64_t>(limbs_[i]) << (kLimbBits * i);
  }
  constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max();
  if (magnitude > kMost + (negative_ ? 1U : 0U)) return std::nullopt;
  return static_cast<std::int64_t>(negative_ ? ~magnitude + 1 : magnitude);
}

std::optional<double> BigInt::to_double() const {
  constexpr std::size_t kDigits = std::numeric_limits<double>::digits;
  const std::size_t width = bits();
  if (width > 1024) return std::nullopt;
  const std::size_t dropped = width > kDigits + 2 ? width - kDigits - 2 : 0;
  BigInt top = *this;
  top.negative_ = false;
  const BigInt all = top;
  top = top.shifted_right(dropped);
  std::uint64_t mantissa = 0;
  for (std::size_t i = 0; i < top.limbs_.size(); ++i) {
    mantissa |= static_cast<std::uint64_t>(top.limbs_[i]) << (kLimbBits * i);
  }
  // One more bit says whether anything was dropped; the conversion then rounds once.
  mantissa <<= 1U;
  if (!(top.shifted_left(dropped) == all)) mantissa |= 1U;
  const double result = std::ldexp(static_cast<double>(mantissa), static_cast<int>(dropped) - 1);
  if (std::isinf(result)) return std::nullopt;
  return negative_ ? -result : result;
}

std::string BigInt::to_text(Meter& meter, unsigned base) const {
  if (is_zero()) return "0";
  const Chunk chunk = chunk_of(base);
  std::string text;
  Limbs rest = limbs_;
  while (!rest.empty()) {
    meter.step(1 + rest.size() / kLimbsOfStep);
    std::uint32_t digits = divide_small(rest, chunk.value);
    for (std::size_t i = 0; i < chunk.digits && (digits != 0 || !rest.empty()); ++i) {
      text.push_back("0123456789abcdef"[digits % base]);
      digits /= base;
    }
  }
  if (negative_) text.push_back('-');
  std::reverse(text.begin(), text.end());
  return text;
}

BigInt BigInt::negated() const {
  BigInt result = *this;
  result.negative_ = !negative_ && !is_zero();
  return result;
}

void BigInt::trim(Limbs& limbs) {
  while (!limbs.empty() && limbs.back() == 0) limbs.pop_back();
}

int BigInt::compare_limbs(const Limbs& a, const Limbs& b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (std::size_t i = a.size(); i-- > 0;) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

int BigInt::compare(const BigInt& a, const BigInt& b) {
  if (a.negative_ != b.negative_) return a.negative_ ? -1 : 1;
  const int magnitude = compare_limbs(a.limbs_, b.limbs_);
  return a.negative_ ? -magnitude : magnitude;
}

BigInt::Limbs BigInt::add_limbs(const Limbs& a, const Limbs& b) {
  Limbs sum;
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    carry += (i < a.size() ? a[i] : 0ULL) + (i < b.size() ? b[i] : 0ULL);
    sum.push_back(static_cast<std::uint32_t>(carry));
    carry >>= kLimbBits;
  }
  if (carry != 0) sum.push_back(static_cast<std::uint32_t>(carry));
  return sum;
}

BigInt::Limbs BigInt::subtract_limbs(const Limbs& a, const Limbs& b) {
  Limbs rest;
  std::int64_t carry = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    carry += static_cast<std::int64_t>(a[i]) - (i < b.size() ? b[i] : 0);
    rest.push_back(static_cast<std::uint32_t>(carry));
    carry >>= kLimbBits;
  }
  trim(rest);
  return rest;
}

BigInt BigInt::sum(const BigInt& a, const BigInt& b, bool negate_b) {
  const bool b_negative = b.negative_ != negate_b;
  BigInt result;
  if (a.negative_ == b_negative) {
    result.limbs_ = add_limbs(a.limbs_, b.limbs_);
    result.negative_ = a.negative_;
  } else if (compare_limbs(a.limbs_, b.limbs_) >= 0) {
    result.limbs_ = subtract_limbs(a.limbs_, b.limbs_);
    result.negative_ = a.negative_;
  } else {
    result.limbs_ = subtract_limbs(b.limbs_, a.limbs_);
    result.negative_ = b_negative;
  }
  if (result.is_zero()) result.negative_ = false;
  return result;
}

BigInt operator+(const BigInt& a, const BigInt& b) { return BigInt::sum(a, b, false); }
BigInt operator-(const BigInt& a, const BigInt& b) { return BigInt::sum(a, b, true); }

BigInt BigInt::product(const BigInt& a, const BigInt& b, Meter& meter) {
  meter.step(1 + a.limbs_.size() * b.limbs_.size() / kLimbsOfStep);
  BigInt result;
  result.limbs_.assign(a.limbs_.size() + b.limbs_.size(), 0);
  for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
      carry += static_cast<std::uint64_t>(a.limbs_[i]) * b.limbs_[j] + result.limbs_[i + j];
      result.limbs_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= kLimbBits;
    }
    result.limbs_[i + b.limbs_.size()] = static_cast<std::uint32_t>(carry);
  }
  trim(result.limbs_);
  result.negative_ = a.negative_ != b.negative_ && !result.is_zero();
  return result;
}

std::uint32_t BigInt::divide_small(Limbs& limbs, std::uint32_t by) {
  std::uint64_t rest = 0;
  for (std::size_t i = limbs.size(); i-- > 0;) {
    rest = rest << kLimbBits | limbs[i];
    limbs[i] = static_cast<std::uint32_t>(rest / by);
    rest %= by;
  }
  trim(limbs);
  return static_cast<std::uint32_t>(rest);
}

/// Algorithm D of Knuth, The Art of Computer Programming, volume 2, 4.3.1.
BigInt::Limbs BigInt::divide_limbs(Limbs& rest, const Limbs& by) {
  if (compare_limbs(rest, by) < 0) return {};
  if (by.size() == 1) {
    Limbs quotient = std::move(rest);
    const std::uint32_t remainder = divide_small(quotient, by[0]);
    rest.assign(remainder == 0 ? 0 : 1, remainder);
    return quotient;
  }
  // The highest bit of the divisor is set, so that two limbs give a good estimate.
  const auto shift = static_cast<unsigned>(std::countl_zero(by.back()));
  const auto shifted = [shift](const Limbs& limbs) {
    Limbs result(limbs.size() + 1);
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < limbs.size(); ++i) {
      carry |= static_cast<std::uint64_t>(limbs[i]) << shift;
      result[i] = static_cast<std::uint32_t>(carry);
      carry >>= kLimbBits;
    }
    result.back() = static_cast<std::uint32_t>(carry);
    return result;
  };
  const Limbs divisor = shifted(by);  // its last limb is 0
  rest = shifted(rest);
  const std::size_t n = by.size();
  const std::uint64_t first = divisor[n - 1];
  const std::uint64_t second = divisor[n - 2];
  constexpr std::uint64_t kBase = std::uint64_t{1} << kLimbBits;
  Limbs quotient(rest.size() - n);
  for (std::size_t at = quotient.size(); at-- > 0;) {
    const std::uint64_t top = std::uint64_t{rest[at + n]} << kLimbBits | rest[at + n - 1];
    std::uint64_t digit = top / first;
    std::uint64_t left = top % first;
    while (digit >= kBase || digit * second > (left << kLimbBits | rest[at + n - 2])) {
      --digit;
      left += first;
      if (left >= kBase) break;
    }
    std::uint64_t carry = 0;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i <= n; ++i) {
      carry += digit * divisor[i];
      borrow += std::int64_t{rest[at + i]} - static_cast<std::uint32_t>(carry);
      rest[at + i] = static_cast<std::uint32_t>(borrow);
      borrow >>= kLimbBits;
      carry >>= kLimbBits;
    }
    if (borrow < 0) {  // the estimate was one too large
      --digit;
      carry = 0;
      for (std::size_t i = 0; i <= n; ++i) {
        carry += std::uint64_t{rest[at + i]} + divisor[i];
        rest[at + i] = static_cast<std::uint32_t>(carry);
        carry >>= kLimbBits;
      }
    }
    quotient[at] = static_cast<std::uint32_t>(digit);
  }
  rest.resize(n);
  for (std::size_t i = 0; i < n && shift > 0; ++i) {
    const std::uint32_t high = i + 1 < n ? rest[i + 1] << (kLimbBits - shift) : 0;
    rest[i] = rest[i] >> shift | high;
  }
  trim(rest);
  trim(quotient);
  return quotient;
}

BigInt::Division BigInt::divide(const BigInt& a, const BigInt& b, Meter& meter) {
  const std::size_t rows =
      a.limbs_.size() >= b.limbs_.size() ? a.limbs_.size() - b.limbs_.size() + 1 : 1;
  meter.step(2 + rows * (b.limbs_.size() + 1) / kLimbsOfStep);
  Division result;
  Limbs& rest = result.remainder.limbs_;
  rest = a.limbs_;
  result.quotient.limbs_ = divide_limbs(rest, b.limbs_);
  const bool is_exact = result.remainder.is_zero();
  if (a.negative_ != b.negative_) {
    if (!is_exact) {
      result.quotient = result.quotient + BigInt(1);
      rest = subtract_limbs(b.limbs_, rest);
    }
    result.quotient.negative_ = !result.quotient.is_zero();
  }
  result.remainder.negative_ = b.negative_ && !result.remainder.is_zero();
  return result;
}

BigInt BigInt::shifted_left(std::size_t bits) const {
  if (is_zero()) return *this;
  BigInt result;
  result.negative_ = negative_;
  result.limbs_.assign(bits / kLimbBits, 0);
  const std::size_t shift = bits % kLimbBits;
  std::uint64_t carry = 0;
  for (const std::uint32_t limb : limbs_) {
    carry |= static_cast<std::uint64_t>(limb) << shift;
    result.limbs_.push_back(static_cast<std::uint32_t>(carry));
    carry >>= kLimbBits;
  }
  if (carry != 0) result.limbs_.push_back(static_cast<std::uint32_t>(carry));
  return result;
}

BigInt BigInt::shifted_right(std::size_t bits) const {
  BigInt result;
  result.negative_ = negative_;
  const std::size_t skipped = bits / kLimbBits;
  const std::size_t shift = bits % kLimbBits;
  for (std::size_t i = skipped; i < limbs_.size(); ++i) {
    const std::uint64_t high = i + 1 < limbs_.size() ? limbs_[i + 1] : 0;
    const std::uint64_t pair = high << kLimbBits | limbs_[i];
    result.limbs_.push_back(static_cast<std::uint32_t>(pair >> shift));
  }
  trim(result.limbs_);
  if (!negative_) return result;
  if (result.is_zero()) result.negative_ = false;
  const bool is_exact = result.shifted_left(bits) == *this;
  return is_exact ? result : result - BigInt(1);
}

BigInt::Limbs BigInt::complement(std::size_t count) const {
  Limbs limbs = limbs_;
  limbs.resize(count, 0);
  if (!negative_) return limbs;
  std::uint64_t carry = 1;
  for (std::uint32_t& limb : limbs) {
    carry += static_cast<std::uint32_t>(~limb);
    limb = static_cast<std::uint32_t>(carry);
    carry >>= kLimbBits;
  }
  return limbs;
}

BigInt BigInt::bitwise(char operation, const BigInt& a, const BigInt& b) {
  const std::size_t count = std::max(a.limbs_.size(), b.limbs_.size()) + 1;
  const Limbs left = a.complement(count);
  const Limbs right = b.complement(count);
  BigInt result;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t limb = operation == '&'   ? left[i] & right[i]
                               : operation == '|' ? left[i] | right[i]
                                                  : left[i] ^ right[i];
    result.limbs_.push_back(limb);
  }
  const bool negative = result.limbs_.back() >> (kLimbBits - 1) != 0;
  if (negative) {
    result.negative_ = true;
    result.limbs_ = result.complement(count);
  }
  trim(result.limbs_);
  return result;
}

std::optional<double> true_quotient(const BigInt& a, const BigInt& b, Meter& meter) {
  constexpr std::size_t kExact = std::numeric_limits<double>::digits;
  if (a.bits() <= kExact && b.bits() <= kExact) return *a.to_double() / *b.to_double();
  constexpr std::size_t kWanted = 66;  // bits of the quotient: a double and enough to round it
  const std::size_t shift = b.bits() + kWanted > a.bits() ? b.bits() + kWanted - a.bits() : 0;
  const BigInt up = a.is_negative() ? a.negated() : a;
  const BigInt down = b.is_negative() ? b.negated() : b;
  BigInt::Division division = BigInt::divide(up.shifted_left(shift), down, meter);
  BigInt quotient = division.quotient.shifted_left(1);
  if (!division.remainder.is_zero()) quotient = quotient + BigInt(1);
  const auto value = quotient.to_double();
  if (!value) return std::nullopt;
  const double result = std::ldexp(*value, -static_cast<int>(shift) - 1);
  return a.is_negative() != b.is_negative() ? -result : result;
}

}  // namespace smurf::xacro
