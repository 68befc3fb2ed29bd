// SPDX-License-Identifier: BSD-3-Clause
#include "link/surroundings/python_calls.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "base/text/words.hpp"
#include "link/surroundings/python_names.hpp"
#include "link/surroundings/python_tokens.hpp"

namespace smurf::python {
namespace {

Value text_of(std::string text, Span span) {
  Value value;
  value.kind = Value::Kind::text;
  value.span = span;
  value.pieces.push_back({Piece::Kind::literal, std::move(text), span});
  return value;
}

Value unknown(Span span) {
  Value value;
  value.span = span;
  return value;
}

/// What may stand in a text.
bool is_textual(const Value& value) { return value.is_text(); }

class Reader {
 public:
  Reader(std::string_view text, SourceId source) {
    Tokens read = tokens_of(text, source);
    tokens_ = std::move(read.tokens);
    file_.fault = std::move(read.fault);
    tokens_.emplace_back();
    tokens_.back().span = {source, static_cast<std::uint32_t>(text.size()),
                           static_cast<std::uint32_t>(text.size())};
    count_assignments();
    note_names(tokens_, file_);
  }

  File run() {
    while (peek().kind != Token::Kind::end) statement();
    return std::move(file_);
  }

 private:
  static constexpr int kDeepest = 60;

  const Token& peek(std::size_t ahead = 0) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
  }
  bool is(std::string_view sign) const {
    const Token& token = peek();
    return token.kind != Token::Kind::text && token.text == sign;
  }
  bool take(std::string_view sign) {
    if (!is(sign)) return false;
    ++at_;
    return true;
  }
  /// The tokens that were read since `begin`.
  std::span<const Token> tokens_from(std::size_t begin) const {
    return std::span(tokens_).subspan(begin, at_ - begin);
  }
  bool is_end() const {
    return peek().kind == Token::Kind::line || peek().kind == Token::Kind::end;
  }

  /// A name that is assigned more than once, or in a way that is not read, is unknown.
  void count_assignments() {
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      if (token.kind != Token::Kind::name) continue;
      const bool is_first = i == 0 || tokens_[i - 1].kind == Token::Kind::line;
      const std::string_view next = tokens_[i + 1].text;
      if (is_first && tokens_[i + 1].kind == Token::Kind::sign && next == "=") {
        ++assigned_[token.text];
      } else if (is_first && next.size() == 2 && next[1] == '=' && next != "==") {
        assigned_[token.text] += 2;
      } else if (i > 0 && (tokens_[i - 1].text == "for" || tokens_[i - 1].text == "as")) {
        assigned_[token.text] += tokens_[i - 1].text == "for" ? 2 : 1;
      }
    }
  }

  void statement() {
    if (peek().kind == Token::Kind::line) {
      ++at_;
      return;
    }
    const std::uint32_t column = peek().column;
    while (!blocks_.empty() && column <= blocks_.back()) blocks_.pop_back();
    const std::string_view word = peek().kind == Token::Kind::name ? peek().text : "";
    const bool is_branch = is_one_of(
        word, {"if", "elif", "else", "for", "while", "try", "except", "finally", "match", "case"});
    if (is_branch) blocks_.push_back(column);
    if (word == "for" || word == "while") file_.has_loops = true;
    if (is_one_of(word, {"import", "from", "def", "class", "pass", "global", "nonlocal", "del",
                         "break", "continue", "raise", "assert"})) {
      skip_line();
      return;
    }
    if (is_branch || is_one_of(word, {"return", "with", "yield", "await", "async"})) ++at_;
    if (!is_branch && word.empty() && is("@")) return skip_line();
    assignment_or_expression(word == "with");
    // What follows on the line is not read, but its calls are.
    while (!is_end()) {
      if (peek().kind == Token::Kind::name || is("(") || is("[") || is("{")) {
        const std::size_t before = at_;
        expression(0);
        if (at_ == before) ++at_;
      } else {
        ++at_;
      }
    }
  }

  void skip_line() {
    while (!is_end()) ++at_;
  }

