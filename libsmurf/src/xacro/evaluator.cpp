// SPDX-License-Identifier: BSD-3-Clause
#include "xacro/evaluator.hpp"

#include <algorithm>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/utf8.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {

Value Evaluator::fail(const Rule& rule, std::string message, std::string help) {
  if (failure_.rule == nullptr) {
    failure_.rule = &rule;
    failure_.message = std::move(message);
    failure_.help = std::move(help);
  }
  return Value::failure();
}

Value Evaluator::fail(std::string message) {
  return fail(rules::sml3303_xacro_computation, std::move(message));
}

Value Evaluator::fail_unsupported(const std::string& what) {
  return fail(rules::sml3304_xacro_unsupported, what + " is not supported");
}

Value Evaluator::fail_exhausted() {
  if (meter_.reason() == Meter::Reason::steps) {
    return fail(rules::sml3312_xacro_limit,
                "the expansion needs more than " + std::to_string(meter_.most_steps()) + " steps",
                raise_limit("xacro-steps"));
  }
  return fail(rules::sml3312_xacro_limit,
              "the values need more than " + std::to_string(meter_.most_bytes()) +
                  " bytes, or are nested too deeply",
              raise_limit("xacro-bytes"));
}

Value Evaluator::text(std::string text) {
  if (text.size() > limits_.xacro_text_bytes) {
    return fail(rules::sml3312_xacro_limit,
                "the text has more than " + std::to_string(limits_.xacro_text_bytes) + " bytes",
                raise_limit("xacro-text-bytes"));
  }
  meter_.copy(text.size());
  return heap_.text(std::move(text));
}

Value Evaluator::list(std::vector<Value> items, Kind kind) {
  if (items.size() > limits_.xacro_items) {
    return fail(rules::sml3312_xacro_limit,
                "the list has more than " + std::to_string(limits_.xacro_items) + " items",
                raise_limit("xacro-items"));
  }
  return heap_.list(std::move(items), kind);
}

Value Evaluator::integer(BigInt value) {
  if (value.bits() > limits_.xacro_integer_bits) {
    return fail(rules::sml3312_xacro_limit,
                "the integer has more than " + std::to_string(limits_.xacro_integer_bits) + " bits",
                raise_limit("xacro-integer-bits"));
  }
  meter_.copy(value.bytes());
  return heap_.integer(std::move(value));
}

std::string Evaluator::string_of(const Value& value) {
  if (!value.is_text()) return written(value, text_of);
  meter_.copy(value.text->size());
  return *value.text;
}

std::string Evaluator::repr(const Value& value) { return written(value, repr_of); }

std::string Evaluator::written(const Value& value, std::string (*write)(const Value&, NoText&)) {
  NoText problem{meter_, {}, limits_.xacro_text_bytes};
  std::string result = write(value, problem);
  if (result.size() > problem.most) {
    text(std::move(result));  // fails
    return {};
  }
  if (!problem.reason.empty()) {
    fail("the text of " + std::string(kind_name(value)) + " is unknown: " + problem.reason);
  }
  return result;
}

Value Evaluator::wrapped(const Value& value) {
  Value result = value;
  if (value.kind == Kind::dict) result.is_wrapped = true;
  if (value.kind == Kind::list) {
    result = heap_.list(value.list->items).at(value.origin);
    result.list->is_wrapped = true;
  }
  return result;
}

bool Evaluator::items_of(const Value& value, std::vector<Value>& items) {
  meter_.step(value.kind == Kind::text   ? value.text->size()
              : value.kind == Kind::dict ? value.dict->items.size()
                                         : 0);
  switch (value.kind) {
  case Kind::list:
  case Kind::tuple:
  case Kind::set:
    meter_.step(value.list->items.size());
    items = value.list->items;
    if (value.list->is_wrapped) {
      for (Value& item : items) item = wrapped(item);
    }
    break;
  case Kind::iterator:
    meter_.step(value.list->items.size() - value.list->next);
    items.assign(value.list->items.begin() + static_cast<std::ptrdiff_t>(value.list->next),
                 value.list->items.end());
    value.list->next = value.list->items.size();
    break;
  case Kind::dict:
    for (const auto& [key, member] : value.dict->items) items.push_back(key);
    break;
  case Kind::text:
    for (std::string_view rest = *value.text; !rest.empty();) {
      const std::size_t size = utf8::decode(rest).size;
      items.push_back(heap_.text(std::string(rest.substr(0, size))));
      rest.remove_prefix(size);
    }
    break;
  case Kind::range:
    if (value.range->size() > static_cast<std::int64_t>(limits_.xacro_items)) {
      list(std::vector<Value>(limits_.xacro_items + 1));
      return false;
    }
    meter_.step(static_cast<std::uint64_t>(value.range->size()));
    for (std::int64_t i = 0; i < value.range->size(); ++i) {
      items.push_back(Value::of(value.range->begin + i * value.range->step));
    }
    break;
  default: fail(std::string(kind_name(value)) + " has no items to visit"); return false;
  }
  return true;
}

