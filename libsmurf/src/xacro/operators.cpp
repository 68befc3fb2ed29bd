// SPDX-License-Identifier: BSD-3-Clause
// The operators, with Python's rules: floors, typing, exact integers.
#include <algorithm>
#include <cmath>

#include "base/findings/rules.hpp"
#include "base/numbers/exact_math.hpp"
#include "xacro/evaluator.hpp"
#include "xacro/python_text.hpp"
#include "xacro/text_search.hpp"

namespace smurf::xacro {
namespace {

std::int64_t small_of(const Value& value) {
  return value.kind == Kind::boolean ? std::int64_t{value.boolean} : value.integer;
}

/// Names the place where a text that should be a number was written.
void label_text(Evaluator& evaluator, const Value& value) {
  Failure& failure = evaluator.failure();
  if (!value.is_text() || value.origin == kComputed || failure.rule == nullptr) return;
  failure.labels.emplace_back(evaluator.heap().place(value.origin).span, "this is a text");
  const std::string& text = *value.text;
  const std::size_t exponent = text.find_first_of("eE");
  if (exponent == std::string::npos || text.find('.') != std::string::npos || !read_float(text)) {
    return;
  }
  // Only YAML has such texts; elsewhere, xacro reads them as numbers.
  failure.help = "write `" + text.substr(0, exponent) + ".0" + text.substr(exponent) +
                 "`; in YAML 1.1, a number with an exponent and without a point is a text";
}

Value type_fault(Evaluator& evaluator, Operation operation, const Value& a, const Value& b) {
  const Value fault =
      evaluator.fail("`" + std::string(text_of(operation)) + "` cannot combine " +
                     std::string(kind_name(a)) + " and " + std::string(kind_name(b)));
  label_text(evaluator, a);
  label_text(evaluator, b);
  return fault;
}

struct Floored {
  double quotient = 0;
  double remainder = 0;
};

/// As divmod() of two floats in CPython.
Floored divide_floored(double a, double b) {
  double remainder = std::fmod(a, b);
  double quotient = (a - remainder) / b;
  if (remainder != 0) {
    if ((b < 0) != (remainder < 0)) {
      remainder += b;
      quotient -= 1.0;
    }
  } else {
    remainder = std::copysign(0.0, b);
  }
  if (quotient != 0) {
    double whole = std::floor(quotient);
    if (quotient - whole > 0.5) whole += 1.0;
    quotient = whole;
  } else {
    quotient = std::copysign(0.0, a / b);
  }
  return {quotient, remainder};
}

/// As CPython: polar, and by multiplication for small whole exponents.
std::complex<double> complex_power(std::complex<double> base, std::complex<double> exponent) {
  constexpr double kSmall = 100;
  const double whole = exponent.real();
  if (exponent.imag() == 0 && whole == std::floor(whole) && std::fabs(whole) <= kSmall) {
    std::complex<double> result = 1;
    for (int i = 0; i < static_cast<int>(std::fabs(whole)); ++i) result *= base;
    return whole < 0 ? 1.0 / result : result;
  }
  if (base == 0.0) return 0;
  const double length = hypotenuse(base.real(), base.imag());
  const double angle = arc_tangent(base.imag(), base.real());
  double power = std::pow(length, exponent.real());
  double phase = angle * exponent.real();
  if (exponent.imag() != 0) {
    power /= std::exp(angle * exponent.imag());
    phase += exponent.imag() * std::log(length);
  }
  const SineCosine turned = sine_cosine(phase);
  return {power * turned.cosine, power * turned.sine};
}

Value power_of_reals(Evaluator& evaluator, double base, double exponent) {
  if (base == 0 && exponent < 0) return evaluator.fail("0 has no negative power");
  if (base < 0 && std::isfinite(base) && std::isfinite(exponent) &&
      exponent != std::floor(exponent)) {
    return evaluator.heap().complex(complex_power(base, exponent));
  }
  const double result = std::pow(base, exponent);
  if (std::isinf(result) && std::isfinite(base) && std::isfinite(exponent)) {
    return evaluator.fail("the power is too large for a number");
  }
  return Value::of(result);
}

Value compute_reals(Evaluator& evaluator, Operation operation, double a, double b) {
  switch (operation) {
  case Operation::add: return Value::of(a + b);
  case Operation::subtract: return Value::of(a - b);
  case Operation::multiply: return Value::of(a * b);
  case Operation::divide:
    if (b == 0) return evaluator.fail("this divides by 0");
    return Value::of(a / b);
  case Operation::floor_divide:
  case Operation::modulo: {
    if (b == 0) return evaluator.fail("this divides by 0");
    const Floored result = divide_floored(a, b);
    return Value::of(operation == Operation::modulo ? result.remainder : result.quotient);
  }
  case Operation::power: return power_of_reals(evaluator, a, b);
  default: return evaluator.fail("`" + std::string(text_of(operation)) + "` needs integers");
  }
}

Value power_of_integers(Evaluator& evaluator, const BigInt& base, const Value& exponent) {
  if (to_big(exponent).is_negative()) {
    const auto left = base.to_double();
    const auto right = to_real(exponent);
    if (!left || !right) return evaluator.fail("the integer is too large for a number");
    return power_of_reals(evaluator, *left, *right);
  }
  // Powers of 0, 1 and -1 stay small, whatever the exponent.
  const std::int64_t power =
      to_big(exponent).to_int64().value_or(to_big(exponent).bits() > 0 ? 1LL << 62U : 0);
  const std::uint64_t most = evaluator.limits().xacro_integer_bits;
  if (base.bits() > 1 && static_cast<std::uint64_t>(power) > most) {
    return evaluator.integer(BigInt(1).shifted_left(static_cast<std::size_t>(most)));  // reports
  }
  BigInt result(1);
  BigInt square = base;
  for (std::int64_t left = power; left > 0; left >>= 1) {
    Meter& meter = evaluator.meter();
    if ((left & 1) != 0) result = BigInt::product(result, square, meter);
    if (result.bits() > most || square.bits() > 2 * most) {
      return evaluator.integer(BigInt::product(square, result, meter));
    }
    if (left > 1) square = BigInt::product(square, square, meter);
  }
  return evaluator.integer(std::move(result));
}

Value shift(Evaluator& evaluator, Operation operation, const Value& a, const Value& b) {
  const BigInt count = to_big(b);
  if (count.is_negative()) return evaluator.fail("a shift by a negative number");
  const BigInt value = to_big(a);
  const auto bits = count.to_int64();
  const std::uint64_t most = evaluator.limits().xacro_integer_bits;
  if (operation == Operation::shift_right) {
    const bool is_far = !bits || static_cast<std::uint64_t>(*bits) > most + 64;
    if (is_far) return Value::of(std::int64_t{value.is_negative() ? -1 : 0});
    return evaluator.integer(value.shifted_right(static_cast<std::size_t>(*bits)));
  }
  if (value.is_zero()) return Value::of(std::int64_t{0});
  const std::uint64_t by =
      !bits ? most + 1 : std::min<std::uint64_t>(static_cast<std::uint64_t>(*bits), most + 1);
  return evaluator.integer(value.shifted_left(static_cast<std::size_t>(by)));
}

Value divide_integers(Evaluator& evaluator, Operation operation, const Value& a, const Value& b) {
  const BigInt divisor = to_big(b);
  if (divisor.is_zero()) return evaluator.fail("this divides by 0");
  if (operation == Operation::divide) {
    const auto quotient = true_quotient(to_big(a), divisor, evaluator.meter());
    if (!quotient) return evaluator.fail("the quotient is too large for a number");
    return Value::of(*quotient);
  }
  const BigInt::Division division = BigInt::divide(to_big(a), divisor, evaluator.meter());
  return evaluator.integer(operation == Operation::modulo ? division.remainder : division.quotient);
}

/// Sums, differences and products that fit; others are computed by BigInt.
bool compute_small(Operation operation, std::int64_t a, std::int64_t b, std::int64_t& result) {
  switch (operation) {
  case Operation::add: return !__builtin_add_overflow(a, b, &result);
  case Operation::subtract: return !__builtin_sub_overflow(a, b, &result);
  case Operation::multiply: return !__builtin_mul_overflow(a, b, &result);
  default: return false;
  }
}

Value compute_integers(Evaluator& evaluator, Operation operation, const Value& a, const Value& b) {
  constexpr std::int64_t kExact = std::int64_t{1} << 53U;
  if (a.kind != Kind::big && b.kind != Kind::big) {
    const std::int64_t left = small_of(a);
    const std::int64_t right = small_of(b);
    std::int64_t result = 0;
    if (compute_small(operation, left, right, result)) return Value::of(result);
    const bool is_exact = std::abs(left) <= kExact && std::abs(right) <= kExact;
    if (operation == Operation::divide && right != 0 && is_exact) {
      return Value::of(static_cast<double>(left) / static_cast<double>(right));
    }
  }
  switch (operation) {
  case Operation::add: return evaluator.integer(to_big(a) + to_big(b));
  case Operation::subtract: return evaluator.integer(to_big(a) - to_big(b));
  case Operation::multiply:
    return evaluator.integer(BigInt::product(to_big(a), to_big(b), evaluator.meter()));
  case Operation::divide:
  case Operation::floor_divide:
  case Operation::modulo: return divide_integers(evaluator, operation, a, b);
  case Operation::power: return power_of_integers(evaluator, to_big(a), b);
  case Operation::shift_left:
  case Operation::shift_right: return shift(evaluator, operation, a, b);
  case Operation::bit_and:
  case Operation::bit_or:
  case Operation::bit_xor: {
    const char mark = text_of(operation)[0];
    const Value result = evaluator.integer(BigInt::bitwise(mark, to_big(a), to_big(b)));
    if (a.kind != Kind::boolean || b.kind != Kind::boolean || result.is_failed()) return result;
    return Value::of(result.integer != 0);
  }
  default: return type_fault(evaluator, operation, a, b);
  }
}

Value compute_complex(Evaluator& evaluator, Operation operation, const Value& a, const Value& b) {
  const auto whole = [](const Value& value) {
    if (value.kind == Kind::complex) return *value.complex;
    return std::complex<double>(to_real(value).value_or(0));
  };
  const std::complex<double> left = whole(a);
  const std::complex<double> right = whole(b);
  Heap& heap = evaluator.heap();
  switch (operation) {
  case Operation::add: return heap.complex(left + right);
  case Operation::subtract: return heap.complex(left - right);
  case Operation::multiply: return heap.complex(left * right);
  case Operation::divide:
    if (right == 0.0) return evaluator.fail("this divides by 0");
    return heap.complex(left / right);
  case Operation::power: return heap.complex(complex_power(left, right));
  default: return type_fault(evaluator, operation, a, b);
  }
}

Value repeat(Evaluator& evaluator, const Value& value, const Value& times) {
  const auto count = to_big(times).to_int64();
  const bool is_negative = to_big(times).is_negative();
  const std::uint64_t repeats = is_negative ? 0
                                : count     ? static_cast<std::uint64_t>(*count)
                                            : ~0ULL;
  const bool is_list = value.is_sequence();
  const std::uint64_t size = is_list ? value.list->items.size() : value.text->size();
  const std::uint64_t most =
      is_list ? evaluator.limits().xacro_items : evaluator.limits().xacro_text_bytes;
  // A result above the limit is not made; the report needs one more item only.
  const std::uint64_t wanted = size == 0 ? 0 : repeats > most / size ? most + 1 : size * repeats;
  if (is_list) {
    std::vector<Value> items;
    evaluator.step(wanted / 16);
    items.reserve(wanted);
    for (std::uint64_t i = 0; i < wanted; ++i) items.push_back(value.list->items[i % size]);
    return evaluator.list(std::move(items), value.kind);
  }
  std::string text;
  text.reserve(wanted + size);
  evaluator.step(wanted / 64);
  while (text.size() < wanted) text.append(*value.text);
  const Value result = evaluator.text(std::move(text));
  if (value.kind != Kind::bytes || result.is_failed()) return result;
  return evaluator.heap().bytes(*result.text);
}

Value set_operation(Evaluator& evaluator, Operation operation, const Value& a, const Value& b) {
  const KeySet in_a(a.list->items, evaluator.meter());
  const KeySet in_b(b.list->items, evaluator.meter());
  const bool keeps_common = operation == Operation::bit_and;
  const bool keeps_all = operation == Operation::bit_or;
  std::vector<Value> items;
  for (const Value& item : a.list->items) {
    if (keeps_all || in_b.has(item) == keeps_common) items.push_back(item);
  }
  if (keeps_all || operation == Operation::bit_xor) {
    for (const Value& item : b.list->items) {
      if (!in_a.has(item)) items.push_back(item);
    }
  }
  return evaluator.list(std::move(items), Kind::set);
}

}  // namespace

Value compute(Evaluator& evaluator, Operation operation, const Value& a, const Value& b) {
  if (a.is_number() && b.is_number()) {
    if (a.is_integral() && b.is_integral()) return compute_integers(evaluator, operation, a, b);
    const auto left = to_real(a);
    const auto right = to_real(b);
    if (!left || !right) return evaluator.fail("the integer is too large for a number");
    return compute_reals(evaluator, operation, *left, *right);
  }
  const bool has_complex = a.kind == Kind::complex || b.kind == Kind::complex;
  if (has_complex && (a.kind == Kind::complex || a.is_number()) &&
      (b.kind == Kind::complex || b.is_number())) {
    return compute_complex(evaluator, operation, a, b);
  }
  const auto repeats = [](const Value& value) {
    return value.is_sequence() || value.is_text() || value.kind == Kind::bytes;
  };
  if (operation == Operation::multiply) {
    if (repeats(a) && b.is_integral()) return repeat(evaluator, a, b);
    if (repeats(b) && a.is_integral()) return repeat(evaluator, b, a);
  }
  if (operation == Operation::add && a.kind == b.kind) {
    if (a.is_text()) return evaluator.text(*a.text + *b.text);
    if (a.is_sequence()) {
      std::vector<Value> items;
      evaluator.step((a.list->items.size() + b.list->items.size()) / 16);
      items.reserve(a.list->items.size() + b.list->items.size());
      items.insert(items.end(), a.list->items.begin(), a.list->items.end());
      items.insert(items.end(), b.list->items.begin(), b.list->items.end());
      return evaluator.list(std::move(items), a.kind);
    }
  }
  if (operation == Operation::modulo && a.is_text()) return percent_format(evaluator, *a.text, b);
  if (a.kind == Kind::set && b.kind == Kind::set) {
    const bool is_known = operation == Operation::bit_and || operation == Operation::bit_or ||
                          operation == Operation::bit_xor || operation == Operation::subtract;
    if (is_known) return set_operation(evaluator, operation, a, b);
  }
  if (operation == Operation::bit_or && a.kind == Kind::dict && b.kind == Kind::dict) {
    evaluator.step(a.dict->items.size());
    Dict both = *a.dict;
    for (const auto& [key, value] : b.dict->items) insert(both, key, value, evaluator.meter());
    return evaluator.heap().dict(std::move(both));
  }
  const Value fault = type_fault(evaluator, operation, a, b);
  const bool has_text = operation == Operation::add && (a.is_text() || b.is_text());
  if (has_text && evaluator.failure().help.empty()) {
    evaluator.failure().help =
        "convert the number with `str()`, or write two expressions side by side";
  }
  return fault;
}

Value compute(Evaluator& evaluator, Operation operation, const Value& a) {
  if (a.is_integral()) {
    if (operation == Operation::plus) return evaluator.integer(to_big(a));
    const BigInt negated = to_big(a).negated();
    return evaluator.integer(operation == Operation::negate ? negated : negated - BigInt(1));
  }
  if (operation != Operation::invert) {
    const bool is_negated = operation == Operation::negate;
    if (a.kind == Kind::real) return Value::of(is_negated ? -a.real : a.real);
    if (a.kind == Kind::complex) return is_negated ? evaluator.heap().complex(-*a.complex) : a;
  }
  const Value fault = evaluator.fail("`" + std::string(text_of(operation)) +
                                     "` needs a number, not " + std::string(kind_name(a)));
  label_text(evaluator, a);
  return fault;
}

namespace {

/// `a in b`.
Value contains(Evaluator& evaluator, const Value& a, const Value& b) {
  if (b.is_text()) {
    if (!a.is_text())
      return evaluator.fail("`in` a text needs a text, not " + std::string(kind_name(a)));
    return Value::of(TextSearch(*a.text, evaluator.meter()).find(*b.text) != std::string::npos);
  }
  if (b.kind == Kind::dict) {
    const auto key = hash_key(a, evaluator.meter());
    if (!key) return evaluator.fail(std::string(kind_name(a)) + " cannot be a key");
    return Value::of(b.dict->find(*key) != nullptr);
  }
  if (b.kind == Kind::range && a.is_integral()) {
    const auto value = to_big(a).to_int64();
    if (!value) return Value::of(false);
    const Range& range = *b.range;
    const bool is_inside = range.step > 0 ? *value >= range.begin && *value < range.end
                                          : *value <= range.begin && *value > range.end;
    return Value::of(is_inside && (*value - range.begin) % range.step == 0);
  }
  if (b.kind == Kind::name_space) {
    if (!a.is_text()) return evaluator.fail("a namespace has names only");
    return Value::of(static_cast<bool>(b.table->find(*a.text)));
  }
  std::vector<Value> items;
  if (!evaluator.items_of(b, items)) return Value::failure();
  return Value::of(std::any_of(items.begin(), items.end(), [&](const Value& item) {
    return are_equal(item, a, evaluator.meter());
  }));
}

bool are_identical(const Value& a, const Value& b) {
  if (a.kind != b.kind) return false;
  switch (a.kind) {
  case Kind::none: return true;
  case Kind::boolean: return a.boolean == b.boolean;
  case Kind::integer: return a.integer == b.integer;
  case Kind::real: return a.real == b.real;
  case Kind::text: return *a.text == *b.text;
  case Kind::type: return a.type == b.type;
  default: return a.text == b.text;
  }
}

/// Whether it depends on the run of Python if two equal values are one object.
bool may_be_identical(const Value& a, const Value& b) {
  if (a.kind != b.kind) return false;
  constexpr std::int64_t kFirst = -5;  // Python has these integers once
  constexpr std::int64_t kLast = 256;
  switch (a.kind) {
  case Kind::integer: return a.integer == b.integer && (a.integer < kFirst || a.integer > kLast);
  case Kind::real: return a.real == b.real;
  case Kind::text: return a.text != b.text && *a.text == *b.text;
  default: return false;
  }
}

Value compare_sets(Operation operation, const Value& a, const Value& b, Meter& meter) {
  /// Whether every item of one is in the other.
  const auto is_subset = [&](const Value& one, const Value& other) {
    return KeySet(other.list->items, meter).has_all(one.list->items);
  };
  const bool is_larger = operation == Operation::greater || operation == Operation::greater_equal;
  const bool is_strict = operation == Operation::less || operation == Operation::greater;
  const bool holds = is_larger ? is_subset(b, a) : is_subset(a, b);
  return Value::of(holds && !(is_strict && a.list->items.size() == b.list->items.size()));
}

}  // namespace

Value compare_values(Evaluator& evaluator, Operation operation, const Value& a, const Value& b) {
  Meter& meter = evaluator.meter();
  switch (operation) {
  case Operation::equal: return Value::of(are_equal(a, b, meter));
  case Operation::not_equal: return Value::of(!are_equal(a, b, meter));
  case Operation::is:
  case Operation::is_not:
    if (a.is_text() && b.is_text()) meter.copy(a.text->size());
    if (may_be_identical(a, b)) {
      return evaluator.fail_unsupported("`is` between equal texts or numbers (write `==`), which");
    }
    return Value::of(are_identical(a, b) == (operation == Operation::is));
  case Operation::in: return contains(evaluator, a, b);
  case Operation::not_in: {
    const Value found = contains(evaluator, a, b);
    return found.is_failed() ? found : Value::of(!found.boolean);
  }
  default: break;
  }
  if (a.kind == Kind::set && b.kind == Kind::set) return compare_sets(operation, a, b, meter);
  const auto order = compare(a, b, meter);
  if (!order) return type_fault(evaluator, operation, a, b);
  if (*order == 2) return Value::of(false);
  switch (operation) {
  case Operation::less: return Value::of(*order < 0);
  case Operation::less_equal: return Value::of(*order <= 0);
  case Operation::greater: return Value::of(*order > 0);
  default: return Value::of(*order >= 0);
  }
}

}  // namespace smurf::xacro
