// SPDX-License-Identifier: BSD-3-Clause
// The functions that expressions know by name, in the global table, `python.` and `xacro.`.
#include <algorithm>
#include <cmath>

#include "base/findings/rules.hpp"
#include "xacro/evaluator.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

Value len(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  const Value& value = call.values[0];
  switch (value.kind) {
  case Kind::text: {
    call.evaluator.meter().copy(value.text->size());
    std::int64_t count = 0;
    for (const char c : *value.text) count += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    return Value::of(count);
  }
  case Kind::bytes: return Value::of(static_cast<std::int64_t>(value.text->size()));
  case Kind::list:
  case Kind::tuple:
  case Kind::set: return Value::of(static_cast<std::int64_t>(value.list->items.size()));
  case Kind::dict: return Value::of(static_cast<std::int64_t>(value.dict->items.size()));
  case Kind::range: return Value::of(value.range->size());
  default: return call.evaluator.fail(std::string(kind_name(value)) + " has no length");
  }
}

/// The smallest (-1) or the largest (1).
Value extreme(Call& call, int wanted) {
  const Value* key = call.take(~std::size_t{0}, "key");
  const Value* fallback = call.take(~std::size_t{0}, "default");
  std::vector<Value> items = call.values;
  Evaluator& evaluator = call.evaluator;
  if (call.count() == 1 && !evaluator.items_of(call.values[0], items)) return Value::failure();
  const Borrowed borrowed(evaluator.meter(), items.capacity() * sizeof(Value));
  if (items.empty()) {
    if (fallback != nullptr) return *fallback;
    return evaluator.fail("`" + std::string(call.name) + "()` of nothing");
  }
  const auto key_of = [&](const Value& item) {
    return key != nullptr && key->kind != Kind::none ? evaluator.call(*key, {item}) : item;
  };
  Value best = items[0];
  Value best_key = key_of(best);
  for (std::size_t i = 1; i < items.size(); ++i) {
    const Value one = key_of(items[i]);
    if (one.is_failed() || best_key.is_failed()) return Value::failure();
    const Operation operation = wanted < 0 ? Operation::less : Operation::greater;
    const Value is_better = compare_values(evaluator, operation, one, best_key);
    if (is_better.is_failed()) return is_better;
    if (!is_better.boolean) continue;
    best = items[i];
    best_key = one;
  }
  return best;
}
Value min(Call& call) { return extreme(call, -1); }
Value max(Call& call) { return extreme(call, 1); }

constexpr std::uint64_t kStepsOfDecimals = 50;  // hundreds of digits of a number

Value round_integer(Evaluator& evaluator, const Value& value, std::int64_t decimals) {
  if (decimals >= 0) return evaluator.integer(to_big(value));
  if (decimals < -1300) return Value::of(std::int64_t{0});
  BigInt unit(1);
  Meter& meter = evaluator.meter();
  for (std::int64_t i = 0; i > decimals; --i) unit = BigInt::product(unit, BigInt(10), meter);
  const BigInt whole = to_big(value);
  BigInt::Division division = BigInt::divide(whole, unit, meter);
  const int order = BigInt::compare(division.remainder + division.remainder, unit);
  const bool is_odd = !(BigInt::divide(division.quotient, BigInt(2), meter).remainder.is_zero());
  if (order > 0 || (order == 0 && is_odd)) division.quotient = division.quotient + BigInt(1);
  return evaluator.integer(BigInt::product(division.quotient, unit, meter));
}

