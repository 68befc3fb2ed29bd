// SPDX-License-Identifier: BSD-3-Clause
// The public names of Python's module math.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "base/findings/rules.hpp"
#include "base/numbers/exact_math.hpp"
#include "xacro/evaluator.hpp"

namespace smurf::xacro {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Value domain_fault(Call& call) {
  return call.evaluator.fail("`" + std::string(call.name) + "()` is not defined for this value");
}

/// The numbers of a call; false after a failure.
bool numbers_of(Call& call, std::size_t count, double* numbers) {
  if (!call.has_count(count, count)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const auto real = to_real(call.values[i]);
    if (!real) {
      call.evaluator.fail("`" + std::string(call.name) + "()` needs a number, not " +
                          std::string(kind_name(call.values[i])));
      return false;
    }
    numbers[i] = *real;
  }
  return true;
}

/// As CPython: no result for a finite value is a fault, and so is an infinite one.
Value checked(Call& call, double value, double result) {
  if (std::isnan(result) && !std::isnan(value)) return domain_fault(call);
  if (std::isinf(result) && std::isfinite(value)) {
    return call.evaluator.fail("the result of `" + std::string(call.name) + "()` is too large");
  }
  return Value::of(result);
}

double sine(double x) { return sine_cosine(x).sine; }
double cosine(double x) { return sine_cosine(x).cosine; }
double tangent(double x) {
  const SineCosine both = sine_cosine(x);
  return x == 0 ? x : both.sine / both.cosine;
}
double arc_sine(double x) {
  if (std::fabs(x) > 1) return kNaN;
  return x == 0 ? x : arc_tangent(x, std::sqrt((1 - x) * (1 + x)));
}
double arc_cosine(double x) {
  return std::fabs(x) > 1 ? kNaN : arc_tangent(std::sqrt((1 - x) * (1 + x)), x);
}
double arc_tangent_of(double x) { return x == 0 ? x : arc_tangent(x, 1.0); }
double degrees(double x) { return x * (180.0 / std::numbers::pi); }
double radians(double x) { return x * (std::numbers::pi / 180.0); }
double gamma(double x) {
  if (x == 0 || (x < 0 && x == std::floor(x))) return kNaN;
  return std::tgamma(x);
}
double log_gamma(double x) {
  if (x <= 0 && x == std::floor(x) && std::isfinite(x)) return kNaN;
  return std::lgamma(x);
}
double power_of_two(double x) { return std::exp2(x); }

template <double (*Compute)(double)>
Value real_function(Call& call) {
  double x = 0;
  if (!numbers_of(call, 1, &x)) return Value::failure();
  if (std::isinf(x) && (call.name == "sin" || call.name == "cos" || call.name == "tan")) {
    return domain_fault(call);
  }
  return checked(call, x, Compute(x));
}

template <double (*Compute)(double)>
Value logarithm(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  const Value& value = call.values[0];
  double extra = 0;
  double x = 0;
  if (value.kind == Kind::big && !value.big->is_negative()) {
    const std::size_t shift = value.big->bits() - 60;
    x = *value.big->shifted_right(shift).to_double();
    extra = static_cast<double>(shift) * Compute(2.0);
  } else if (!numbers_of(call, 1, &x)) {
    return Value::failure();
  }
  if (x <= 0) return domain_fault(call);
  return Value::of(Compute(x) + extra);
}

Value log(Call& call) {
  if (call.count() != 2) return logarithm<std::log>(call);
  double x[2] = {};
  if (!numbers_of(call, 2, x)) return Value::failure();
  if (x[0] <= 0 || x[1] <= 0) return domain_fault(call);
  const double base = std::log(x[1]);
  if (base == 0) return call.evaluator.fail("this divides by 0");
  return Value::of(std::log(x[0]) / base);
}

double remainder(double x, double y) { return std::remainder(x, y); }
double plain_atan2(double y, double x) { return arc_tangent(y, x); }
double copy_sign(double x, double y) { return std::copysign(x, y); }
double next_after(double x, double y) { return std::nextafter(x, y); }

template <double (*Compute)(double, double)>
Value binary_function(Call& call) {
  double x[2] = {};
  if (!numbers_of(call, 2, x)) return Value::failure();
  return Value::of(Compute(x[0], x[1]));
}

Value fmod(Call& call) {
  double x[2] = {};
  if (!numbers_of(call, 2, x)) return Value::failure();
  if ((x[1] == 0 || std::isinf(x[0])) && !std::isnan(x[0]) && !std::isnan(x[1])) {
    return domain_fault(call);
  }
  return Value::of(call.name == "fmod" ? std::fmod(x[0], x[1]) : remainder(x[0], x[1]));
}

Value pow(Call& call) {
  double x[2] = {};
  if (!numbers_of(call, 2, x)) return Value::failure();
  const double result = std::pow(x[0], x[1]);
  const bool is_finite = std::isfinite(x[0]) && std::isfinite(x[1]);
  if (is_finite && (std::isnan(result) || (x[0] == 0 && x[1] < 0))) return domain_fault(call);
  if (is_finite && std::isinf(result)) return call.evaluator.fail("the power is too large");
  return Value::of(result);
}

enum class Way : std::uint8_t { down, up, toward_zero };

Value whole(Call& call, Way way) {
  if (!call.has_count(1, 1)) return Value::failure();
  const Value& value = call.values[0];
  if (value.is_integral()) return call.evaluator.integer(to_big(value));
  double x = 0;
  if (!numbers_of(call, 1, &x)) return Value::failure();
  if (!std::isfinite(x)) return call.evaluator.fail("there is no integer for this value");
  const double result = way == Way::down ? std::floor(x)
                        : way == Way::up ? std::ceil(x)
                                         : std::trunc(x);
  return call.evaluator.integer(BigInt::from_double(result));
}
Value floor(Call& call) { return whole(call, Way::down); }
Value ceil(Call& call) { return whole(call, Way::up); }
Value trunc(Call& call) { return whole(call, Way::toward_zero); }

/// Whether all values are integers.
bool are_integers(Call& call) {
  for (const Value& value : call.values) {
    if (value.is_integral()) continue;
    call.evaluator.fail("`" + std::string(call.name) + "()` needs integers");
    return false;
  }
  return true;
}

Value factorial(Call& call) {
  if (!call.has_count(1, 1) || !are_integers(call)) return Value::failure();
  const auto count = to_big(call.values[0]).to_int64();
  if (!count || *count < 0) return domain_fault(call);
  BigInt product(1);
  for (std::int64_t i = 2; i <= *count; ++i) {
    product = BigInt::product(product, BigInt(i), call.evaluator.meter());
    if (product.bits() > call.evaluator.limits().xacro_integer_bits) break;
  }
  return call.evaluator.integer(std::move(product));
}

BigInt common_divisor(BigInt a, BigInt b, Meter& meter) {
  if (a.is_negative()) a = a.negated();
  if (b.is_negative()) b = b.negated();
  while (!b.is_zero()) {
    BigInt rest = BigInt::divide(a, b, meter).remainder;
    a = std::move(b);
    b = std::move(rest);
  }
  return a;
}

Value gcd(Call& call) {
  if (!call.keywords.empty() || !are_integers(call)) return Value::failure();
  BigInt divisor;
  for (const Value& value : call.values) {
    divisor = common_divisor(divisor, to_big(value), call.evaluator.meter());
  }
  return call.evaluator.integer(std::move(divisor));
}

Value lcm(Call& call) {
  if (!are_integers(call)) return Value::failure();
  BigInt multiple(1);
  for (const Value& value : call.values) {
    const BigInt other = to_big(value);
    if (other.is_zero()) return Value::of(std::int64_t{0});
    Meter& meter = call.evaluator.meter();
    const BigInt divisor = common_divisor(multiple, other, meter);
    multiple = BigInt::product(BigInt::divide(multiple, divisor, meter).quotient, other, meter);
    if (multiple.is_negative()) multiple = multiple.negated();
    const Value checked = call.evaluator.integer(multiple);
    if (checked.is_failed()) return checked;
  }
  return call.evaluator.integer(std::move(multiple));
}

/// The number of ways to choose (comb) or to arrange (perm).
Value choices(Call& call) {
  if (!call.has_count(1, 2) || !are_integers(call)) return Value::failure();
  const auto n = to_big(call.values[0]).to_int64();
  const bool is_perm = call.name == "perm";
  if (call.count() == 1 && is_perm) return factorial(call);
  const auto k = call.count() == 2 ? to_big(call.values[1]).to_int64() : std::nullopt;
  if (!n || !k || *n < 0 || *k < 0) return domain_fault(call);
  if (*k > *n) return Value::of(std::int64_t{0});
  BigInt result(1);
  const std::int64_t count = is_perm ? *k : std::min(*k, *n - *k);
  for (std::int64_t i = 0; i < count; ++i) {
    Meter& meter = call.evaluator.meter();
    result = BigInt::product(result, BigInt(*n - i), meter);
    if (!is_perm) result = BigInt::divide(result, BigInt(i + 1), meter).quotient;
    if (result.bits() > call.evaluator.limits().xacro_integer_bits) break;
  }
  return call.evaluator.integer(std::move(result));
}

Value isqrt(Call& call) {
  if (!call.has_count(1, 1) || !are_integers(call)) return Value::failure();
  const BigInt square = to_big(call.values[0]);
  if (square.is_negative()) return domain_fault(call);
  if (square.is_zero()) return Value::of(std::int64_t{0});
  BigInt root = BigInt(1).shifted_left(square.bits() / 2 + 1);
  for (;;) {
    BigInt next =
        (root + BigInt::divide(square, root, call.evaluator.meter()).quotient).shifted_right(1);
    if (BigInt::compare(next, root) >= 0) return call.evaluator.integer(std::move(root));
    root = std::move(next);
  }
}

Value isnan(Call& call) {
  double x = 0;
  return numbers_of(call, 1, &x) ? Value::of(std::isnan(x)) : Value::failure();
}
Value isinf(Call& call) {
  double x = 0;
  return numbers_of(call, 1, &x) ? Value::of(std::isinf(x)) : Value::failure();
}
Value isfinite(Call& call) {
  double x = 0;
  return numbers_of(call, 1, &x) ? Value::of(std::isfinite(x)) : Value::failure();
}

Value isclose(Call& call) {
  const Value* relative = call.take(~std::size_t{0}, "rel_tol");
  const Value* absolute = call.take(~std::size_t{0}, "abs_tol");
  const double rel = relative != nullptr ? to_real(*relative).value_or(0) : 1e-09;
  const double abs = absolute != nullptr ? to_real(*absolute).value_or(0) : 0.0;
  std::erase_if(call.keywords, [](const auto& one) { return one.first.empty(); });
  double x[2] = {};
  if (!numbers_of(call, 2, x)) return Value::failure();
  if (x[0] == x[1]) return Value::of(true);
  if (std::isinf(x[0]) || std::isinf(x[1])) return Value::of(false);
  const double distance = std::fabs(x[0] - x[1]);
  return Value::of(distance <= std::fabs(rel * x[1]) || distance <= std::fabs(rel * x[0]) ||
                   distance <= abs);
}

/// All numbers of the parameters or of the one list.
bool all_numbers(Call& call, const std::vector<Value>& items, std::vector<double>& numbers) {
  call.evaluator.step(items.size());
  for (const Value& item : items) {
    const auto real = to_real(item);
    if (!real) {
      call.evaluator.fail("`" + std::string(call.name) + "()` needs numbers");
      return false;
    }
    numbers.push_back(*real);
  }
  return true;
}

double length_of(const std::vector<double>& numbers) {
  double length = 0;
  for (const double one : numbers) length = hypotenuse(length, one);
  return length;
}

Value hypot(Call& call) {
  std::vector<double> numbers;
  if (!all_numbers(call, call.values, numbers)) return Value::failure();
  if (numbers.size() == 3) return Value::of(hypotenuse(numbers[0], numbers[1], numbers[2]));
  return Value::of(length_of(numbers));
}

Value dist(Call& call) {
  std::vector<Value> points[2];
  std::vector<double> a, b;
  if (!call.has_count(2, 2) || !call.evaluator.items_of(call.values[0], points[0]) ||
      !call.evaluator.items_of(call.values[1], points[1]) || !all_numbers(call, points[0], a) ||
      !all_numbers(call, points[1], b)) {
    return Value::failure();
  }
  if (a.size() != b.size()) return call.evaluator.fail("`dist()` needs points of one dimension");
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  if (a.size() == 3) return Value::of(hypotenuse(a[0], a[1], a[2]));
  return Value::of(length_of(a));
}

/// An exact sum, rounded once: Shewchuk's partial sums, as CPython's fsum().
Value fsum(Call& call) {
  std::vector<Value> items;
  std::vector<double> numbers, partials;
  if (!call.has_count(1, 1) || !call.evaluator.items_of(call.values[0], items) ||
      !all_numbers(call, items, numbers)) {
    return Value::failure();
  }
  const double plain = std::accumulate(numbers.begin(), numbers.end(), 0.0);
  const auto is_finite = [](double one) { return std::isfinite(one); };
  if (!std::all_of(numbers.begin(), numbers.end(), is_finite)) {
    const auto is_nan = [](double one) { return std::isnan(one); };
    const bool has_nan = std::any_of(numbers.begin(), numbers.end(), is_nan);
    return std::isnan(plain) && !has_nan ? domain_fault(call) : Value::of(plain);
  }
  for (double x : numbers) {
    call.evaluator.step(1 + partials.size() / 4);
    std::size_t kept = 0;
    for (double y : partials) {
      if (std::fabs(x) < std::fabs(y)) std::swap(x, y);
      const double high = x + y;
      const double low = y - (high - x);
      if (low != 0) partials[kept++] = low;
      x = high;
    }
    if (!std::isfinite(x)) return call.evaluator.fail("the sum is too large for a number");
    partials.resize(kept);
    partials.push_back(x);
  }
  double high = 0;
  for (std::size_t n = partials.size(); n > 0;) {
    const double x = high;
    const double y = partials[--n];
    high = x + y;
    const double low = y - (high - x);
    if (low == 0) continue;
    // Half an even digit: the next partial decides.
    const bool is_same_way = n > 0 && (low < 0) == (partials[n - 1] < 0) && partials[n - 1] != 0;
    const double twice = low * 2;
    const double next = high + twice;
    if (is_same_way && twice == next - high) high = next;
    break;
  }
  return Value::of(high);
}

Value prod(Call& call) {
  const Value* start = call.take(~std::size_t{0}, "start");
  Value product = start != nullptr ? *start : Value::of(std::int64_t{1});
  std::vector<Value> items;
  if (call.values.size() != 1 || !call.evaluator.items_of(call.values[0], items)) {
    return call.evaluator.fail("`prod()` needs a list");
  }
  for (const Value& item : items) {
    product = compute(call.evaluator, Operation::multiply, product, item);
    if (product.is_failed()) break;
  }
  return product;
}

Value frexp(Call& call) {
  double x = 0;
  if (!numbers_of(call, 1, &x)) return Value::failure();
  int exponent = 0;
  const double fraction = std::isfinite(x) ? std::frexp(x, &exponent) : x;
  return call.evaluator.list({Value::of(fraction), Value::of(std::int64_t{exponent})}, Kind::tuple);
}

Value ldexp(Call& call) {
  double x[2] = {};
  if (!numbers_of(call, 2, x) || !call.values[1].is_integral()) {
    return call.evaluator.fail("`ldexp()` needs a number and an integer");
  }
  constexpr double kMost = 5000;
  const double result = std::ldexp(x[0], static_cast<int>(std::min(std::max(x[1], -kMost), kMost)));
  return checked(call, x[0], result);
}

Value modf(Call& call) {
  double x = 0;
  if (!numbers_of(call, 1, &x)) return Value::failure();
  double whole_part = 0;
  const double fraction = std::modf(x, &whole_part);
  return call.evaluator.list({Value::of(fraction), Value::of(whole_part)}, Kind::tuple);
}

Value ulp(Call& call) {
  double x = 0;
  if (!numbers_of(call, 1, &x)) return Value::failure();
  if (!std::isfinite(x)) return Value::of(std::fabs(x));
  x = std::fabs(x);
  const double above = std::nextafter(x, kInfinity);
  return Value::of(std::isinf(above) ? x - std::nextafter(x, -kInfinity) : above - x);
}

struct Row {
  std::string_view name;
  Value (*call)(Call& call);
};

constexpr std::array kFunctions = {
    Row{"acos", real_function<arc_cosine>},
    Row{"acosh", real_function<std::acosh>},
    Row{"asin", real_function<arc_sine>},
    Row{"asinh", real_function<std::asinh>},
    Row{"atan", real_function<arc_tangent_of>},
    Row{"atan2", binary_function<plain_atan2>},
    Row{"atanh", real_function<std::atanh>},
    Row{"cbrt", real_function<std::cbrt>},
    Row{"ceil", ceil},
    Row{"comb", choices},
    Row{"copysign", binary_function<copy_sign>},
    Row{"cos", real_function<cosine>},
    Row{"cosh", real_function<std::cosh>},
    Row{"degrees", real_function<degrees>},
    Row{"dist", dist},
    Row{"erf", real_function<std::erf>},
    Row{"erfc", real_function<std::erfc>},
    Row{"exp", real_function<std::exp>},
    Row{"exp2", real_function<power_of_two>},
    Row{"expm1", real_function<std::expm1>},
    Row{"fabs", real_function<std::fabs>},
    Row{"factorial", factorial},
    Row{"floor", floor},
    Row{"fmod", fmod},
    Row{"frexp", frexp},
    Row{"fsum", fsum},
    Row{"gamma", real_function<gamma>},
    Row{"gcd", gcd},
    Row{"hypot", hypot},
    Row{"isclose", isclose},
    Row{"isfinite", isfinite},
    Row{"isinf", isinf},
    Row{"isnan", isnan},
    Row{"isqrt", isqrt},
    Row{"lcm", lcm},
    Row{"ldexp", ldexp},
    Row{"lgamma", real_function<log_gamma>},
    Row{"log", log},
    Row{"log10", logarithm<std::log10>},
    Row{"log1p", real_function<std::log1p>},
    Row{"log2", logarithm<std::log2>},
    Row{"modf", modf},
    Row{"nextafter", binary_function<next_after>},
    Row{"perm", choices},
    Row{"pow", pow},
    Row{"prod", prod},
    Row{"radians", real_function<radians>},
    Row{"remainder", fmod},
    Row{"sin", real_function<sine>},
    Row{"sinh", real_function<std::sinh>},
    Row{"sqrt", real_function<std::sqrt>},
    Row{"tan", real_function<tangent>},
    Row{"tanh", real_function<std::tanh>},
    Row{"trunc", trunc},
    Row{"ulp", ulp},
};

}  // namespace

void add_math(Table& table, Heap& heap) {
  for (const Row& row : kFunctions) {
    Function function;
    function.name = row.name;
    function.call = row.call;
    table.set(row.name, heap.function(function));
  }
  table.set("pi", Value::of(std::numbers::pi));
  table.set("e", Value::of(std::numbers::e));
  table.set("tau", Value::of(2 * std::numbers::pi));
  table.set("inf", Value::of(kInfinity));
  table.set("nan", Value::of(kNaN));
}

}  // namespace smurf::xacro
