// SPDX-License-Identifier: BSD-3-Clause
// Calls of types: int('7'), list(x), dict(a=1), range(3).
#include <cmath>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "xacro/evaluator.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

/// The base of an integer as Python's source has it; 1 for `007`, which is none.
int written_base(std::string_view text) {
  text = without_blanks(text);
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (!text.starts_with('0')) return 10;
  const char mark = text.size() > 1 ? text[1] : '0';
  switch (mark) {
  case 'x':
  case 'X': return 16;
  case 'o':
  case 'O': return 8;
  case 'b':
  case 'B': return 2;
  default: return text.find_first_not_of("0_") == std::string_view::npos ? 10 : 1;
  }
}

Value to_integer(Evaluator& evaluator, Call& call) {
  const Value* base = call.take(1, "base");
  if (!call.has_count(0, 2)) return Value::failure();
  if (call.values.empty() && base == nullptr) return Value::of(std::int64_t{0});
  if (call.values.empty() || (base != nullptr && !call.values[0].is_text())) {
    return evaluator.fail("`int()` with a base needs a text");
  }
  const Value& value = call.values[0];
  if (value.is_integral()) return evaluator.integer(to_big(value));
  if (value.kind == Kind::real) {
    if (!std::isfinite(value.real)) {
      return evaluator.fail("there is no integer for " + float_text(value.real));
    }
    return evaluator.integer(BigInt::from_double(value.real));
  }
  if (value.is_text()) {
    const auto given = base == nullptr       ? std::optional<std::int64_t>(10)
                       : base->is_integral() ? to_big(*base).to_int64()
                                             : std::nullopt;
    std::int64_t radix = given.value_or(-1);
    if (radix == 0) radix = written_base(*value.text);
    if (radix < 2 || radix > 36) {
      return evaluator.fail("the base of `int()` is no integer from 2 to 36, or 0");
    }
    evaluator.meter().scan(value.text->size());
    const auto read = read_integer(*value.text, evaluator.heap(), static_cast<unsigned>(radix));
    if (read) return *read;
    return evaluator.fail("the text " + quoted(*value.text) + " is no integer");
  }
  return evaluator.fail("`int()` needs a number or a text, not " + std::string(kind_name(value)));
}

Value to_float(Evaluator& evaluator, Call& call) {
  if (!call.has_count(0, 1)) return Value::failure();
  if (call.values.empty()) return Value::of(0.0);
  const Value& value = call.values[0];
  if (value.is_number()) {
    const auto real = to_real(value);
    return real ? Value::of(*real) : evaluator.fail("the integer is too large for a number");
  }
  if (value.is_text()) {
    evaluator.meter().scan(value.text->size());
    if (const auto read = read_float(*value.text)) return Value::of(*read);
    return evaluator.fail("the text " + quoted(*value.text) + " is no number");
  }
  return evaluator.fail("`float()` needs a number or a text, not " + std::string(kind_name(value)));
}

Value to_complex(Evaluator& evaluator, Call& call) {
  const Value* second = call.take(1, "imag");
  if (!call.has_count(1, 2)) return Value::failure();
  const auto part = [&](const Value& value) {
    if (value.kind == Kind::complex) return *value.complex;
    const auto real = to_real(value);
    if (!real) evaluator.fail("`complex()` needs numbers");
    return std::complex<double>(real.value_or(0));
  };
  std::complex<double> result = part(call.values[0]);
  if (second != nullptr) result += std::complex<double>(0, 1) * part(*second);
  return evaluator.has_failed() ? Value::failure() : evaluator.heap().complex(result);
}

