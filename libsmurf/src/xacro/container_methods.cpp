// SPDX-License-Identifier: BSD-3-Clause
// Methods of lists and dictionaries.
#include <algorithm>
#include <array>

#include "xacro/evaluator.hpp"

namespace smurf::xacro {
namespace {

Value pop(Call& call) {
  if (!call.has_count(0, 1)) return Value::failure();
  List& list = *call.self.list;
  std::int64_t at = -1;
  const auto size = static_cast<std::int64_t>(list.items.size());
  if (call.count() == 1) {
    if (call.values[0].kind != Kind::integer)
      return call.evaluator.fail("`pop()` needs an integer");
    at = call.values[0].integer;
  }
  if (at < 0) at += size;
  if (at < 0 || at >= size) return call.evaluator.fail("`pop()` finds no item there");
  const auto place = list.items.begin() + at;
  const Value value = *place;
  list.items.erase(place);
  return value;
}

Value index_of(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  const std::vector<Value>& items = call.self.list->items;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (are_equal(items[i], call.values[0])) return Value::of(static_cast<std::int64_t>(i));
  }
  return call.evaluator.fail("the value is not in the list");
}

Value count_items(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  const std::vector<Value>& items = call.self.list->items;
  return Value::of(
      static_cast<std::int64_t>(std::count_if(items.begin(), items.end(), [&](const Value& item) {
        return are_equal(item, call.values[0]);
      })));
}

Value copy_list(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  return call.evaluator.list(call.self.list->items);
}

Value get(Call& call) {
  if (!call.has_count(1, 2)) return Value::failure();
  const auto key = hash_key(call.values[0]);
  if (!key) return call.evaluator.fail(std::string(kind_name(call.values[0])) + " cannot be a key");
  const Value* value = call.self.dict->find(*key);
  if (value != nullptr) return *value;
  return call.count() == 2 ? call.values[1] : Value();
}

Value members(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  std::vector<Value> items;
  for (const auto& [key, value] : call.self.dict->items) {
    if (call.name == "keys") {
      items.push_back(key);
    } else if (call.name == "values") {
      items.push_back(value);
    } else {
      items.push_back(call.evaluator.list({key, value}, Kind::tuple));
    }
  }
  const Value list = call.evaluator.list(std::move(items));
  if (list.is_failed()) return list;
  list.list->type = call.name == "keys"     ? Type::dict_keys
                    : call.name == "values" ? Type::dict_values
                                            : Type::dict_items;
  return list;
}

Value copy_dict(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  return call.evaluator.heap().dict(*call.self.dict);
}

constexpr std::array kList = {
    Method{"append", nullptr},    Method{"clear", nullptr},  Method{"copy", copy_list},
    Method{"count", count_items}, Method{"extend", nullptr}, Method{"index", index_of},
    Method{"insert", nullptr},    Method{"pop", pop},        Method{"remove", nullptr},
    Method{"reverse", nullptr},   Method{"sort", nullptr}};

constexpr std::array kDict = {
    Method{"clear", nullptr},  Method{"copy", copy_dict},  Method{"fromkeys", nullptr},
    Method{"get", get},        Method{"items", members},   Method{"keys", members},
    Method{"pop", nullptr},    Method{"popitem", nullptr}, Method{"setdefault", nullptr},
    Method{"update", nullptr}, Method{"values", members}};

template <class Rows>
const Method* find_row(const Rows& rows, std::string_view name) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const Method& one) { return one.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

const Method* list_method(std::string_view name) { return find_row(kList, name); }
const Method* dict_method(std::string_view name) { return find_row(kDict, name); }

}  // namespace smurf::xacro
