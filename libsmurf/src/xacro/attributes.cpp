// SPDX-License-Identifier: BSD-3-Clause
// `value.name` and `value[index]`.
#include <algorithm>

#include "base/quoted.hpp"
#include "base/rules.hpp"
#include "base/suggest.hpp"
#include "base/utf8.hpp"
#include "xacro/evaluator.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

Value no_key(Evaluator& evaluator, const Dict& dict, const std::string& name) {
  std::vector<std::string_view> known;
  for (const auto& [key, value] : dict.items) {
    if (key.is_text()) known.push_back(*key.text);
  }
  std::uint64_t comparisons = 100'000;
  const auto near = only_nearest(name, known, comparisons);
  return evaluator.fail(rules::sml3303_xacro_computation,
                        "the dictionary has no key " + quoted(name),
                        near ? "did you mean " + quoted(*near) + "?" : "");
}

Value bound(Evaluator& evaluator, const Value& self, const Method& method) {
  if (method.call == nullptr) {
    return evaluator.fail_unsupported("the method `" + std::string(method.name) + "()`");
  }
  Function function;
  function.name = method.name;
  function.call = method.call;
  function.self = self;
  return evaluator.heap().function(function);
}

const Method* method_of(const Value& value, std::string_view name) {
  switch (value.kind) {
  case Kind::text: return text_method(name);
  case Kind::list:
  case Kind::tuple: {
    const Method* method = list_method(name);
    const bool is_of_both = name == "index" || name == "count";
    return value.kind == Kind::list || is_of_both ? method : nullptr;
  }
  case Kind::dict: return dict_method(name);
  default: return nullptr;
  }
}

std::optional<std::int64_t> whole(const Value& value) {
  if (!value.is_integral()) return std::nullopt;
  return to_big(value).to_int64();
}

/// The positions that a slice takes from a sequence of a size, as CPython's PySlice_AdjustIndices.
bool positions_of(Evaluator& evaluator, const Slice& slice, std::int64_t size,
                  std::vector<std::size_t>& positions) {
  const auto part = [&](const Value& value, std::optional<std::int64_t>& result) {
    if (value.kind == Kind::none) return true;
    result = whole(value);
    if (!result && value.kind == Kind::big) result = value.big->is_negative() ? -size - 1 : size;
    if (!result) evaluator.fail("a slice needs integers");
    return result.has_value();
  };
  std::optional<std::int64_t> begin, end, step;
  if (!part(slice.begin, begin) || !part(slice.end, end) || !part(slice.step, step)) return false;
  const std::int64_t by = step.value_or(1);
  if (by == 0) {
    evaluator.fail("the step of a slice is 0");
    return false;
  }
  const std::int64_t lowest = by < 0 ? -1 : 0;
  const std::int64_t highest = by < 0 ? size - 1 : size;
  const auto inside = [&](std::int64_t at) {
    if (at < 0) at = at < -size ? -1 : at + size;
    return std::clamp(at, lowest, highest);
  };
  std::int64_t at = begin ? inside(*begin) : (by < 0 ? highest : lowest);
  const std::int64_t stop = end ? inside(*end) : (by < 0 ? lowest : highest);
  while (by > 0 ? at < stop : at > stop) {
    positions.push_back(static_cast<std::size_t>(at));
    if (by > size || -by > size) break;
    at += by;
  }
  return evaluator.step(positions.size() / 16);
}

bool position_of(Evaluator& evaluator, const Value& index, std::size_t size,
                 std::size_t& position) {
  if (!index.is_integral()) {
    evaluator.fail("the index is " + std::string(kind_name(index)) + ", not an integer");
    return false;
  }
  const auto at = whole(index);
  const auto count = static_cast<std::int64_t>(size);
  if (!at || *at < -count || *at >= count) {
    evaluator.fail("the index is out of range: there are " + std::to_string(size) + " items");
    return false;
  }
  position = static_cast<std::size_t>(*at < 0 ? *at + count : *at);
  return true;
}

