// SPDX-License-Identifier: BSD-3-Clause
// The parser of expressions: recursive descent, one function for each level of precedence.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/findings/rules.hpp"
#include "xacro/syntax.hpp"
#include "xacro/tokens.hpp"

namespace smurf::xacro {

class Parser {
 public:
  Parser(Expressions& expressions, std::string_view text, SyntaxFault& fault)
      : expressions_(expressions), fault_(fault), tokens_(expressions.tokens_) {
    split_tokens(text, expressions.heap_, fault, expressions.tokens_);
  }

  const Syntax* run() {
    if (tokens_.empty()) return nullptr;
    if (tokens_.size() == 1) {
      fail("the expression is empty");
      return nullptr;
    }
    const Syntax* root = tuple_or_one();
    if (fault_.rule == nullptr && peek().kind != Token::Kind::end) unexpected();
    return fault_.rule == nullptr ? root : nullptr;
  }

 private:
  static constexpr std::uint16_t kDeepest = 500;  // levels of a tree

  const Token& peek(std::size_t ahead = 0) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
  }
  bool accept(std::string_view mark) {
    if (!peek().is(mark)) return false;
    ++at_;
    return true;
  }
  bool expect(std::string_view mark) {
    if (accept(mark)) return true;
    fail("`" + std::string(mark) + "` is missing here");
    return false;
  }
  void fail(std::string message) {
    if (fault_.rule != nullptr) return;
    fault_.rule = &rules::sml3302_xacro_syntax;
    fault_.begin = peek().begin;
    fault_.end = peek().end;
    fault_.message = std::move(message);
  }
  void unexpected() {
    const Token& token = peek();
    if (token.kind == Token::Kind::end) return fail("the expression ends too early");
    fail("`" + std::string(token.text) + "` does not belong here");
  }
  const Syntax* unsupported(std::string_view what) {
    fail(std::string(what) + " is not supported");
    fault_.rule = &rules::sml3304_xacro_unsupported;
    return nullptr;
  }

  using Parts = std::span<const Syntax* const>;

  Syntax& make(SyntaxKind kind, std::uint32_t begin, Parts parts) {
    Syntax& node = expressions_.heap_.arena().make<Syntax>();
    node.kind = kind;
    node.begin = begin;
    node.end = at_ == 0 ? 0 : tokens_[at_ - 1].end;
    node.parts = keep(parts);
    node.has_lambda = kind == SyntaxKind::lambda;
    for (const Syntax* part : node.parts) deepen(node, part);
    return node;
  }
  Syntax& make(SyntaxKind kind, std::uint32_t begin, std::initializer_list<const Syntax*> parts) {
    return make(kind, begin, Parts(parts.begin(), parts.size()));
  }
  template <class T>
  std::span<const T> keep(std::span<const T> values) {
    return values.empty() ? values : expressions_.heap_.arena().keep(values);
  }
  void deepen(Syntax& node, const Syntax* part) {
    if (part == nullptr) return;
    node.has_lambda = node.has_lambda || part->has_lambda;
    node.depth = std::max(node.depth, static_cast<std::uint16_t>(part->depth + 1));
    if (node.depth > kDeepest) fail("the expression is nested too deeply");
  }

  /// `1, 2` without brackets.
  const Syntax* tuple_or_one() {
    const std::uint32_t begin = peek().begin;
    const Syntax* first = starred_or_test();
    if (first == nullptr || !peek().is(",")) return first;
    std::vector<const Syntax*> items{first};
    while (accept(",")) {
      if (ends_list()) break;
      items.push_back(starred_or_test());
      if (items.back() == nullptr) return nullptr;
    }
    return &make(SyntaxKind::tuple, begin, items);
  }
  bool ends_list() const {
    return peek().kind == Token::Kind::end || peek().is(")") || peek().is("]") || peek().is("=");
  }

  const Syntax* starred_or_test() {
    if (!peek().is("*")) return test();
    const std::uint32_t begin = peek().begin;
    ++at_;
    const Syntax* items = binary(0);
    return items == nullptr ? nullptr : &make(SyntaxKind::star, begin, {items});
  }