Value Evaluator::evaluate(std::string_view text, Table& table) {
  try {
    return evaluate_text(text, table);
  } catch (const Exhausted&) {
    return fail_exhausted();
  }
}

Value Evaluator::evaluate_text(std::string_view text, Table& table) {
  meter_.copy(text.size());
  const Expression& expression = expressions_.parse(text);
  if (expression.root == nullptr) {
    const SyntaxFault& fault = *expression.fault;
    if (failure_.rule == nullptr) {
      failure_.rule = fault.rule;
      failure_.message = fault.message;
      failure_.help = fault.help;
      failure_.begin = fault.begin;
      failure_.end = fault.end;
    }
    return Value::failure();
  }
  return evaluate(*expression.root, {&table, nullptr});
}

Value Evaluator::name(const Syntax& syntax, const Scope& scope, bool is_called) {
  const std::string_view name = syntax.text;
  meter_.scan(name.size());
  if (scope.locals != nullptr) {
    if (const Value* local = scope.locals->find(name, meter_)) return *local;
  }
  if (name.starts_with("__")) return fail("names that begin with `__` are not allowed");
  if (const Table::Found found = scope.table->find(name)) {
    meter_.step(found.levels / 8);
    Value value = found.entry->value;
    if (found.entry->is_unevaluated) value = host_.resolve(*found.table, *found.entry, name);
    if (value.origin != kComputed && !value.is_failed()) use(name, value.origin);
    return value;
  }
  std::uint64_t comparisons = 100'000;
  const auto nearest_of = [&](bool with_functions) {
    std::vector<std::string_view> known;
    scope.table->append_names(known, with_functions);
    std::sort(known.begin(), known.end());
    // Each call of a macro has its own parameters of the same names.
    known.erase(std::unique(known.begin(), known.end()), known.end());
    return only_nearest(name, known, comparisons);
  };
  auto near = nearest_of(false);
  if (!near && is_called) near = nearest_of(true);
  constexpr std::string_view kHidden[] = {"abs",       "all",        "any",    "sum",     "zip",
                                          "enumerate", "isinstance", "tuple",  "set",     "ord",
                                          "repr",      "type",       "divmod", "reversed"};
  std::string help = near ? "did you mean " + quoted(*near) + "?" : "";
  if (std::find(std::begin(kHidden), std::end(kHidden), name) != std::end(kHidden)) {
    help = "write `python." + std::string(name) + "`";
  }
  return fail(rules::sml3301_xacro_unknown_name, "there is no property or function " + quoted(name),
              std::move(help));
}

Value Evaluator::compare_chain(const Syntax& syntax, const Scope& scope) {
  Value left = evaluate(*syntax.parts[0], scope);
  Value result = Value::of(true);
  for (std::size_t i = 0; i < syntax.operations.size(); ++i) {
    if (left.is_failed()) return left;
    const Value right = evaluate(*syntax.parts[i + 1], scope);
    if (right.is_failed()) return right;
    remark_on(syntax, i, left, right);
    result = compare_values(*this, syntax.operations[i], left, right);
    if (result.is_failed() || !is_true(result)) return result;
    left = right;
  }
  return result;
}

bool Evaluator::bind(const Syntax& target, const Value& value, Locals& locals) {
  if (target.kind == SyntaxKind::name) {
    locals.names.emplace_back(target.text, value);
    return true;
  }
  std::vector<Value> items;
  if (!items_of(value, items)) return false;
  if (items.size() != target.parts.size()) {
    fail("there are " + std::to_string(items.size()) + " values for " +
         std::to_string(target.parts.size()) + " names");
    return false;
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!bind(*target.parts[i], items[i], locals)) return false;
  }
  return true;
}

bool Evaluator::run_clauses(const Syntax& syntax, std::size_t index, const Scope& scope,
                            Locals& locals, std::vector<Value>& items) {
  if (index == syntax.clauses.size()) {
    items.push_back(evaluate(*syntax.parts[0], {scope.table, &locals}));
    meter_.step();
    if (items.back().is_failed()) return false;
    if (items.size() > limits_.xacro_items) list(items);
    return !has_failed();
  }
  const Syntax::Clause& clause = syntax.clauses[index];
  // The first list is looked up where the comprehension stands, all others inside of it.
  const Scope outside = index == 0 ? scope : Scope{scope.table, &locals};
  const Value all = evaluate(*clause.iterable, outside);
  std::vector<Value> values;
  if (all.is_failed() || !items_of(all, values)) return false;
  const Borrowed borrowed(meter_, values.capacity() * sizeof(Value));
  const std::size_t before = locals.names.size();
  for (const Value& value : values) {
    locals.names.resize(before);
    if (!bind(*clause.target, value, locals)) return false;
    bool is_wanted = true;
    for (const Syntax* condition : clause.conditions) {
      const Value holds = evaluate(*condition, {scope.table, &locals});
      if (holds.is_failed()) return false;
      is_wanted = is_wanted && is_true(holds);
      if (!is_wanted) break;
    }
    if (is_wanted && !run_clauses(syntax, index + 1, scope, locals, items)) return false;
  }
  return true;
}

