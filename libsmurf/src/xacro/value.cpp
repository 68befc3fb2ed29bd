// SPDX-License-Identifier: BSD-3-Clause
#include "xacro/value.hpp"

#include <algorithm>
#include <cmath>

#include "xacro/python_text.hpp"

namespace smurf::xacro {

std::int64_t Range::size() const {
  if (step > 0) return begin < end ? (end - begin - 1) / step + 1 : 0;
  return begin > end ? (begin - end - 1) / -step + 1 : 0;
}

Value Heap::text(std::string text) {
  charge(sizeof(std::string) + text.capacity());
  Value value;
  value.kind = Kind::text;
  value.text = &texts_.emplace_back(std::move(text));
  return value;
}

Value Heap::bytes(std::string text) {
  Value value = this->text(std::move(text));
  value.kind = Kind::bytes;
  return value;
}

Value Heap::integer(BigInt number) {
  if (const auto small = number.to_int64()) return Value::of(*small);
  charge(sizeof(BigInt) + number.bits() / 8);
  Value value;
  value.kind = Kind::big;
  value.big = &integers_.emplace_back(std::move(number));
  return value;
}

Value Heap::complex(std::complex<double> number) {
  charge(sizeof number);
  Value value;
  value.kind = Kind::complex;
  value.complex = &complexes_.emplace_back(number);
  return value;
}

namespace {

bool is_list(const Value& value) {
  return value.kind == Kind::list || value.kind == Kind::tuple || value.kind == Kind::set ||
         value.kind == Kind::iterator;
}

}  // namespace

int Heap::depth_of(const Value& value) {
  return is_list(value) ? value.list->depth : value.kind == Kind::dict ? value.dict->depth : 0;
}

template <class Items, class Get>
std::uint16_t Heap::depth_of(const Items& items, const Get& get) {
  constexpr std::uint16_t kMost = 100;  // levels
  std::uint16_t depth = 1;
  for (const auto& item : items) {
    const Value& value = get(item);
    depth = std::max(depth, static_cast<std::uint16_t>(depth_of(value) + 1));
    if (is_list(value)) value.list->is_part = true;
    if (value.kind == Kind::dict) value.dict->is_part = true;
  }
  if (depth > kMost) meter_.stop(Meter::Reason::depth);
  return depth;
}

Value Heap::list(std::vector<Value> items, Kind kind) {
  charge(sizeof(List) + items.capacity() * sizeof(Value));
  meter_.step(items.size() / 16);
  Value value;
  value.kind = kind;
  value.list = &lists_.emplace_back();
  value.list->items = std::move(items);
  value.list->depth = depth_of(value.list->items, [](const Value& item) { return item; });
  value.list->type = kind == Kind::tuple ? Type::tuple : kind == Kind::set ? Type::set : Type::list;
  return value;
}

Value Heap::iterator(std::vector<Value> items, Type type) {
  Value value = list(std::move(items), Kind::iterator);
  value.list->type = type;
  return value;
}

Value Heap::dict(Dict dict) {
  constexpr std::size_t kMemberBytes = 150;  // with its key in the tree
  charge(sizeof(Dict) + dict.items.size() * kMemberBytes);
  meter_.step(dict.items.size());
  Value value;
  value.kind = Kind::dict;
  value.dict = &dicts_.emplace_back(std::move(dict));
  value.dict->depth = depth_of(value.dict->items, [](const auto& item) { return item.second; });
  return value;
}

bool Heap::adopt(const Value& owner, std::span<const Value> items) {
  const bool is_dict = owner.kind == Kind::dict;
  std::uint16_t& depth = is_dict ? owner.dict->depth : owner.list->depth;
  const bool is_part = is_dict ? owner.dict->is_part : owner.list->is_part;
  for (const Value& item : items) {
    if (depth_of(item) > 0 && (is_part || item.list == owner.list)) return false;
  }
  depth = std::max(depth, depth_of(items, [](const Value& item) { return item; }));
  constexpr std::size_t kMemberBytes = 150;  // of a dictionary, with its key in the tree
  // A vector that grows has room for twice its items.
  charge(items.size() * (is_dict ? kMemberBytes : 2 * sizeof(Value)));
  return true;
}

Value Heap::range(Range range) {
  charge(sizeof range);
  Value value;
  value.kind = Kind::range;
  value.range = &ranges_.emplace_back(range);
  return value;
}

Value Heap::slice(Slice slice) {
  charge(sizeof slice);
  Value value;
  value.kind = Kind::slice;
  value.slice = &slices_.emplace_back(slice);
  return value;
}

Value Heap::function(Function function) {
  charge(sizeof function);
  Value value;
  value.kind = Kind::function;
  value.function = &functions_.emplace_back(function);
  return value;
}

std::string_view Heap::keep(std::string_view text) {
  charge(sizeof(std::string) + text.size());
  return arena_.keep(text);
}

OriginId Heap::add(Place place) {
  charge(sizeof place);
  places_.push_back(place);
  return OriginId{static_cast<std::uint32_t>(places_.size() - 1)};
}

BigInt to_big(const Value& value) {
  if (value.kind == Kind::big) return *value.big;
  return BigInt(value.kind == Kind::boolean ? std::int64_t{value.boolean} : value.integer);
}

std::optional<double> to_real(const Value& value) {
  switch (value.kind) {
  case Kind::real: return value.real;
  case Kind::boolean: return value.boolean ? 1.0 : 0.0;
  case Kind::integer: return static_cast<double>(value.integer);
  case Kind::big: return value.big->to_double();
  default: return std::nullopt;
  }
}

Type type_of(const Value& value) {
  switch (value.kind) {
  case Kind::none: return Type::none;
  case Kind::boolean: return Type::boolean;
  case Kind::integer:
  case Kind::big: return Type::integer;
  case Kind::real: return Type::real;
  case Kind::complex: return Type::complex;
  case Kind::text: return Type::text;
  case Kind::bytes: return Type::bytes;
  case Kind::list: return value.list->is_wrapped ? Type::yaml_list : value.list->type;
  case Kind::tuple: return Type::tuple;
  case Kind::set:
  case Kind::iterator: return value.list->type;
  case Kind::dict: return value.is_wrapped ? Type::yaml_dict : Type::dict;
  case Kind::range: return Type::range;
  case Kind::slice: return Type::slice;
  case Kind::function: return Type::function;
  case Kind::type: return Type::type;
  default: return Type::other;
  }
}

std::string_view name_of(Type type) {
  constexpr std::string_view kNames[] = {
      "NoneType", "bool",      "int",         "float",
      "complex",  "str",       "bytes",       "list",
      "tuple",    "set",       "frozenset",   "dict",
      "range",    "slice",     "type",        "builtin_function_or_method",
      "map",      "filter",    "zip",         "enumerate",
      "reversed", "dict_keys", "dict_values", "dict_items",
      "list",     "dict",      "object"};
  return kNames[static_cast<std::size_t>(type)];
}

std::string_view kind_name(const Value& value) {
  switch (value.kind) {
  case Kind::none: return "None";
  case Kind::boolean: return "a truth value";
  case Kind::integer:
  case Kind::big: return "an integer";
  case Kind::real: return "a number";
  case Kind::complex: return "a complex number";
  case Kind::text: return "a text";
  case Kind::bytes: return "bytes";
  case Kind::date: return "a date";
  case Kind::list: return "a list";
  case Kind::tuple: return "a tuple";
  case Kind::set: return "a set";
  case Kind::dict: return "a dictionary";
  case Kind::range: return "a range";
  case Kind::function: return "a function";
  case Kind::type: return "a type";
  case Kind::name_space: return "a namespace";
  case Kind::block: return "a block";
  default: return "a value of another kind";
  }
}

bool is_true(const Value& value) {
  switch (value.kind) {
  case Kind::none:
  case Kind::failed: return false;
  case Kind::boolean: return value.boolean;
  case Kind::integer: return value.integer != 0;
  case Kind::real: return value.real != 0;
  case Kind::complex: return *value.complex != 0.0;
  case Kind::text:
  case Kind::bytes: return !value.text->empty();
  case Kind::list:
  case Kind::tuple:
  case Kind::set: return !value.list->items.empty();
  case Kind::dict: return !value.dict->items.empty();
  case Kind::range: return value.range->size() != 0;
  default: return true;
  }
}

namespace {

bool are_equal_numbers(const Value& a, const Value& b, Meter& meter) {
  if (a.kind == Kind::complex || b.kind == Kind::complex) {
    const auto whole = [](const Value& value) -> std::optional<std::complex<double>> {
      if (value.kind == Kind::complex) return *value.complex;
      if (const auto real = to_real(value)) return std::complex<double>(*real);
      return std::nullopt;
    };
    const auto left = whole(a);
    const auto right = whole(b);
    return left && right && *left == *right;
  }
  return compare(a, b, meter) == 0;
}

bool are_equal_texts(const std::string& a, const std::string& b, Meter& meter) {
  if (a.size() != b.size()) return false;
  meter.copy(a.size());
  return a == b;
}

bool are_equal_lists(const List& a, const List& b, Meter& meter) {
  return a.items.size() == b.items.size() &&
         std::equal(a.items.begin(), a.items.end(), b.items.begin(),
                    [&](const Value& x, const Value& y) { return are_equal(x, y, meter); });
}

bool are_equal_sets(const List& a, const List& b, Meter& meter) {
  return a.items.size() == b.items.size() && KeySet(b.items, meter).has_all(a.items);
}

bool are_equal_dicts(const Dict& a, const Dict& b, Meter& meter) {
  if (a.items.size() != b.items.size()) return false;
  for (const auto& [key, index] : a.by_key) {
    meter.step();
    meter.scan(key.size());
    const Value* other = b.find(key);
    if (other == nullptr || !are_equal(a.items[index].second, *other, meter)) return false;
  }
  return true;
}

bool is_numeric(const Value& value) { return value.is_number() || value.kind == Kind::complex; }

/// Exact, also for integers that no double can hold.
std::optional<int> compare_numbers(const Value& a, const Value& b, Meter& meter) {
  const auto order = [](auto left, auto right) { return left < right ? -1 : left > right ? 1 : 0; };
  if (a.is_integral() && b.is_integral()) {
    if (a.kind != Kind::big && b.kind != Kind::big) {
      const auto whole = [](const Value& value) {
        return value.kind == Kind::boolean ? std::int64_t{value.boolean} : value.integer;
      };
      return order(whole(a), whole(b));
    }
    const BigInt left = to_big(a);
    const BigInt right = to_big(b);
    meter.scan(left.bytes() + right.bytes());
    return BigInt::compare(left, right);
  }
  if (a.kind == Kind::real && b.kind == Kind::real) {
    if (std::isnan(a.real) || std::isnan(b.real)) return 2;
    return order(a.real, b.real);
  }
  const bool is_swapped = a.kind != Kind::real;
  const double real = is_swapped ? b.real : a.real;
  if (std::isnan(real)) return 2;
  int result = 0;
  if (std::isinf(real)) {
    result = real > 0 ? 1 : -1;
  } else {
    const BigInt other = to_big(is_swapped ? a : b);
    constexpr std::uint64_t kStepsOfReal = 4;
    meter.step(kStepsOfReal + other.bytes() / 16);
    result = BigInt::compare(BigInt::from_double(real), other);
    const double fraction = real - std::trunc(real);
    if (result == 0 && fraction != 0) result = fraction > 0 ? 1 : -1;
  }
  return is_swapped ? -result : result;
}

}  // namespace

bool are_equal(const Value& a, const Value& b, Meter& meter) {
  meter.step();
  if (is_numeric(a) && is_numeric(b)) return are_equal_numbers(a, b, meter);
  if (a.kind != b.kind) return false;
  switch (a.kind) {
  case Kind::none: return true;
  case Kind::text:
  case Kind::bytes:
  case Kind::date: return are_equal_texts(*a.text, *b.text, meter);
  case Kind::list:
  case Kind::tuple: return are_equal_lists(*a.list, *b.list, meter);
  case Kind::set: return are_equal_sets(*a.list, *b.list, meter);
  case Kind::dict: return are_equal_dicts(*a.dict, *b.dict, meter);
  case Kind::range: {
    const std::int64_t size = a.range->size();
    if (size != b.range->size()) return false;
    if (size == 0) return true;
    return a.range->begin == b.range->begin && (size == 1 || a.range->step == b.range->step);
  }
  case Kind::type: return a.type == b.type;
  default: return a.text == b.text;  // one object
  }
}

std::optional<int> compare(const Value& a, const Value& b, Meter& meter) {
  meter.step();
  if (a.is_number() && b.is_number()) return compare_numbers(a, b, meter);
  if (a.kind != b.kind) return std::nullopt;
  if (a.kind == Kind::text || a.kind == Kind::bytes) {
    meter.copy(std::min(a.text->size(), b.text->size()));
    const int order = a.text->compare(*b.text);  // UTF-8 has the order of its code points
    return order < 0 ? -1 : order > 0 ? 1 : 0;
  }
  if (!a.is_sequence()) return std::nullopt;
  const std::vector<Value>& left = a.list->items;
  const std::vector<Value>& right = b.list->items;
  for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i) {
    if (!are_equal(left[i], right[i], meter)) return compare(left[i], right[i], meter);
  }
  return left.size() < right.size() ? -1 : left.size() > right.size() ? 1 : 0;
}