  void assignment_or_expression(bool is_with) {
    if (is_end()) return;
    const bool is_assignment = peek().kind == Token::Kind::name &&
                               peek(1).kind == Token::Kind::sign && peek(1).text == "=";
    if (is_assignment) {
      const std::string_view name = peek().text;
      at_ += 2;
      bind(name, expression(0));
      return;
    }
    Value value = expression(0);
    if (is_with && take("as") && peek().kind == Token::Kind::name) {
      bind(peek().text, std::move(value));
      ++at_;
    }
  }

  void bind(std::string_view name, Value value) {
    if (assigned_[name] != 1 || !blocks_.empty()) return;
    file_.names.emplace_back(std::string(name), value);
    values_[name] = std::move(value);
  }

  /// An expression up to a comma or a closing bracket.
  Value expression(int depth) {
    if (depth > kDeepest) {
      skip_line();
      return {};
    }
    const Span begin = peek().span;
    if (take("*") || take("**")) {
      expression(depth + 1);
      return unknown(begin);
    }
    if (is("lambda")) return skip_part(begin);
    Value left = sum(depth);
    bool is_known = true;
    while (!is_end() && !is(",") && !is(")") && !is("]") && !is("}") && !is(":") && !is("=") &&
           !is("as")) {
      is_known = false;  // a comparison, a condition, a comprehension
      if (is("for")) file_.has_loops = true;
      const std::size_t before = at_;
      ++at_;
      if (!is_end() && !is(",") && !is(")") && !is("]") && !is("}")) sum(depth);
      if (at_ == before) ++at_;
    }
    return is_known ? std::move(left) : unknown(begin);
  }

  Value skip_part(Span begin) {
    int open = 0;
    while (!is_end()) {
      if (open == 0 && (is(",") || is(")") || is("]") || is("}"))) break;
      if (is("(") || is("[") || is("{")) ++open;
      if (is(")") || is("]") || is("}")) --open;
      ++at_;
    }
    return unknown(begin);
  }

  /// Texts with `+` and paths with `/` between them.
  Value sum(int depth) {
    const Span place = peek().span;
    Value left = operand(depth);
    while (is("+") || is("/") || is("%") || is("-") || is("*")) {
      const std::string_view sign = peek().text;
      ++at_;
      Value right = operand(depth);
      if (sign == "+" && is_textual(left) && is_textual(right)) {
        if (left.is_lazy || right.is_lazy) file_.bad_sums.push_back({place});
        left = join_texts({left, right}, "");
      } else if (sign == "+" && left.is_text()) {
        left = join_texts({left, right}, "");
      } else if (sign == "+" && right.is_text()) {
        left = join_texts({left, right}, "");
      } else if (sign == "/" && left.is_text() && (right.is_text() || !right.is_list())) {
        left = join_texts({left, right}, "/");
      } else if (sign == "+" && left.is_list() && right.is_list()) {
        left.items.insert(left.items.end(), right.items.begin(), right.items.end());
      } else {
        left = unknown(left.span);
      }
    }
    return left;
  }

  Value operand(int depth) {
    if (take("-") || take("+") || take("~") || take("not") || take("await")) {
      operand(depth + 1);
      return {};
    }
    Value value = atom(depth);
    is_member_ = false;
    while (true) {
      if (is("(")) {
        value = call(std::move(value), depth);
        is_member_ = true;
      } else if (is(".") && peek(1).kind == Token::Kind::name) {
        ++at_;
        member(value, peek().text);
        ++at_;
      } else if (is("[")) {
        ++at_;
        elements("]", depth);
        value = unknown(value.span);
      } else {
        return value;
      }
    }
  }

  /// `value.name`: the name of what is called, or a method of a value.
  void member(Value& value, std::string_view name) {
    method_of_.reset();
    if (value.kind == Value::Kind::unknown && !value.callee.empty()) {
      value.callee += "." + std::string(name);
    } else {
      method_of_ = value;
      value = unknown(value.span);
      value.callee = name;
      is_member_ = true;
    }
  }

