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
  call.evaluator.step(static_cast<std::uint64_t>(size - at) / 64);
  const auto place = list.items.begin() + at;
  const Value value = *place;
  list.items.erase(place);
  return value;
}

Value index_of(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  const std::vector<Value>& items = call.self.list->items;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (are_equal(items[i], call.values[0], call.evaluator.meter()))
      return Value::of(static_cast<std::int64_t>(i));
  }
  return call.evaluator.fail("the value is not in the list");
}

Value count_items(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  const std::vector<Value>& items = call.self.list->items;
  return Value::of(
      static_cast<std::int64_t>(std::count_if(items.begin(), items.end(), [&](const Value& item) {
        return are_equal(item, call.values[0], call.evaluator.meter());
      })));
}

Value copy_list(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  return call.evaluator.list(call.self.list->items);
}

Value get(Call& call) {
  if (!call.has_count(1, 2)) return Value::failure();
  const auto key = hash_key(call.values[0], call.evaluator.meter());
  if (!key) return call.evaluator.fail(std::string(kind_name(call.values[0])) + " cannot be a key");
  const Value* value = call.self.dict->find(*key);
  if (value != nullptr) return *value;
  return call.count() == 2 ? call.values[1] : Value();
}

Value members(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  std::vector<Value> items;
  call.evaluator.step(call.self.dict->items.size());
  items.reserve(call.self.dict->items.size());
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

/// Whether the list or dictionary may get these items.
bool may_get(Call& call, const std::vector<Value>& items) {
  if (!call.evaluator.heap().adopt(call.self, items)) {
    call.evaluator.fail_unsupported("a list that gets lists while it is in another list");
    return false;
  }
  const std::size_t size =
      call.self.kind == Kind::dict ? call.self.dict->items.size() : call.self.list->items.size();
  if (size + items.size() > call.evaluator.limits().xacro_items) {
    call.evaluator.list(std::vector<Value>(call.evaluator.limits().xacro_items + 1));
    return false;
  }
  call.evaluator.step(items.size());
  return true;
}

/// append(), extend() and insert().
Value add_items(Call& call) {
  const std::size_t count = call.name == "insert" ? 2 : 1;
  if (!call.has_count(count, count)) return Value::failure();
  std::vector<Value>& items = call.self.list->items;
  std::vector<Value> added{call.values.back()};
  if (call.name == "extend" && !call.evaluator.items_of(call.values[0], added)) {
    return Value::failure();
  }
  if (!may_get(call, added)) return Value::failure();
  auto place = items.end();
  if (call.name == "insert") {
    const auto size = static_cast<std::int64_t>(items.size());
    const auto at = call.values[0].is_integral() ? to_big(call.values[0]).to_int64() : std::nullopt;
    if (!at) return call.evaluator.fail("`insert()` needs an integer and a value");
    const std::int64_t from_begin = *at < 0 ? std::max<std::int64_t>(*at, -size) + size : *at;
    place = items.begin() + std::min(from_begin, size);
    call.evaluator.step(static_cast<std::uint64_t>(items.end() - place) / 64);
  }
  items.insert(place, added.begin(), added.end());
  return {};
}

Value remove_item(Call& call) {
  const Value at = index_of(call);
  if (at.is_failed()) return at;
  std::vector<Value>& items = call.self.list->items;
  call.evaluator.step(items.size() / 64);
  items.erase(items.begin() + at.integer);
  return {};
}

Value reverse(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  call.evaluator.step(call.self.list->items.size() / 16);
  std::reverse(call.self.list->items.begin(), call.self.list->items.end());
  return {};
}

Value sort(Call& call) {
  if (call.count() > 0) return call.evaluator.fail("`sort()` has parameters with names only");
  call.values = {call.self};
  const Value result = sorted(call);
  if (result.is_failed()) return result;
  call.self.list->items = result.list->items;
  return {};
}

/// The value of a dictionary of YAML is a copy whenever it is looked up; changing it has no effect,
/// except on the outermost one.
bool is_changeable(Call& call) {
  if (!call.self.is_wrapped) return true;
  call.evaluator.fail_unsupported("a change of a dictionary of YAML");
  return false;
}

Value clear(Call& call) {
  if (!call.has_count(0, 0) || !is_changeable(call)) return Value::failure();
  if (call.self.kind == Kind::list) {
    call.self.list->items.clear();
  } else {
    call.self.dict->items.clear();
    call.self.dict->by_key.clear();
  }
  return {};
}

Value take_member(Call& call, std::size_t at) {
  Dict& dict = *call.self.dict;
  const Value value = dict.items[at].second;
  call.evaluator.step(dict.items.size());
  dict.items.erase(dict.items.begin() + static_cast<std::ptrdiff_t>(at));
  std::erase_if(dict.by_key, [&](const auto& one) { return one.second == at; });
  for (auto& [key, index] : dict.by_key) index -= index > at ? 1 : 0;
  return value;
}

Value pop_member(Call& call) {
  if (!call.has_count(1, 2) || !is_changeable(call)) return Value::failure();
  const auto key = hash_key(call.values[0], call.evaluator.meter());
  const auto found = key ? call.self.dict->by_key.find(*key) : call.self.dict->by_key.end();
  if (found != call.self.dict->by_key.end()) return take_member(call, found->second);
  if (key && call.count() == 2) return call.values[1];
  return call.evaluator.fail("the dictionary has no such key");
}

Value pop_last_member(Call& call) {
  if (!call.has_count(0, 0) || !is_changeable(call)) return Value::failure();
  const Dict& dict = *call.self.dict;
  if (dict.items.empty()) return call.evaluator.fail("the dictionary is empty");
  const Value key = dict.items.back().first;
  const Value value = take_member(call, dict.items.size() - 1);
  return value.is_failed() ? value : call.evaluator.list({key, value}, Kind::tuple);
}

Value set_default(Call& call) {
  if (!call.has_count(1, 2) || !is_changeable(call)) return Value::failure();
  const Value known = get(call);
  if (known.is_failed()) return known;
  if (call.self.dict->find(*hash_key(call.values[0], call.evaluator.meter())) != nullptr)
    return known;
  const Value value = call.count() == 2 ? call.values[1] : Value();
  if (!may_get(call, {value})) return Value::failure();
  insert(*call.self.dict, call.values[0], value, call.evaluator.meter());
  return value;
}

Value update(Call& call) {
  if (!is_changeable(call)) return Value::failure();
  const Value added = call_type(call.evaluator, Type::dict, call);
  if (added.is_failed()) return added;
  std::vector<Value> values;
  for (const auto& [key, value] : added.dict->items) values.push_back(value);
  if (!may_get(call, values)) return Value::failure();
  for (const auto& [key, value] : added.dict->items) {
    insert(*call.self.dict, key, value, call.evaluator.meter());
  }
  return {};
}

constexpr std::array kList = {
    Method{"append", add_items},  Method{"clear", clear},      Method{"copy", copy_list},
    Method{"count", count_items}, Method{"extend", add_items}, Method{"index", index_of},
    Method{"insert", add_items},  Method{"pop", pop},          Method{"remove", remove_item},
    Method{"reverse", reverse},   Method{"sort", sort}};

constexpr std::array kDict = {Method{"clear", clear},
                              Method{"copy", copy_dict},
                              Method{"fromkeys", nullptr},
                              Method{"get", get},
                              Method{"items", members},
                              Method{"keys", members},
                              Method{"pop", pop_member},
                              Method{"popitem", pop_last_member},
                              Method{"setdefault", set_default},
                              Method{"update", update},
                              Method{"values", members}};

}  // namespace

std::span<const Method> list_methods() { return kList; }
std::span<const Method> dict_methods() { return kDict; }

}  // namespace smurf::xacro