Value round(Call& call) {
  const Value* decimals = call.take(1, "ndigits");
  if (!call.has_count(1, 2)) return Value::failure();
  const Value& value = call.values[0];
  Evaluator& evaluator = call.evaluator;
  if (!value.is_number())
    return evaluator.fail("`round()` needs a number, not " + std::string(kind_name(value)));
  const bool has_decimals = decimals != nullptr && decimals->kind != Kind::none;
  std::int64_t count = 0;
  if (has_decimals) {
    const auto whole = decimals->is_integral() ? to_big(*decimals).to_int64() : std::nullopt;
    if (!whole) return evaluator.fail("the second parameter of `round()` is no integer");
    count = std::clamp<std::int64_t>(*whole, -400, 400);
  }
  if (value.is_integral()) return round_integer(evaluator, value, count);
  if (has_decimals) {
    evaluator.step(kStepsOfDecimals);
    return Value::of(rounded(value.real, static_cast<int>(count)));
  }
  if (!std::isfinite(value.real))
    return evaluator.fail("there is no integer for " + float_text(value.real));
  const double whole = std::nearbyint(value.real);  // half to even
  return evaluator.integer(BigInt::from_double(whole));
}

Value abs(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  const Value& value = call.values[0];
  if (value.kind == Kind::real) return Value::of(std::fabs(value.real));
  if (value.kind == Kind::complex) return Value::of(std::abs(*value.complex));
  if (!value.is_integral()) return call.evaluator.fail("`abs()` needs a number");
  const BigInt whole = to_big(value);
  return call.evaluator.integer(whole.is_negative() ? whole.negated() : whole);
}

Value any_or_all(Call& call, bool wanted) {
  std::vector<Value> items;
  if (!call.has_count(1, 1) || !call.evaluator.items_of(call.values[0], items)) {
    return Value::failure();
  }
  const bool has_one = std::any_of(items.begin(), items.end(),
                                   [&](const Value& item) { return is_true(item) == wanted; });
  return Value::of(has_one == wanted);
}
Value any(Call& call) { return any_or_all(call, true); }
Value all(Call& call) { return any_or_all(call, false); }

Value divmod(Call& call) {
  if (!call.has_count(2, 2)) return Value::failure();
  Evaluator& evaluator = call.evaluator;
  const Value quotient =
      compute(evaluator, Operation::floor_divide, call.values[0], call.values[1]);
  if (quotient.is_failed()) return quotient;
  const Value rest = compute(evaluator, Operation::modulo, call.values[0], call.values[1]);
  return rest.is_failed() ? rest : evaluator.list({quotient, rest}, Kind::tuple);
}

Value has_type(Call& call, const Value& wanted, Type type) {
  if (wanted.kind == Kind::tuple) {
    for (const Value& one : wanted.list->items) {
      call.evaluator.step();
      const Value result = has_type(call, one, type);
      if (result.is_failed() || result.boolean) return result;
    }
    return Value::of(false);
  }
  if (wanted.kind != Kind::type) return call.evaluator.fail("this is no type");
  return Value::of(is_subtype(type, wanted.type));
}
Value isinstance(Call& call) {
  if (!call.has_count(2, 2)) return Value::failure();
  return has_type(call, call.values[1], type_of(call.values[0]));
}
Value issubclass(Call& call) {
  if (!call.has_count(2, 2)) return Value::failure();
  if (call.values[0].kind != Kind::type) return call.evaluator.fail("this is no type");
  return has_type(call, call.values[1], call.values[0].type);
}

Value ord(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  std::vector<Value> items;
  const Value& value = call.values[0];
  if (!value.is_text() || !call.evaluator.items_of(value, items) || items.size() != 1) {
    return call.evaluator.fail("`ord()` needs a text of one character");
  }
  const std::string& text = *value.text;
  const auto first = static_cast<unsigned char>(text[0]);
  std::int64_t code = text.size() == 1 ? first : first & (0x7FU >> text.size());
  for (std::size_t i = 1; i < text.size(); ++i) {
    code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  return Value::of(code);
}

Value repr(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  std::string text = call.evaluator.repr(call.values[0]);
  return call.evaluator.has_failed() ? Value::failure() : call.evaluator.text(std::move(text));
}

Value sum(Call& call) {
  const Value* start = call.take(1, "start");
  Value total = start != nullptr ? *start : Value::of(std::int64_t{0});
  std::vector<Value> items;
  if (!call.has_count(1, 2) || !call.evaluator.items_of(call.values[0], items)) {
    return Value::failure();
  }
  if (total.is_text()) return call.evaluator.fail("`sum()` does not join texts; use `''.join()`");
  for (const Value& item : items) {
    total = compute(call.evaluator, Operation::add, total, item);
    if (total.is_failed()) return total;
  }
  return total;
}

Value unsupported(Call& call) {
  return call.evaluator.fail_unsupported("`" + std::string(call.name) + "()`");
}

}  // namespace

