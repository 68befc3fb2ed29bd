// SPDX-License-Identifier: BSD-3-Clause
// `value.name`, `value[index]` and the items of `[a, b]`.
#include <algorithm>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/utf8.hpp"
#include "xacro/evaluator.hpp"
#include "xacro/python_text.hpp"
#include "xacro/text_methods.hpp"

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

/// `str.lower`: the text is the first parameter.
Value call_unbound(Call& call) {
  if (call.values.empty() || !call.values[0].is_text()) {
    return call.evaluator.fail("`str." + std::string(call.name) + "()` needs a text");
  }
  Call inner{call.evaluator,
             call.name,
             call.values[0],
             {call.values.begin() + 1, call.values.end()},
             call.keywords};
  return find_method(text_methods(), call.name)->call(inner);
}

Value unbound(Evaluator& evaluator, const Value& type, const Method& method) {
  const Value function = bound(evaluator, type, method);
  if (function.is_failed()) return function;
  Function made = *function.function;
  made.call = call_unbound;
  return evaluator.heap().function(made);
}

const Method* method_of(const Value& value, std::string_view name) {
  switch (value.kind) {
  case Kind::text: return find_method(text_methods(), name);
  case Kind::list:
  case Kind::tuple: {
    const Method* method = find_method(list_methods(), name);
    const bool is_of_both = name == "index" || name == "count";
    return (value.kind == Kind::list && value.list->type == Type::list) ||
                   (value.kind == Kind::tuple && is_of_both)
               ? method
               : nullptr;
  }
  case Kind::dict: return find_method(dict_methods(), name);
  case Kind::real: return find_method(real_methods(), name);
  default: return value.is_integral() ? find_method(integer_methods(), name) : nullptr;
  }
}

std::optional<std::int64_t> whole(const Value& value) {
  if (!value.is_integral()) return std::nullopt;
  return to_big(value).to_int64();
}

/// What a slice takes from a sequence of a size, as CPython's PySlice_AdjustIndices.
std::optional<Range> ends_of(Evaluator& evaluator, const Slice& slice, std::int64_t size) {
  const auto part = [&](const Value& value, std::optional<std::int64_t>& result) {
    if (value.kind == Kind::none) return true;
    result = whole(value);
    if (!result && value.kind == Kind::big) result = value.big->is_negative() ? -size - 1 : size;
    if (!result) evaluator.fail("a slice needs integers");
    return result.has_value();
  };
  std::optional<std::int64_t> begin, end, step;
  if (!part(slice.begin, begin) || !part(slice.end, end) || !part(slice.step, step)) return {};
  constexpr std::int64_t kMost = std::int64_t{1} << 61U;
  const std::int64_t by = std::clamp(step.value_or(1), -kMost, kMost);
  if (by == 0) {
    evaluator.fail("the step of a slice is 0");
    return {};
  }
  const std::int64_t lowest = by < 0 ? -1 : 0;
  const std::int64_t highest = by < 0 ? size - 1 : size;
  const auto inside = [&](std::int64_t at) {
    if (at < 0) at = at < -size ? -1 : at + size;
    return std::clamp(at, lowest, highest);
  };
  return Range{begin ? inside(*begin) : (by < 0 ? highest : lowest),
               end ? inside(*end) : (by < 0 ? lowest : highest), by};
}

/// The positions that a slice takes.
bool positions_of(Evaluator& evaluator, const Slice& slice, std::int64_t size,
                  std::vector<std::size_t>& positions) {
  const auto ends = ends_of(evaluator, slice, size);
  if (!ends) return false;
  for (std::int64_t i = 0; i < ends->size(); ++i) {
    positions.push_back(static_cast<std::size_t>(ends->begin + i * ends->step));
  }
  evaluator.step(positions.size() / 8);
  return true;
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

Value subscript_ascii(Evaluator& evaluator, const std::string& text, const Value& index) {
  if (index.kind != Kind::slice) {
    std::size_t at = 0;
    if (!position_of(evaluator, index, text.size(), at)) return Value::failure();
    return evaluator.text(std::string(1, text[at]));
  }
  const auto ends = ends_of(evaluator, *index.slice, static_cast<std::int64_t>(text.size()));
  if (!ends) return Value::failure();
  const auto count = static_cast<std::size_t>(ends->size());
  const auto begin = static_cast<std::size_t>(ends->begin);
  if (ends->step == 1)
    return evaluator.text(count == 0 ? std::string() : text.substr(begin, count));
  evaluator.step(count / 16);
  std::string result;
  for (std::int64_t i = 0; i < ends->size(); ++i) {
    result.push_back(text[static_cast<std::size_t>(ends->begin + i * ends->step)]);
  }
  return evaluator.text(std::move(result));
}

Value subscript_text(Evaluator& evaluator, const std::string& text, const Value& index) {
  // A text of ASCII has its characters where its bytes are.
  evaluator.meter().copy(text.size());
  if (is_ascii(text)) return subscript_ascii(evaluator, text, index);
  evaluator.step(text.size() / 4);
  const Borrowed borrowed(evaluator.meter(), 2 * text.size() * sizeof(std::string_view));
  std::vector<std::string_view> characters;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t size = utf8::decode(rest).size;
    characters.push_back(rest.substr(0, size));
    rest.remove_prefix(size);
  }
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
  taken.reserve(positions.size());
  for (const std::size_t at : positions) taken.push_back(items[at]);
  const Value result = evaluator.list(std::move(taken), value.kind);
  if (is_wrapped && !result.is_failed()) result.list->is_wrapped = true;
  return result;
}