  Value atom(int depth) {
    const Token& token = peek();
    Value value = unknown(token.span);
    if (is_end()) return value;
    ++at_;
    if (token.kind == Token::Kind::text) {
      value = text_of(token);
      while (peek().kind == Token::Kind::text) {
        value = join_texts({value, text_of(peek())}, "");
        ++at_;
      }
    } else if (token.kind == Token::Kind::name) {
      const auto known = values_.find(token.text);
      if (known != values_.end() && !(peek().kind == Token::Kind::sign && peek().text == "(")) {
        return known->second;
      }
      value.callee = token.text;
    } else if (token.kind == Token::Kind::sign && (token.text == "[" || token.text == "(")) {
      const bool is_list = token.text == "[";
      bool has_comma = false;
      const bool had_loops = file_.has_loops;
      file_.has_loops = false;
      value.items = elements(is_list ? "]" : ")", depth, &has_comma);
      const bool is_computed = file_.has_loops;
      file_.has_loops = had_loops || is_computed;
      if (!is_list && !has_comma && value.items.size() == 1) return std::move(value.items.front());
      value.kind = Value::Kind::list;
      if (is_computed) value = unknown(token.span);
    } else if (token.kind == Token::Kind::sign && token.text == "{") {
      value.kind = Value::Kind::mapping;
      while (!is("}") && !is_end()) {
        const std::size_t before = at_;
        Value key = expression(depth + 1);
        Value item = take(":") ? expression(depth + 1) : Value{};
        value.items.push_back(std::move(key));
        value.items.push_back(std::move(item));
        if (!take(",") && at_ == before) ++at_;
      }
      take("}");
    }
    return value;
  }

  /// The text of a token. Of an expression in braces, only a name that is known is replaced, and
  /// `name.perform(context)` of a launch argument.
  Value text_of(const Token& token) const {
    if (!token.is_format) return python::text_of(token.value, token.span);
    std::vector<Value> parts;
    std::string_view rest = token.value;
    while (!rest.empty()) {
      const std::size_t open = rest.find('{');
      if (open > 0) parts.push_back(python::text_of(std::string(rest.substr(0, open)), token.span));
      if (open == std::string_view::npos) break;
      const std::size_t close = rest.find('}', open);
      std::string_view name = rest.substr(open + 1, close - open - 1);
      if (name.ends_with(".perform(context)")) name = name.substr(0, name.find('.'));
      const auto known = close == std::string_view::npos ? values_.end() : values_.find(name);
      parts.push_back(known != values_.end() && known->second.is_text() ? known->second
                                                                        : unknown(token.span));
      rest.remove_prefix(close == std::string_view::npos ? rest.size() : close + 1);
    }
    Value text = join_texts(parts, "");
    text.span = token.span;
    return text;
  }

  std::vector<Value> elements(std::string_view close, int depth, bool* has_comma = nullptr) {
    std::vector<Value> items;
    while (!is(close) && !is_end()) {
      const std::size_t before = at_;
      items.push_back(expression(depth + 1));
      if (take(",")) {
        if (has_comma != nullptr) *has_comma = true;
      } else if (at_ == before || is(":") || is("=")) {
        ++at_;
      }
    }
    take(close);
    return items;
  }

  Value call(Value callee, int depth) {
    std::optional<Value> object = std::move(method_of_);
    method_of_.reset();
    Value value;
    value.kind = Value::Kind::call;
    value.span = callee.span;
    value.callee = callee.callee;
    value.is_conditional = !blocks_.empty();
    take("(");
    WrittenCall written;
    written.callee = is_member_ ? std::string() : callee.callee;
    written.span = callee.span;
    while (!is(")") && !is_end()) {
      const std::size_t before = at_;
      if (is("*") || is("**")) written.has_star = true;
      const bool is_named = peek().kind == Token::Kind::name && peek(1).kind == Token::Kind::sign &&
                            peek(1).text == "=";
      if (is_named) {
        const std::string name(peek().text);
        const Span name_span = peek().span;
        at_ += 2;
        const std::size_t begin = at_;
        value.named.push_back({name, expression(depth + 1)});
        written.arguments.push_back(argument_of(value.named.back().value, tokens_from(begin)));
        written.arguments.back().name = name;
        written.arguments.back().name_span = name_span;
      } else {
        value.items.push_back(expression(depth + 1));
        written.arguments.push_back(argument_of(value.items.back(), tokens_from(before)));
        if (is("for")) written.has_star = true;
      }
      if (!take(",") && at_ == before) ++at_;
    }
    take(")");
    if (!written.callee.empty()) file_.written.push_back(std::move(written));
    return finish(std::move(value), std::move(object));
  }