Value Evaluator::comprehension(const Syntax& syntax, const Scope& scope) {
  Locals own;
  Locals& locals = syntax.has_lambda ? kept_locals() : own;
  locals.outer = scope.locals;
  std::vector<Value> items;
  if (!run_clauses(syntax, 0, scope, locals, items)) return Value::failure();
  return syntax.is_generator ? heap_.iterator(std::move(items), Type::other)
                             : list(std::move(items));
}

namespace {

/// Where a failure happened, unless an inner part has said so.
struct FailurePlace {
  Evaluator& evaluator;
  const Syntax& syntax;
  bool had_failed;
  ~FailurePlace() {
    Failure& failure = evaluator.failure();
    const bool fails = failure.rule != nullptr || evaluator.meter().is_exhausted();
    if (had_failed || !fails || failure.end != 0 || !failure.span.empty()) return;
    failure.begin = syntax.begin;
    failure.end = syntax.end;
  }
};

}  // namespace

Value Evaluator::evaluate(const Syntax& syntax, const Scope& scope) {
  constexpr int kDeepest = 3000;
  const FailurePlace place{*this, syntax, has_failed()};
  meter_.step();
  struct Level {
    int& depth;
    ~Level() { --depth; }
  } level{++depth_};
  if (depth_ > kDeepest) {
    return fail(rules::sml3312_xacro_limit, "the expressions are nested too deeply");
  }
  const auto part = [&](std::size_t i) { return evaluate(*syntax.parts[i], scope); };
  switch (syntax.kind) {
  case SyntaxKind::name: return name(syntax, scope);
  case SyntaxKind::constant: return syntax.value;
  case SyntaxKind::tuple: return parts_of(syntax, scope, Kind::tuple);
  case SyntaxKind::list: return parts_of(syntax, scope, Kind::list);
  case SyntaxKind::star: return fail("`*` is allowed in lists and tuples only");
  case SyntaxKind::comprehension: return comprehension(syntax, scope);
  case SyntaxKind::unary: {
    const Value value = part(0);
    return value.is_failed() ? value : compute(*this, syntax.operation, value);
  }
  case SyntaxKind::binary: {
    const Value left = part(0);
    if (left.is_failed()) return left;
    const Value right = part(1);
    return right.is_failed() ? right : compute(*this, syntax.operation, left, right);
  }
  case SyntaxKind::compare: return compare_chain(syntax, scope);
  case SyntaxKind::logical_and:
  case SyntaxKind::logical_or: {
    const bool wanted = syntax.kind == SyntaxKind::logical_or;
    Value value;
    for (const Syntax* one : syntax.parts) {
      value = evaluate(*one, scope);
      if (value.is_failed() || is_true(value) == wanted) break;
    }
    return value;
  }
  case SyntaxKind::logical_not: {
    const Value value = part(0);
    return value.is_failed() ? value : Value::of(!is_true(value));
  }
  case SyntaxKind::conditional: {
    const Value condition = part(1);
    return condition.is_failed() ? condition : part(is_true(condition) ? 0 : 2);
  }
  case SyntaxKind::call: return call_syntax(syntax, scope);
  case SyntaxKind::attribute: {
    if (scope.locals == nullptr && syntax.text.starts_with("__")) {
      return fail("names that begin with `__` are not allowed");
    }
    const Value value = part(0);
    return value.is_failed() ? value : attribute_of(*this, value, syntax.text);
  }
  case SyntaxKind::subscript: {
    const Value value = part(0);
    if (value.is_failed()) return value;
    const Value index = part(1);
    return index.is_failed() ? index : subscript_of(*this, value, index);
  }
  case SyntaxKind::slice: {
    Value ends[3];
    for (std::size_t i = 0; i < 3; ++i) {
      if (syntax.parts[i] != nullptr) ends[i] = part(i);
      if (ends[i].is_failed()) return ends[i];
    }
    return heap_.slice({ends[0], ends[1], ends[2]});
  }
  case SyntaxKind::lambda: {
    Function function;
    function.lambda = &syntax;
    function.self.kind = Kind::name_space;
    function.self.table = scope.table;
    function.captured = scope.locals;
    if (syntax.parts.size() > 1) {
      Locals& captured = kept_locals();
      captured.outer = scope.locals;
      for (std::size_t i = 1; i < syntax.parts.size(); ++i) {
        const Value value = part(i);
        if (value.is_failed()) return value;
        captured.defaults.push_back(value);
      }
      function.captured = &captured;
    }
    return heap_.function(function);
  }
  case SyntaxKind::assign: {
    const Value value = part(0);
    if (value.is_failed()) return value;
    if (scope.locals != nullptr) return fail_unsupported("`:=` inside of a comprehension");
    host_.assign(*scope.table, syntax.text, value);
    return value;
  }
  }
  return Value::failure();
}

}  // namespace smurf::xacro