Value to_dict(Evaluator& evaluator, Call& call) {
  Dict dict;
  if (call.count() > 1) return evaluator.fail("`dict()` needs one value at most");
  if (call.count() == 1 && call.values[0].kind == Kind::dict) {
    evaluator.step(call.values[0].dict->items.size());
    dict = *call.values[0].dict;
  } else if (call.count() == 1) {
    std::vector<Value> pairs;
    if (!evaluator.items_of(call.values[0], pairs)) return Value::failure();
    for (const Value& pair : pairs) {
      std::vector<Value> two;
      if (!evaluator.items_of(pair, two)) return Value::failure();
      if (two.size() != 2) return evaluator.fail("`dict()` needs pairs");
      if (!hash_key(two[0], evaluator.meter()))
        return evaluator.fail(std::string(kind_name(two[0])) + " cannot be a key");
      insert(dict, two[0], two[1], evaluator.meter());
    }
  }
  for (const auto& [key, value] : call.keywords) {
    insert(dict, evaluator.text(std::string(key)), value, evaluator.meter());
  }
  return evaluator.heap().dict(std::move(dict));
}

Value to_list(Evaluator& evaluator, Call& call, Kind kind, Type type) {
  if (!call.has_count(0, 1)) return Value::failure();
  std::vector<Value> items;
  if (call.count() == 1 && !evaluator.items_of(call.values[0], items)) return Value::failure();
  if (kind == Kind::set) {
    std::map<std::string, bool> known;
    std::vector<Value> unique;
    for (const Value& item : items) {
      const auto key = hash_key(item, evaluator.meter());
      if (!key) return evaluator.fail(std::string(kind_name(item)) + " cannot be in a set");
      if (known.emplace(*key, true).second) unique.push_back(item);
    }
    items = std::move(unique);
  }
  const Value list = evaluator.list(std::move(items), kind);
  if (!list.is_failed() && kind == Kind::set) list.list->type = type;
  return list;
}

Value to_range(Evaluator& evaluator, Call& call) {
  if (!call.has_count(1, 3)) return Value::failure();
  std::int64_t parts[3] = {0, 0, 1};
  for (std::size_t i = 0; i < call.count(); ++i) {
    const Value& value = call.values[i];
    const auto whole = value.is_integral() ? to_big(value).to_int64() : std::nullopt;
    constexpr std::int64_t kMost = std::int64_t{1} << 60U;
    if (!whole || *whole > kMost || *whole < -kMost) {
      return evaluator.fail("`range()` needs integers, not " + std::string(kind_name(value)));
    }
    parts[i] = *whole;
  }
  if (call.count() == 1) return evaluator.heap().range({0, parts[0], 1});
  if (parts[2] == 0) return evaluator.fail("the step of a range is 0");
  return evaluator.heap().range({parts[0], parts[1], parts[2]});
}

Value to_map(Evaluator& evaluator, Call& call) {
  if (!call.has_count(2, 9)) return Value::failure();
  std::vector<std::vector<Value>> lists(call.count() - 1);
  std::size_t shortest = ~std::size_t{0};
  for (std::size_t i = 0; i < lists.size(); ++i) {
    if (!evaluator.items_of(call.values[i + 1], lists[i])) return Value::failure();
    shortest = std::min(shortest, lists[i].size());
  }
  const Borrowed borrowed(evaluator.meter(), (lists.size() + 2) * shortest * sizeof(Value));
  std::vector<Value> results;
  for (std::size_t at = 0; at < shortest; ++at) {
    std::vector<Value> values;
    for (const std::vector<Value>& list : lists) values.push_back(list[at]);
    results.push_back(evaluator.call(call.values[0], std::move(values)));
    if (results.back().is_failed()) return results.back();
  }
  return evaluator.heap().iterator(std::move(results), Type::map);
}

Value to_filter(Evaluator& evaluator, Call& call) {
  if (!call.has_count(2, 2)) return Value::failure();
  std::vector<Value> items;
  if (!evaluator.items_of(call.values[1], items)) return Value::failure();
  const Borrowed borrowed(evaluator.meter(), 2 * items.capacity() * sizeof(Value));
  std::vector<Value> kept;
  for (const Value& item : items) {
    const bool has_function = call.values[0].kind != Kind::none;
    const Value wanted = has_function ? evaluator.call(call.values[0], {item}) : item;
    if (wanted.is_failed()) return wanted;
    if (is_true(wanted)) kept.push_back(item);
  }
  return evaluator.heap().iterator(std::move(kept), Type::filter);
}