  /// The value of a call that makes a text; others are kept as calls.
  Value finish(Value value, std::optional<Value> object) {
    const std::size_t dot = value.callee.rfind('.');
    const std::string last = value.callee.substr(dot == std::string::npos ? 0 : dot + 1);
    const Value* first = value.items.empty() ? nullptr : &value.items.front();
    if (object) {
      const bool is_same = is_one_of(last, {"as_posix", "perform", "resolve", "strip", "items"});
      if (is_same) {
        object->is_lazy = object->is_lazy && last != "perform";
        return std::move(*object);
      }
      if (object->is_text() && is_one_of(last, {"joinpath"})) {
        std::vector<Value> parts{*object};
        parts.insert(parts.end(), value.items.begin(), value.items.end());
        return join_texts(parts, "/");
      }
      if (object->kind == Value::Kind::call) {
        value.callee = object->callee + "." + last;
        value.items.insert(value.items.begin(), object->items.begin(), object->items.end());
        value.named.insert(value.named.end(), object->named.begin(), object->named.end());
        value.span = object->span;
        file_.calls.push_back(value);
        return value;
      }
      if (object->is_text() && last == "read_text") {  // of a Path
        value.callee = "open.read";
        value.span = object->pieces.back().span;
        value.items = {std::move(*object)};
        file_.calls.push_back(value);
        return value;
      }
      if (object->is_text()) return unknown(object->span);  // format, replace, ...
    }
    if (is_one_of(last,
                  {"get_package_share_directory", "get_package_share_path", "FindPackageShare"})) {
      const Value* name = first != nullptr ? first : value.find("package");
      const std::string* package = name != nullptr ? name->literal() : nullptr;
      Value share = unknown(value.span);
      share.kind = Value::Kind::text;
      share.is_lazy = last == "FindPackageShare";
      share.pieces.push_back({package != nullptr ? Piece::Kind::share : Piece::Kind::unknown,
                              package != nullptr ? *package : "",
                              name != nullptr ? name->span : value.span});
      return share;
    }
    if (is_one_of(value.callee, {"os.path.join", "path.join", "join", "osp.join"})) {
      return join_texts(value.items, "/");
    }
    if (last == "PathJoinSubstitution" || last == "PathSubstitution") {
      std::vector<Value> parts = first != nullptr && first->is_list() ? first->items : value.items;
      for (Value& part : parts) {
        if (part.is_list()) part = join_texts(part.items, "");
      }
      Value joined = join_texts(parts, "/");
      joined.is_lazy = true;
      return joined;
    }
    if (is_one_of(last, {"str", "Path", "PurePath", "abspath", "normpath", "realpath"})) {
      Value same = first != nullptr ? *first : unknown(value.span);
      same.is_lazy = false;
      return same;
    }
    if (last == "TextSubstitution") {
      Value text = value.find("text") != nullptr ? *value.find("text") : unknown(value.span);
      text.is_lazy = true;
      return text;
    }
    if (last == "LaunchConfiguration") {
      const Value* name = first != nullptr ? first : value.find("variable_name");
      Value argument = unknown(value.span);
      argument.kind = Value::Kind::text;
      const std::string* text = name != nullptr ? name->literal() : nullptr;
      argument.pieces.push_back({text != nullptr ? Piece::Kind::argument : Piece::Kind::unknown,
                                 text != nullptr ? *text : "", value.span});
      argument.is_lazy = true;
      return argument;
    }
    value.is_lazy = is_one_of(last, {"Command", "FindExecutable", "ThisLaunchFileDir",
                                     "EnvironmentVariable", "PythonExpression"});
    value.callee = last == "read" || value.callee.starts_with("xacro") ? value.callee : last;
    file_.calls.push_back(value);
    return value;
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::map<std::string_view, int> assigned_;
  std::map<std::string_view, Value> values_;
  std::vector<std::uint32_t> blocks_;  ///< columns of the `if` and loops around the statement
  bool is_member_ = false;             ///< what is read is a part of a value, no name
  std::optional<Value> method_of_;     ///< the object of the method that is called next
  File file_;
};

}  // namespace

File read_file(std::string_view text, SourceId source) { return Reader(text, source).run(); }

}  // namespace smurf::python