Value subscript_text(Evaluator& evaluator, const std::string& text, const Value& index) {
  std::vector<std::string_view> characters;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t size = utf8::decode(rest).size;
    characters.push_back(rest.substr(0, size));
    rest.remove_prefix(size);
  }
  if (!evaluator.step(text.size() / 16)) return Value::failure();
  std::string result;
  if (index.kind == Kind::slice) {
    std::vector<std::size_t> positions;
    const auto size = static_cast<std::int64_t>(characters.size());
    if (!positions_of(evaluator, *index.slice, size, positions)) return Value::failure();
    for (const std::size_t at : positions) result += characters[at];
  } else {
    std::size_t at = 0;
    if (!position_of(evaluator, index, characters.size(), at)) return Value::failure();
    result = characters[at];
  }
  return evaluator.text(std::move(result));
}

Value subscript_list(Evaluator& evaluator, const Value& value, const Value& index) {
  const std::vector<Value>& items = value.list->items;
  const bool is_wrapped = value.list->is_wrapped;
  if (index.kind != Kind::slice) {
    std::size_t at = 0;
    if (!position_of(evaluator, index, items.size(), at)) return Value::failure();
    return is_wrapped ? evaluator.wrapped(items[at]) : items[at];
  }
  std::vector<std::size_t> positions;
  const auto size = static_cast<std::int64_t>(items.size());
  if (!positions_of(evaluator, *index.slice, size, positions)) return Value::failure();
  std::vector<Value> taken;
  for (const std::size_t at : positions) taken.push_back(items[at]);
  const Value result = evaluator.list(std::move(taken), value.kind);
  if (is_wrapped && !result.is_failed()) result.list->is_wrapped = true;
  return result;
}

}  // namespace

Value attribute_of(Evaluator& evaluator, const Value& value, std::string_view name) {
  if (const Method* method = method_of(value, name)) return bound(evaluator, value, *method);
  if (name == "__class__") return Value::of(type_of(value));
  if (name.starts_with('_')) return evaluator.fail("names that begin with `_` are not allowed");
  if (value.kind == Kind::name_space) {
    const Table::Found found = value.table->find(name);
    if (!found) {
      return evaluator.fail(rules::sml3301_xacro_unknown_name,
                            "the namespace has no " + quoted(name));
    }
    if (!found.entry->is_unevaluated) return found.entry->value;
    return evaluator.host().resolve(*found.table, *found.entry, name);
  }
  if (value.kind == Kind::dict && value.is_wrapped) {
    const Value* member = value.dict->find("t" + std::string(name));
    if (member == nullptr) return no_key(evaluator, *value.dict, std::string(name));
    return evaluator.wrapped(*member);
  }
  if (value.is_number() || value.kind == Kind::complex) {
    const auto whole_value = to_real(value);
    if (name == "real" && whole_value) return value;
    if (value.kind == Kind::complex && name == "real") return Value::of(value.complex->real());
    if (value.kind == Kind::complex && name == "imag") return Value::of(value.complex->imag());
  }
  const Value fault =
      evaluator.fail(std::string(kind_name(value)) + " has no attribute " + quoted(name));
  if (value.kind == Kind::dict) {
    evaluator.failure().help = "write `['" + std::string(name) +
                               "']`; only dictionaries of YAML have their keys as attributes";
  }
  return fault;
}

Value subscript_of(Evaluator& evaluator, const Value& value, const Value& index) {
  switch (value.kind) {
  case Kind::text: return subscript_text(evaluator, *value.text, index);
  case Kind::tuple: return subscript_list(evaluator, value, index);
  case Kind::list:
    if (value.list->type != Type::list) break;
    return subscript_list(evaluator, value, index);
  case Kind::range: {
    std::size_t at = 0;
    const auto size = static_cast<std::size_t>(value.range->size());
    if (!position_of(evaluator, index, size, at)) return Value::failure();
    return Value::of(value.range->begin + static_cast<std::int64_t>(at) * value.range->step);
  }
  case Kind::dict: {
    const auto key = hash_key(index);
    if (!key) return evaluator.fail(std::string(kind_name(index)) + " cannot be a key");
    const Value* member = value.dict->find(*key);
    if (member == nullptr) {
      return no_key(evaluator, *value.dict, evaluator.string_of(index));
    }
    return value.is_wrapped ? evaluator.wrapped(*member) : *member;
  }
  case Kind::name_space:
    if (index.is_text()) return attribute_of(evaluator, value, *index.text);
    break;
  default: break;
  }
  return evaluator.fail(std::string(kind_name(value)) + " has no items");
}

}  // namespace smurf::xacro