Value to_zip(Evaluator& evaluator, Call& call) {
  std::vector<std::vector<Value>> lists(call.count());
  std::size_t shortest = call.count() == 0 ? 0 : ~std::size_t{0};
  for (std::size_t i = 0; i < lists.size(); ++i) {
    if (!evaluator.items_of(call.values[i], lists[i])) return Value::failure();
    shortest = std::min(shortest, lists[i].size());
  }
  std::vector<Value> rows;
  for (std::size_t at = 0; at < shortest; ++at) {
    std::vector<Value> row;
    evaluator.step(lists.size());
    row.reserve(lists.size());
    for (const std::vector<Value>& list : lists) row.push_back(list[at]);
    rows.push_back(evaluator.list(std::move(row), Kind::tuple));
  }
  return evaluator.heap().iterator(std::move(rows), Type::zip);
}

Value to_enumerate(Evaluator& evaluator, Call& call) {
  const Value* start = call.take(1, "start");
  if (!call.has_count(1, 2)) return Value::failure();
  std::vector<Value> items;
  if (!evaluator.items_of(call.values[0], items)) return Value::failure();
  std::int64_t number = start != nullptr && start->kind == Kind::integer ? start->integer : 0;
  for (Value& item : items) {
    item = evaluator.list({Value::of(number++), item}, Kind::tuple);
  }
  return evaluator.heap().iterator(std::move(items), Type::enumerate);
}

Value to_reversed(Evaluator& evaluator, Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  std::vector<Value> items;
  if (!evaluator.items_of(call.values[0], items)) return Value::failure();
  return evaluator.heap().iterator({items.rbegin(), items.rend()}, Type::reversed);
}

Value to_slice(Evaluator& evaluator, Call& call) {
  if (!call.has_count(1, 3)) return Value::failure();
  Slice slice;
  if (call.count() == 1) {
    slice.end = call.values[0];
  } else {
    slice = {call.values[0], call.values[1], call.count() == 3 ? call.values[2] : Value()};
  }
  return evaluator.heap().slice(slice);
}

}  // namespace

bool is_subtype(Type type, Type of) {
  return type == of || (type == Type::boolean && of == Type::integer) ||
         (type == Type::yaml_dict && of == Type::dict) ||
         (type == Type::yaml_list && of == Type::list);
}

Value call_type(Evaluator& evaluator, Type type, Call& call) {
  switch (type) {
  case Type::boolean:
    if (!call.has_count(0, 1)) return Value::failure();
    return Value::of(call.count() == 1 && is_true(call.values[0]));
  case Type::integer: return to_integer(evaluator, call);
  case Type::real: return to_float(evaluator, call);
  case Type::complex: return to_complex(evaluator, call);
  case Type::text: {
    if (!call.has_count(0, 1)) return Value::failure();
    std::string text = call.count() == 1 ? evaluator.string_of(call.values[0]) : std::string();
    return evaluator.has_failed() ? Value::failure() : evaluator.text(std::move(text));
  }
  case Type::list:
  case Type::yaml_list: return to_list(evaluator, call, Kind::list, Type::list);
  case Type::tuple: return to_list(evaluator, call, Kind::tuple, Type::tuple);
  case Type::set:
  case Type::frozen_set: return to_list(evaluator, call, Kind::set, type);
  case Type::dict: return to_dict(evaluator, call);
  case Type::yaml_dict: {
    const Value dict = to_dict(evaluator, call);
    return evaluator.wrapped(dict);
  }
  case Type::range: return to_range(evaluator, call);
  case Type::map: return to_map(evaluator, call);
  case Type::filter: return to_filter(evaluator, call);
  case Type::zip: return to_zip(evaluator, call);
  case Type::enumerate: return to_enumerate(evaluator, call);
  case Type::reversed: return to_reversed(evaluator, call);
  case Type::slice: return to_slice(evaluator, call);
  case Type::type:
    if (!call.has_count(1, 1)) return Value::failure();
    return Value::of(type_of(call.values[0]));
  default: return evaluator.fail_unsupported("a call of the type " + quoted(name_of(type)));
  }
}

}  // namespace smurf::xacro