Value sorted(Call& call) {
  const Value* key = call.take(~std::size_t{0}, "key");
  const Value* reverse = call.take(~std::size_t{0}, "reverse");
  const bool has_key = key != nullptr && key->kind != Kind::none;
  const Value key_function = has_key ? *key : Value();
  const bool is_reversed = reverse != nullptr && is_true(*reverse);
  std::vector<Value> items;
  Evaluator& evaluator = call.evaluator;
  if (!call.has_count(1, 3) || !evaluator.items_of(call.values[0], items)) return Value::failure();
  const Borrowed borrowed(evaluator.meter(), 5 * items.size() * sizeof(Value));
  std::vector<std::pair<Value, Value>> keyed;
  keyed.reserve(items.size());
  for (const Value& item : items) {
    keyed.emplace_back(has_key ? evaluator.call(key_function, {item}) : item, item);
    if (keyed.back().first.is_failed()) return Value::failure();
    const auto order = compare(keyed.front().first, keyed.back().first, evaluator.meter());
    if (!order) return evaluator.fail("`sorted()` cannot order " + std::string(kind_name(item)));
  }
  bool can_order = true;
  std::stable_sort(keyed.begin(), keyed.end(), [&](const auto& a, const auto& b) {
    const auto order = compare(is_reversed ? b.first : a.first, is_reversed ? a.first : b.first,
                               evaluator.meter());
    can_order = can_order && order.has_value();
    return order && *order == -1;
  });
  if (!can_order) return evaluator.fail("`sorted()` cannot order the items");
  items.clear();
  for (const auto& [by, item] : keyed) items.push_back(item);
  return evaluator.list(std::move(items));
}