  /// `(x := 1)` is allowed in brackets only.
  const Syntax* named_test() {
    if (peek().kind == Token::Kind::name && peek(1).is(":=")) {
      const Token& name = peek();
      at_ += 2;
      const Syntax* value = test();
      if (value == nullptr) return nullptr;
      Syntax& node = make(SyntaxKind::assign, name.begin, {value});
      node.text = name.text;
      return &node;
    }
    return starred_or_test();
  }

  struct Level {
    explicit Level(int& of) : depth(of) { ++depth; }
    ~Level() { --depth; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    int& depth;
  };

  /// Most operands are a name or a constant and nothing else: no level of precedence has work.
  bool is_alone() const {
    const Token::Kind kind = peek().kind;
    if (kind == Token::Kind::keyword || kind == Token::Kind::mark) return false;
    const Token& next = peek(1);
    if (next.kind == Token::Kind::end) return true;
    return next.kind == Token::Kind::mark && (next.text == ")" || next.text == "]");
  }

  const Syntax* test() {
    const Level level(depth_);
    if (depth_ > kDeepest) {
      fail("the expression is nested too deeply");
      return nullptr;
    }
    if (is_alone()) return atom();
    if (peek().is("lambda")) return lambda();
    const std::uint32_t begin = peek().begin;
    const Syntax* value = disjunction();
    if (value == nullptr || !accept("if")) return value;
    const Syntax* condition = disjunction();
    if (condition == nullptr) return nullptr;
    if (!accept("else")) {
      fail("`else` is missing here: a value for the other case");
      return nullptr;
    }
    const Syntax* other = test();
    if (other == nullptr) return nullptr;
    return &make(SyntaxKind::conditional, begin, {value, condition, other});
  }

  const Syntax* lambda() {
    const std::uint32_t begin = peek().begin;
    ++at_;
    std::vector<std::string_view> names;
    std::vector<const Syntax*> defaults;
    while (peek().kind == Token::Kind::name) {
      names.push_back(peek().text);
      ++at_;
      if (accept("=")) {
        defaults.push_back(test());
        if (defaults.back() == nullptr) return nullptr;
      } else if (!defaults.empty()) {
        fail("a parameter without a default follows one with a default");
        return nullptr;
      }
      if (!accept(",")) break;
    }
    if (peek().is("*") || peek().is("**")) return unsupported("`*` in a lambda");
    if (!expect(":")) return nullptr;
    const Syntax* body = test();
    if (body == nullptr) return nullptr;
    defaults.insert(defaults.begin(), body);
    Syntax& node = make(SyntaxKind::lambda, begin, defaults);
    node.names = keep(std::span<const std::string_view>(names));
    return &node;
  }

  using Inner = const Syntax* (Parser::*)();

  const Syntax* chain(std::string_view word, SyntaxKind kind, Inner inner) {
    const std::uint32_t begin = peek().begin;
    const Syntax* first = (this->*inner)();
    if (first == nullptr || !peek().is(word)) return first;
    std::vector<const Syntax*> parts{first};
    while (accept(word)) {
      parts.push_back((this->*inner)());
      if (parts.back() == nullptr) return nullptr;
    }
    return &make(kind, begin, parts);
  }
  const Syntax* disjunction() { return chain("or", SyntaxKind::logical_or, &Parser::conjunction); }
  const Syntax* conjunction() { return chain("and", SyntaxKind::logical_and, &Parser::negation); }
  const Syntax* negation() {
    if (!peek().is("not")) return comparison();
    const std::uint32_t begin = peek().begin;
    std::size_t count = 0;
    while (accept("not")) ++count;
    const Syntax* value = comparison();
    for (; value != nullptr && count > 0 && fault_.rule == nullptr; --count) {
      value = &make(SyntaxKind::logical_not, begin, {value});
    }
    return value;
  }

  bool accept_comparison(Operation& operation) {
    if (peek().kind != Token::Kind::mark && peek().kind != Token::Kind::keyword) return false;
    struct Row {
      std::string_view mark;
      Operation operation;
    };
    constexpr Row kRows[] = {{"<", Operation::less},    {"<=", Operation::less_equal},
                             {">", Operation::greater}, {">=", Operation::greater_equal},
                             {"==", Operation::equal},  {"!=", Operation::not_equal},
                             {"in", Operation::in}};
    for (const Row& row : kRows) {
      if (!accept(row.mark)) continue;
      operation = row.operation;
      return true;
    }
    if (peek().is("not") && peek(1).is("in")) {
      at_ += 2;
      operation = Operation::not_in;
      return true;
    }
    if (!accept("is")) return false;
    operation = accept("not") ? Operation::is_not : Operation::is;
    return true;
  }

