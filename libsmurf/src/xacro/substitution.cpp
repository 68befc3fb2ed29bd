// SPDX-License-Identifier: BSD-3-Clause
// `$(...)`: find, arg, env, optenv, eval, cwd.
#include <algorithm>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "xacro/expander.hpp"
#include "xacro/python_text.hpp"
#include "xacro/seen_arguments.hpp"

namespace smurf::xacro {
namespace {

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

/// The commands in a text, "find pkg" of "$(find pkg)/urdf"; none if the brackets are wrong.
std::optional<std::vector<std::string>> commands_in(std::string_view text) {
  enum class State : std::uint8_t { outside, dollar, bracket, inside };
  State state = State::outside;
  std::vector<std::string> commands;
  std::string inner;
  for (const char c : text) {
    if (c == '$') {
      if (state == State::bracket || state == State::inside) return std::nullopt;
      state = State::dollar;
    } else if (c == '(') {
      if (state == State::bracket || state == State::inside) return std::nullopt;
      if (state == State::dollar) state = State::bracket;
    } else if (c == ')') {
      if (state == State::inside) commands.push_back(std::exchange(inner, {}));
      state = State::outside;
    } else if (state == State::dollar) {
      state = State::outside;
    } else if (state == State::bracket) {
      state = State::inside;
    }
    if (state == State::inside) inner.push_back(c);
  }
  return commands;
}

}  // namespace

Value Expander::argument(const std::string& name) {
  const auto found = arguments_.find(name);
  if (found != arguments_.end()) {
    const OriginId origin = found->second.origin;
    if (origin != kComputed) evaluator_.use(found->first, origin);
    return heap_.text(found->second.text).at(origin);
  }
  std::vector<std::string_view> known;
  for (const auto& [one, value] : arguments_) known.push_back(one);
  const auto near = only_nearest(name, known);
  const Value fault = evaluator_.fail(rules::sml3313_xacro_unknown_argument,
                                      "the argument " + quoted(name) + " has no value here",
                                      near ? "did you mean " + quoted(*near) + "?" : "");
  evaluator_.failure().argument = name;
  return fault;
}

/// All arguments that will have no value, and the values that launch files give them.
void Expander::explain_arguments(const Failure& failure, Diagnostic& diagnostic) {
  std::vector<std::string> names{failure.argument};
  std::string others;
  constexpr std::size_t kMostNames = 20;
  for (const std::string& name : undeclared_arguments(context_.sources.text(result_.root))) {
    if (name == failure.argument || arguments_.contains(name)) continue;
    if (names.size() == kMostNames) {
      others += ", ...";
      break;
    }
    names.push_back(name);
    others += (others.empty() ? "" : ", ") + quoted(name);
  }
  if (!others.empty()) diagnostic.note("also without a value: " + others);
  constexpr std::size_t kMostSeen = 6;
  const auto seen = seen_arguments(context_.sources.path(result_.root), names, context_.files);
  std::string command;
  for (const std::string& name : names) {
    const auto first = std::find_if(seen.begin(), seen.end(),
                                    [&](const SeenArgument& one) { return one.name == name; });
    command +=
        (command.empty() ? "" : " ") + name + ":=" + (first == seen.end() ? "VALUE" : first->value);
  }
  for (std::size_t i = 0; i < std::min(seen.size(), kMostSeen); ++i) {
    diagnostic.note(quoted(seen[i].name) + " is `" + seen[i].value + "` in " +
                    quoted(seen[i].file));
  }
  if (failure.help.empty()) {
    diagnostic.help("give values after the file, or in `.smurf-lint.yaml`: `" + command + "`");
  }
}

Value Expander::environment(const std::string& name, const Value* fallback) {
  if (settings_.environment.contains(name)) {
    if (const char* value = std::getenv(name.c_str())) return heap_.text(value);
    if (fallback != nullptr) return *fallback;
    return evaluator_.fail(rules::sml3317_xacro_environment,
                           "the variable " + quoted(name) + " of the environment is not set",
                           "set it, or write `$(optenv " + name + " DEFAULT)`");
  }
  if (fallback != nullptr) return *fallback;
  return evaluator_.fail(rules::sml3317_xacro_environment,
                         "the variable " + quoted(name) + " of the environment may not be read",
                         "allow it with `--xacro-env " + name + "`");
}

Value Expander::find_package(const std::string& name) {
  const auto folder =
      settings_.find_package ? settings_.find_package(name, current_path()) : std::nullopt;
  if (!folder) {
    return evaluator_.fail(
        rules::sml3309_xacro_unknown_package, "there is no package " + quoted(name),
        "name its folder with `--package " + name + "=DIR`, or set ROS_PACKAGE_PATH");
  }
  const std::string absolute = settings_.absolute ? settings_.absolute(*folder) : *folder;
  package_folders_[absolute] = *folder;
  return heap_.text(absolute);
}

Value Expander::evaluate_eval(const std::string& expression) {
  if (expression.find("__") != std::string::npos) {
    return evaluator_.fail("`$(eval ...)` must not contain `__`");
  }
  if (eval_functions_ == nullptr) {
    eval_functions_ = &tables_.emplace_back(heap_.arena());
    add_eval_functions(*eval_functions_, heap_);
  }
  Table& names = tables_.emplace_back(*eval_functions_);
  for (const auto& [name, argument] : arguments_) {
    if (eval_functions_->own(name) != nullptr) continue;
    Value value = heap_.text(argument.text);
    const bool has_point = argument.text.find('.') != std::string::npos;
    const std::string lower = path::to_lower(argument.text);
    if (const auto real = has_point ? read_float(argument.text) : std::nullopt) {
      value = Value::of(*real);
    } else if (const auto whole = has_point ? std::nullopt : read_integer(argument.text, heap_)) {
      value = *whole;
    } else if (lower == "true" || lower == "false") {
      value = Value::of(lower == "true");
    }
    names.set(name, value);
  }
  const std::string_view code = heap_.keep(without_blanks(expression));
  const Value value = evaluator_.evaluate(code, names);
  if (value.is_failed()) {
    evaluator_.failure().begin = evaluator_.failure().end = 0;
    return value;
  }
  const std::string text = evaluator_.string_of(value);
  return evaluator_.has_failed() ? Value::failure() : evaluator_.text(text);
}

Value Expander::substitute_one(const std::string& command) {
  const std::vector<std::string> words = words_of(command);
  if (words.empty()) return evaluator_.fail(rules::sml3302_xacro_syntax, "`$( )` is empty");
  const std::string& name = words[0];
  if (!is_one_of(name, {"find", "env", "optenv", "dirname", "arg"})) {
    const bool is_anon = name == "anon";
    const bool is_eval = name == "eval";
    return evaluator_.fail(rules::sml3302_xacro_syntax, "xacro does not know `$(" + name + " ...)`",
                           is_anon   ? "`anon` exists in launch files and in ROS 1 only"
                           : is_eval ? "`$(eval ...)` must be the whole text"
                                     : "write `find`, `arg`, `env`, `optenv`, `eval` or `cwd`");
  }
  if (name == "dirname") {
    return evaluator_.fail(rules::sml3302_xacro_syntax, "`$(dirname)` always fails in xacro",
                           "write a path relative to this file, or `$(find PACKAGE)`");
  }
  if (words.size() < 2 || (words.size() > 2 && name != "optenv")) {
    return evaluator_.fail(rules::sml3302_xacro_syntax, "`$(" + name + " ...)` needs one name");
  }
  if (name == "find") return find_package(words[1]);
  if (name == "arg") return argument(words[1]);
  if (name == "env") return environment(words[1], nullptr);
  std::string fallback;
  for (std::size_t i = 2; i < words.size(); ++i) fallback += (i > 2 ? " " : "") + words[i];
  const Value value = heap_.text(fallback);
  return environment(words[1], &value);
}

std::optional<std::string> Expander::substitute_all(const std::string& text, bool only_find,
                                                    OriginId& origin) {
  const auto commands = commands_in(text);
  if (!commands) {
    evaluator_.fail(rules::sml3302_xacro_syntax, "`$` and `(` are not allowed inside of `$(...)`");
    return std::nullopt;
  }
  std::string result = text;
  for (const std::string& command : *commands) {
    const std::vector<std::string> words = words_of(command);
    const bool is_skipped = only_find && !words.empty() && words[0] != "find" &&
                            is_one_of(words[0], {"env", "optenv", "dirname", "arg"});
    if (is_skipped) continue;
    const Value value = substitute_one(command);
    if (value.is_failed()) return std::nullopt;
    const std::string shown = "$(" + command + ")";
    if (result == shown) origin = value.origin;
    for (std::size_t at = result.find(shown); at != std::string::npos;
         at = result.find(shown, at + value.text->size())) {
      result.replace(at, shown.size(), *value.text);
      if (result.size() > context_.limits.xacro_text_bytes) break;
    }
    evaluator_.step(10);
  }
  return result;
}

Value Expander::substitute(const std::string& inner) {
  if (inner == "cwd") {
    return heap_.text(settings_.absolute ? settings_.absolute(".") : ".");
  }
  const std::string whole = "$(" + inner + ")";
  if (inner.starts_with("eval ")) return evaluate_eval(inner.substr(5));
  OriginId origin = kComputed;
  const auto first = substitute_all(whole, false, origin);
  if (!first) return Value::failure();
  auto second = substitute_all(*first, true, origin);
  if (!second) return Value::failure();
  if (*second != *first) origin = kComputed;
  return evaluator_.text(*std::move(second)).at(origin);
}

}  // namespace smurf::xacro
