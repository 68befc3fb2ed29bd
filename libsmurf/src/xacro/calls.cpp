// SPDX-License-Identifier: BSD-3-Clause
// Calls of functions, types and lambdas, and their parameters.
#include <algorithm>
#include <set>

#include "base/text/quoted.hpp"
#include "xacro/evaluator.hpp"

namespace smurf::xacro {

const Value* Call::take(std::size_t position, std::string_view keyword) {
  if (position < values.size()) return &values[position];
  if (keyword.empty()) return nullptr;
  const auto found = std::find_if(keywords.begin(), keywords.end(),
                                  [&](const auto& one) { return one.first == keyword; });
  if (found == keywords.end()) return nullptr;
  found->first = {};
  return &found->second;
}

bool Call::has_count(std::size_t least, std::size_t most) {
  for (const auto& [keyword, value] : keywords) {
    if (keyword.empty()) continue;  // taken
    evaluator.fail("`" + std::string(name) + "()` has no parameter " + quoted(keyword));
    return false;
  }
  const std::size_t given = values.size() + keywords.size();
  if (given >= least && given <= most) return true;
  const std::string wanted =
      least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
  evaluator.fail("`" + std::string(name) + "()` needs " + wanted + " parameters, and has " +
                 std::to_string(given));
  return false;
}

Value Evaluator::call(const Value& function, std::vector<Value> values,
                      std::vector<std::pair<std::string_view, Value>> keywords) {
  meter_.step(10);
  if (function.kind == Kind::type) {
    Call call{*this, name_of(function.type), {}, std::move(values), std::move(keywords)};
    return call_type(*this, function.type, call);
  }
  if (function.kind != Kind::function) {
    return fail(std::string(kind_name(function)) + " cannot be called");
  }
  const Function& called = *function.function;
  Call call{*this, called.name, called.self, std::move(values), std::move(keywords)};
  return called.lambda != nullptr ? call_lambda(called, call) : called.call(call);
}

Locals& Evaluator::kept_locals() {
  heap_.charge(sizeof(Locals) + 4 * sizeof(Value));
  return captured_.emplace_back();
}

Value Evaluator::call_lambda(const Function& function, const Call& call) {
  const Syntax& lambda = *function.lambda;
  const std::size_t count = lambda.names.size();
  const std::size_t needed = count - (lambda.parts.size() - 1);
  meter_.step(count * (1 + call.keywords.size() / 8));
  Locals own;
  Locals& locals = lambda.parts[0]->has_lambda ? kept_locals() : own;
  locals.outer = function.captured;
  std::size_t named = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view name = lambda.names[i];
    const auto keyword = std::find_if(call.keywords.begin(), call.keywords.end(),
                                      [&](const auto& one) { return one.first == name; });
    const bool has_keyword = keyword != call.keywords.end();
    const bool has_value = i < call.count();
    if (has_keyword == has_value && (has_value || i < needed)) {
      return fail("the lambda needs " + quoted(name) + " once");
    }
    named += has_keyword ? 1 : 0;
    locals.names.emplace_back(name, has_value     ? call.values[i]
                                    : has_keyword ? keyword->second
                                                  : function.captured->defaults[i - needed]);
  }
  if (call.count() > count || named != call.keywords.size()) {
    return fail("the lambda needs " + std::to_string(count) + " parameters");
  }
  // It may be written in another expression.
  const std::optional<Span> outer = std::exchange(code_place_, std::nullopt);
  const Value value = evaluate(*lambda.parts[0], {function.self.table, &locals});
  code_place_ = outer;
  return value;
}

Value Evaluator::call_syntax(const Syntax& syntax, const Scope& scope) {
  const Syntax& callee = *syntax.parts[0];
  const Value function =
      callee.kind == SyntaxKind::name ? name(callee, scope, true) : evaluate(callee, scope);
  if (function.is_failed()) return function;
  std::vector<Value> values;
  std::vector<std::pair<std::string_view, Value>> keywords;
  std::set<std::string_view> known;  // once a dictionary gives names
  for (std::size_t i = 0; i < syntax.names.size(); ++i) {
    const Value value = evaluate(*syntax.parts[i + 1], scope);
    if (value.is_failed()) return value;
    if (syntax.names[i].empty()) {
      values.push_back(value);
    } else if (syntax.names[i] == "*") {
      std::vector<Value> items;
      if (!items_of(value, items)) return Value::failure();
      values.insert(values.end(), items.begin(), items.end());
    } else if (syntax.names[i] == "**") {
      if (value.kind != Kind::dict) return fail("`**` needs a dictionary");
      for (const auto& one : keywords) known.insert(one.first);
      for (const auto& [key, member] : value.dict->items) {
        const std::string_view text = key.is_text() ? *key.text : std::string_view();
        meter_.step(2 + text.size() / 8);
        if (text.empty() || !known.insert(text).second)
          return fail("`**` needs keys that are texts, and each of them once");
        keywords.emplace_back(text, member);
      }
    } else {
      keywords.emplace_back(syntax.names[i], value);
    }
  }
  remark_on_call(syntax);
  return call(function, std::move(values), std::move(keywords));
}

}  // namespace smurf::xacro