  const Syntax* comparison() {
    const std::uint32_t begin = peek().begin;
    const Syntax* first = binary(0);
    Operation operation{};
    if (first == nullptr || !accept_comparison(operation)) return first;
    std::vector<const Syntax*> parts{first};
    std::vector<Operation> operations;
    do {
      operations.push_back(operation);
      parts.push_back(binary(0));
      if (parts.back() == nullptr) return nullptr;
    } while (accept_comparison(operation));
    Syntax& node = make(SyntaxKind::compare, begin, parts);
    node.operations = keep(std::span<const Operation>(operations));
    return &node;
  }

  struct BinaryRow {
    std::size_t level;
    std::string_view mark;
    Operation operation;
  };

  /// Operators from `|` (level 0) to `*` (level 5), all from left to right.
  const Syntax* binary(std::size_t level) {
    constexpr BinaryRow kRows[] = {
        {0, "|", Operation::bit_or},       {1, "^", Operation::bit_xor},
        {2, "&", Operation::bit_and},      {3, "<<", Operation::shift_left},
        {3, ">>", Operation::shift_right}, {4, "+", Operation::add},
        {4, "-", Operation::subtract},     {5, "*", Operation::multiply},
        {5, "/", Operation::divide},       {5, "//", Operation::floor_divide},
        {5, "%", Operation::modulo},       {5, "@", Operation::matrix_multiply}};
    const std::uint32_t begin = peek().begin;
    const Syntax* left = unary();
    while (left != nullptr && fault_.rule == nullptr) {
      if (peek().kind != Token::Kind::mark) return left;
      const auto row = std::find_if(std::begin(kRows), std::end(kRows), [&](const BinaryRow& one) {
        return one.level >= level && peek().is(one.mark);
      });
      if (row == std::end(kRows)) return left;
      ++at_;
      const Syntax* right = binary(row->level + 1);
      if (right == nullptr) return nullptr;
      Syntax& node = make(SyntaxKind::binary, begin, {left, right});
      node.operation = row->operation;
      left = &node;
    }
    return nullptr;
  }

  const Syntax* unary() {
    std::vector<std::pair<Operation, std::uint32_t>> signs;
    for (;; ++at_) {
      if (peek().is("-")) {
        signs.emplace_back(Operation::negate, peek().begin);
      } else if (peek().is("+")) {
        signs.emplace_back(Operation::plus, peek().begin);
      } else if (peek().is("~")) {
        signs.emplace_back(Operation::invert, peek().begin);
      } else {
        break;
      }
    }
    const Syntax* value = power();
    for (; value != nullptr && !signs.empty() && fault_.rule == nullptr; signs.pop_back()) {
      Syntax& node = make(SyntaxKind::unary, signs.back().second, {value});
      node.operation = signs.back().first;
      value = &node;
    }
    return value;
  }

  const Syntax* power() {
    const Level level(depth_);
    if (depth_ > kDeepest) {
      fail("the expression is nested too deeply");
      return nullptr;
    }
    const std::uint32_t begin = peek().begin;
    const Syntax* base = primary();
    if (base == nullptr || !accept("**")) return base;
    const Syntax* exponent = unary();
    if (exponent == nullptr) return nullptr;
    Syntax& node = make(SyntaxKind::binary, begin, {base, exponent});
    node.operation = Operation::power;
    return &node;
  }

  const Syntax* primary();
  const Syntax* call(std::uint32_t begin, const Syntax* function);
  const Syntax* subscript(std::uint32_t begin, const Syntax* value);
  const Syntax* slice_or_test();
  const Syntax* atom();
  const Syntax* word();
  /// Adjacent texts are one.
  const Syntax* texts();
  const Syntax* bracketed(std::uint32_t begin);
  const Syntax* list(std::uint32_t begin);
  const Syntax* comprehension(const Syntax* item, std::uint32_t begin, bool is_generator);
  /// A name, or a list of names.
  const Syntax* target();

  Expressions& expressions_;
  SyntaxFault& fault_;
  const std::vector<Token>& tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace smurf::xacro