namespace {

// xacro.

Value load_yaml(Call& call) {
  const Value* path = call.take(0, "filename");
  if (path == nullptr || !path->is_text())
    return call.evaluator.fail("`load_yaml()` needs the path of a file");
  return call.evaluator.host().load_yaml(*path->text);
}

Value abs_filename(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  if (!call.values[0].is_text()) return call.evaluator.fail("`abs_filename()` needs a path");
  return call.evaluator.text(call.evaluator.host().whole_path(*call.values[0].text));
}

Value argument(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  if (!call.values[0].is_text()) return call.evaluator.fail("`arg()` needs a name");
  return call.evaluator.host().argument(*call.values[0].text);
}

Value say(Call& call) {
  std::string text;
  for (const Value& value : call.values) {
    if (!text.empty()) text += " ";
    text += call.evaluator.string_of(value);
    if (text.size() > call.evaluator.limits().xacro_text_bytes) {
      return call.evaluator.text(std::move(text));  // fails
    }
  }
  if (call.evaluator.has_failed()) return Value::failure();
  if (call.name == "fatal")
    return call.evaluator.fail(rules::sml3318_xacro_fatal, "xacro.fatal: " + text);
  call.evaluator.host().say(call.name, text);
  return call.evaluator.text({});
}

Value environment(Call& call) {
  if (call.values.empty() || !call.values[0].is_text())
    return call.evaluator.fail("this needs a name");
  const Value* fallback = call.take(1, "default");
  return call.evaluator.host().environment(*call.values[0].text, fallback);
}

Value find(Call& call) {
  if (call.values.empty() || !call.values[0].is_text())
    return call.evaluator.fail("this needs a name");
  return call.evaluator.host().find_package(*call.values[0].text);
}

struct FunctionRow {
  std::string_view name;
  Value (*call)(Call& call);
};
struct TypeRow {
  std::string_view name;
  Type type;
};

constexpr FunctionRow kGlobal[] = {{"len", len}, {"max", max}, {"min", min}, {"round", round}};
constexpr TypeRow kGlobalTypes[] = {
    {"bool", Type::boolean}, {"dict", Type::dict}, {"float", Type::real}, {"int", Type::integer},
    {"list", Type::list},    {"map", Type::map},   {"str", Type::text}};
constexpr FunctionRow kPython[] = {{"abs", abs},
                                   {"all", all},
                                   {"any", any},
                                   {"divmod", divmod},
                                   {"hash", unsupported},
                                   {"ord", ord},
                                   {"repr", repr},
                                   {"sum", sum},
                                   {"isinstance", isinstance},
                                   {"vars", unsupported},
                                   {"issubclass", issubclass}};
constexpr TypeRow kPythonTypes[] = {{"complex", Type::complex},   {"enumerate", Type::enumerate},
                                    {"filter", Type::filter},     {"frozenset", Type::frozen_set},
                                    {"reversed", Type::reversed}, {"set", Type::set},
                                    {"slice", Type::slice},       {"tuple", Type::tuple},
                                    {"type", Type::type},         {"zip", Type::zip}};
constexpr FunctionRow kXacro[] = {{"load_yaml", load_yaml},
                                  {"abs_filename", abs_filename},
                                  {"arg", argument},
                                  {"tokenize", tokenize},
                                  {"message", say},
                                  {"warning", say},
                                  {"error", say},
                                  {"print_location", say},
                                  {"fatal", say}};

void add(Table& table, Heap& heap, std::span<const FunctionRow> rows) {
  for (const FunctionRow& row : rows) {
    Function function;
    function.name = row.name;
    function.call = row.call;
    table.set(row.name, heap.function(function));
  }
}
void add(Table& table, std::span<const TypeRow> rows) {
  for (const TypeRow& row : rows) table.set(row.name, Value::of(row.type));
}

Table& add_namespace(Table& root, std::string_view name, Heap& heap, std::deque<Table>& tables) {
  Table& table = tables.emplace_back(heap.arena(), true);
  Value value;
  value.kind = Kind::name_space;
  value.table = &table;
  root.set(name, value);
  return table;
}

}  // namespace

void add_functions(Table& root, Heap& heap, std::deque<Table>& tables) {
  add(root, heap, kGlobal);
  add(root, kGlobalTypes);
  root.set("True", Value::of(true));
  root.set("False", Value::of(false));
  constexpr FunctionRow kOld[] = {
      {"sorted", sorted}, {"load_yaml", load_yaml}, {"abs_filename", abs_filename}};
  add(root, heap, kOld);
  root.set("range", Value::of(Type::range));
  root.set("dotify", Value::of(Type::yaml_dict));
  add_math(root, heap);
  add_math(add_namespace(root, "math", heap, tables), heap);
  Table& python = add_namespace(root, "python", heap, tables);
  add(python, heap, kGlobal);
  add(python, kGlobalTypes);
  add(python, heap, kPython);
  add(python, kPythonTypes);
  python.set("True", Value::of(true));
  python.set("False", Value::of(false));
  python.set("range", Value::of(Type::range));
  constexpr FunctionRow kSorted[] = {{"sorted", sorted}};
  add(python, heap, kSorted);
  Table& xacro = add_namespace(root, "xacro", heap, tables);
  add(xacro, heap, kXacro);
  xacro.set("dotify", Value::of(Type::yaml_dict));
}

void add_eval_functions(Table& root, Heap& heap) {
  // $(eval ...) knows the usual functions of Python, too.
  add(root, heap, kGlobal);
  add(root, heap, kPython);
  add(root, kGlobalTypes);
  add(root, kPythonTypes);
  add_math(root, heap);
  constexpr FunctionRow kSubstitutions[] = {
      {"env", environment}, {"optenv", environment}, {"find", find}, {"arg", argument}};
  add(root, heap, kSubstitutions);
  for (const std::string_view name : {"true", "True"}) root.set(name, Value::of(true));
  for (const std::string_view name : {"false", "False"}) root.set(name, Value::of(false));
}

}  // namespace smurf::xacro