namespace {

std::optional<std::string> key_of(const Value& value, Meter& meter) {
  switch (value.kind) {
  case Kind::none: return "N";
  case Kind::boolean: return value.boolean ? "i1" : "i0";
  case Kind::integer: return "i" + std::to_string(value.integer);
  case Kind::big: return "i" + value.big->to_text(meter);
  case Kind::real: {
    if (!std::isfinite(value.real))
      return std::isnan(value.real) ? "nan" : value.real > 0 ? "inf" : "-inf";
    if (value.real == std::trunc(value.real))
      return "i" + BigInt::from_double(value.real).to_text(meter);
    return "f" + float_text(value.real);
  }
  case Kind::text: return "t" + *value.text;
  case Kind::bytes: return "b" + *value.text;
  case Kind::tuple: {
    std::string all = "(";
    for (const Value& item : value.list->items) {
      const auto key = hash_key(item, meter);
      if (!key) return std::nullopt;
      all += std::to_string(key->size()) + ":" + *key;
      constexpr std::size_t kMost = 1'000'000;
      if (all.size() > kMost) return std::nullopt;
    }
    return all;
  }
  case Kind::type: return "y" + std::string(name_of(value.type));
  default: return std::nullopt;
  }
}

}  // namespace

std::optional<std::string> hash_key(const Value& value, Meter& meter) {
  constexpr std::uint64_t kStepsOfKey = 2;
  meter.step(kStepsOfKey);
  auto key = key_of(value, meter);
  // It is copied, and compared with those of a tree.
  if (key) meter.step(key->size() / 8);
  return key;
}

void insert(Dict& dict, const Value& key, const Value& value, Meter& meter) {
  auto hashed = hash_key(key, meter);
  if (!hashed) return;
  const std::size_t bytes = hashed->size();
  const auto [place, is_new] = dict.by_key.try_emplace(*std::move(hashed), dict.items.size());
  if (is_new) {
    meter.keep(bytes);
    dict.items.emplace_back(key, value);
  } else {
    dict.items[place->second].second = value;
  }
}

KeySet::KeySet(const std::vector<Value>& items, Meter& meter) : meter_(meter) {
  for (const Value& item : items) {
    if (auto key = hash_key(item, meter)) keys_.insert(*std::move(key));
  }
}

bool KeySet::has(const Value& item) const {
  const auto key = hash_key(item, meter_);
  return key && keys_.contains(*key);
}

bool KeySet::has_all(const std::vector<Value>& items) const {
  return std::all_of(items.begin(), items.end(), [&](const Value& item) { return has(item); });
}

}  // namespace smurf::xacro
