// SPDX-License-Identifier: BSD-3-Clause
// Values as texts, as str() and repr() of Python write them.
#include <cmath>

#include "xacro/python_text.hpp"
#include "xacro/value.hpp"

namespace smurf::xacro {
namespace {

/// As the parts of a complex number are written: without ".0".
std::string part_text(double value) {
  std::string text = float_text(value);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

std::string complex_text(const std::complex<double>& value) {
  const double real = value.real();
  const bool has_sign = std::signbit(value.imag());
  const std::string imaginary = part_text(value.imag()) + "j";
  if (real == 0 && !std::signbit(real)) return imaginary;
  return "(" + part_text(real) +
         (has_sign || std::isnan(value.imag()) ? (has_sign ? "" : "+") : "+") + imaginary + ")";
}

constexpr std::string_view kTooLong = "it is too long";

std::string joined(const std::vector<Value>& items, NoText& problem) {
  std::string text;
  for (const Value& item : items) {
    if (!text.empty()) text += ", ";
    text += repr_of(item, problem);
    if (text.size() > problem.most) problem.reason = kTooLong;
    if (!problem.reason.empty()) break;
  }
  return text;
}

std::string dict_text(const Dict& dict, NoText& problem) {
  std::string text = "{";
  for (const auto& [key, value] : dict.items) {
    if (text.size() > 1) text += ", ";
    text += repr_of(key, problem) + ": " + repr_of(value, problem);
    if (text.size() > problem.most) problem.reason = kTooLong;
    if (!problem.reason.empty()) break;
  }
  return text + "}";
}

std::string set_text(const List& set, NoText& problem) {
  const bool is_frozen = set.type == Type::frozen_set;
  if (set.items.empty()) return is_frozen ? "frozenset()" : "set()";
  if (set.items.size() > 1) {
    problem.reason = "the order of a set is random";
    return {};
  }
  const std::string text = "{" + joined(set.items, problem) + "}";
  return is_frozen ? "frozenset(" + text + ")" : text;
}

std::string range_text(const Range& range) {
  std::string text = "range(" + std::to_string(range.begin) + ", " + std::to_string(range.end);
  if (range.step != 1) text += ", " + std::to_string(range.step);
  return text + ")";
}

std::string type_text(Type type) {
  if (type == Type::yaml_list) return "<class 'xacro.YamlListWrapper'>";
  if (type == Type::yaml_dict) return "<class 'xacro.YamlDictWrapper'>";
  return "<class '" + std::string(name_of(type)) + "'>";
}

std::string bytes_text(std::string_view bytes) { return "b" + quoted_text(bytes); }

}  // namespace

namespace {

std::string written(const Value& value, NoText& problem) {
  switch (value.kind) {
  case Kind::none: return "None";
  case Kind::boolean: return value.boolean ? "True" : "False";
  case Kind::integer: return std::to_string(value.integer);
  case Kind::big: return value.big->to_text(problem.meter);
  case Kind::real: return float_text(value.real);
  case Kind::complex: return complex_text(*value.complex);
  case Kind::text: return quoted_text(*value.text);
  case Kind::bytes: return bytes_text(*value.text);
  case Kind::list: {
    const std::string items = "[" + joined(value.list->items, problem) + "]";
    const Type type = value.list->type;
    return type == Type::list ? items : std::string(name_of(type)) + "(" + items + ")";
  }
  case Kind::tuple:
    return "(" + joined(value.list->items, problem) + (value.list->items.size() == 1 ? ",)" : ")");
  case Kind::set: return set_text(*value.list, problem);
  case Kind::dict: return dict_text(*value.dict, problem);
  case Kind::range: return range_text(*value.range);
  case Kind::slice: {
    const Slice& slice = *value.slice;
    return "slice(" + joined({slice.begin, slice.end, slice.step}, problem) + ")";
  }
  case Kind::type: return type_text(value.type);
  case Kind::function:
    if (value.function->call != nullptr && value.function->self.kind == Kind::none) {
      return "<built-in function " + std::string(value.function->name) + ">";
    }
    break;
  case Kind::date: problem.reason = "Python writes it in another way; put it in quotes"; return {};
  default: break;
  }
  problem.reason = "Python prints an address for it, which differs from run to run";
  return {};
}

}  // namespace

std::string repr_of(const Value& value, NoText& problem) {
  constexpr std::uint64_t kStepsOfValue = 5;
  problem.meter.step(kStepsOfValue);
  std::string text = written(value, problem);
  problem.meter.scan(text.size());  // for each level of lists around it, too
  return text;
}

std::string text_of(const Value& value, NoText& problem) {
  constexpr std::size_t kDate = 10;  // "2020-01-31"
  const bool is_date = value.kind == Kind::date && value.text->size() == kDate;
  return value.is_text() || is_date ? *value.text : repr_of(value, problem);
}

}  // namespace smurf::xacro