/// A slice of a range is a range, as in Python.
Value subscript_range(Evaluator& evaluator, const Range& range, const Slice& slice) {
  const auto ends = ends_of(evaluator, slice, range.size());
  if (!ends) return Value::failure();
  constexpr std::int64_t kMost = std::int64_t{1} << 30U;
  if (std::max({range.step, -range.step, ends->step, -ends->step}) > kMost) {
    return evaluator.fail_unsupported("a part of a range with so long a step");
  }
  return evaluator.heap().range({range.begin + ends->begin * range.step,
                                 range.begin + ends->end * range.step, range.step * ends->step});
}

}  // namespace

Value attribute_of(Evaluator& evaluator, const Value& value, std::string_view name) {
  evaluator.meter().scan(name.size());
  if (const Method* method = method_of(value, name)) return bound(evaluator, value, *method);
  if (value.kind == Kind::type && value.type == Type::text) {
    if (const Method* method = find_method(text_methods(), name))
      return unbound(evaluator, value, *method);
  }
  if (name == "__class__") return Value::of(type_of(value));
  if (name.starts_with('_')) return evaluator.fail("names that begin with `_` are not allowed");
  if (value.kind == Kind::name_space) {
    const Table::Found found = value.table->find(name);
    if (!found) {
      return evaluator.fail(rules::sml3301_xacro_unknown_name,
                            "the namespace has no " + quoted(name), "correct the name");
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
    const bool is_whole = value.is_integral();
    if (name == "real" && is_whole) return evaluator.integer(to_big(value));
    if (name == "numerator" && is_whole) return evaluator.integer(to_big(value));
    if (name == "denominator" && is_whole) return Value::of(std::int64_t{1});
    if (name == "imag" && is_whole) return Value::of(std::int64_t{0});
    if (name == "real" && value.kind == Kind::real) return value;
    if (name == "imag" && value.kind == Kind::real) return Value::of(0.0);
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
    if (index.kind == Kind::slice) return subscript_range(evaluator, *value.range, *index.slice);
    std::size_t at = 0;
    const auto size = static_cast<std::size_t>(value.range->size());
    if (!position_of(evaluator, index, size, at)) return Value::failure();
    return Value::of(value.range->begin + static_cast<std::int64_t>(at) * value.range->step);
  }
  case Kind::dict: {
    const auto key = hash_key(index, evaluator.meter());
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

Value Evaluator::placed(const Value& value, const Syntax& syntax) {
  const bool is_plain = syntax.kind == SyntaxKind::constant && value.is_text() && code_place_ &&
                        syntax.end - syntax.begin == value.text->size() + 2;  // the quotes
  if (!is_plain) return value;
  Span place = *code_place_;
  place.end = place.begin + syntax.end - 1;
  place.begin += syntax.begin + 1;
  return value.at(heap_.add({place, true}));
}

Value Evaluator::parts_of(const Syntax& syntax, const Scope& scope, Kind kind) {
  std::vector<Value> items;
  items.reserve(syntax.parts.size());
  for (const Syntax* part : syntax.parts) {
    const bool is_star = part->kind == SyntaxKind::star;
    const Value value = evaluate(is_star ? *part->parts[0] : *part, scope);
    if (value.is_failed()) return value;
    std::vector<Value> inner{placed(value, *part)};
    if (is_star && !items_of(value, inner)) return Value::failure();
    items.insert(items.end(), inner.begin(), inner.end());
  }
  return list(std::move(items), kind);
}

}  // namespace smurf::xacro
