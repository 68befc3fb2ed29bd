// SPDX-License-Identifier: BSD-3-Clause
// Methods of integers and floats.
#include <algorithm>
#include <array>
#include <cmath>

#include "xacro/evaluator.hpp"

namespace smurf::xacro {
namespace {

Value is_integer(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  return Value::of(std::isfinite(call.self.real) && call.self.real == std::trunc(call.self.real));
}

Value bit_length(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  return Value::of(static_cast<std::int64_t>(to_big(call.self).bits()));
}

/// An integer stands for a truth value.
Value conjugate(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  if (call.self.kind == Kind::real) return call.self;
  return call.evaluator.integer(to_big(call.self));
}

Value ratio(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  Evaluator& evaluator = call.evaluator;
  BigInt above(0);
  BigInt below(1);
  if (call.self.kind == Kind::real) {
    if (!std::isfinite(call.self.real)) return evaluator.fail("the number is no ratio of integers");
    int exponent = 0;
    double fraction = std::frexp(call.self.real, &exponent);
    for (; fraction != std::trunc(fraction); --exponent) fraction *= 2;
    above = BigInt::from_double(fraction);
    above = above.shifted_left(static_cast<std::size_t>(std::max(exponent, 0)));
    below = below.shifted_left(static_cast<std::size_t>(std::max(-exponent, 0)));
  } else {
    above = to_big(call.self);
  }
  const Value first = evaluator.integer(std::move(above));
  const Value second = evaluator.integer(std::move(below));
  if (first.is_failed() || second.is_failed()) return Value::failure();
  return evaluator.list({first, second}, Kind::tuple);
}

constexpr std::array kReal = {Method{"as_integer_ratio", ratio}, Method{"conjugate", conjugate},
                              Method{"fromhex", nullptr}, Method{"hex", nullptr},
                              Method{"is_integer", is_integer}};
constexpr std::array kInteger = {Method{"as_integer_ratio", ratio}, Method{"bit_count", nullptr},
                                 Method{"bit_length", bit_length},  Method{"conjugate", conjugate},
                                 Method{"from_bytes", nullptr},     Method{"to_bytes", nullptr}};

}  // namespace

std::span<const Method> real_methods() { return kReal; }
std::span<const Method> integer_methods() { return kInteger; }

}  // namespace smurf::xacro
