// SPDX-License-Identifier: BSD-3-Clause
// What binds closest: names, constants, brackets, calls, indices.
#include <algorithm>
#include <array>

#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "xacro/parser.hpp"

namespace smurf::xacro {

const Syntax* Parser::primary() {
  const std::uint32_t begin = peek().begin;
  const Syntax* value = atom();
  while (value != nullptr) {
    if (accept(".")) {
      if (peek().kind != Token::Kind::name) {
        unexpected();
        return nullptr;
      }
      const std::string_view name = peek().text;
      ++at_;
      Syntax& node = make(SyntaxKind::attribute, begin, {value});
      node.text = name;
      value = &node;
    } else if (accept("(")) {
      value = call(begin, value);
    } else if (accept("[")) {
      value = subscript(begin, value);
    } else {
      return value;
    }
  }
  return nullptr;
}

const Syntax* Parser::call(std::uint32_t begin, const Syntax* function) {
  std::vector<const Syntax*> parts{function};
  std::vector<std::string_view> names;
  while (!peek().is(")")) {
    std::string_view name;
    if (peek().is("*") || peek().is("**")) {
      name = peek().text;
      if (name == "*" && std::find(names.begin(), names.end(), "**") != names.end()) {
        fail("`*` follows `**`");
        return nullptr;
      }
      ++at_;
    } else if (peek().kind == Token::Kind::name && peek(1).is("=")) {
      name = peek().text;
      if (std::find(names.begin(), names.end(), name) != names.end()) {
        fail("the parameter " + quoted(name) + " is given twice");
        return nullptr;
      }
      at_ += 2;
    } else if (std::any_of(names.begin(), names.end(),
                           [](std::string_view one) { return !one.empty() && one != "*"; })) {
      fail("a parameter without a name follows one with a name");
      return nullptr;
    }
    const Syntax* value = named_test();
    if (value != nullptr && peek().is("for")) value = comprehension(value, begin, true);
    if (value == nullptr) return nullptr;
    parts.push_back(value);
    names.push_back(name);
    if (!accept(",")) break;
  }
  if (!expect(")")) return nullptr;
  Syntax& node = make(SyntaxKind::call, begin, parts);
  node.names = keep(std::span<const std::string_view>(names));
  return &node;
}

const Syntax* Parser::subscript(std::uint32_t begin, const Syntax* value) {
  const Syntax* index = slice_or_test();
  if (index != nullptr && peek().is(",")) {
    std::vector<const Syntax*> items{index};
    while (accept(",") && !peek().is("]")) {
      items.push_back(slice_or_test());
      if (items.back() == nullptr) return nullptr;
    }
    index = &make(SyntaxKind::tuple, begin, items);
  }
  if (index == nullptr || !expect("]")) return nullptr;
  return &make(SyntaxKind::subscript, begin, {value, index});
}

const Syntax* Parser::slice_or_test() {
  const std::uint32_t begin = peek().begin;
  std::array<const Syntax*, 3> parts{};
  std::size_t count = 0;
  bool is_slice = false;
  for (;; ++count) {
    if (!peek().is(":") && !peek().is("]") && !peek().is(",")) {
      parts[count] = named_test();
      if (parts[count] == nullptr) return nullptr;
    }
    if (count == 2 || !accept(":")) break;
    is_slice = true;
  }
  if (is_slice) return &make(SyntaxKind::slice, begin, parts);
  if (parts[0] == nullptr) unexpected();
  return parts[0];
}

const Syntax* Parser::atom() {
  const Token& token = peek();
  switch (token.kind) {
  case Token::Kind::name: {
    ++at_;
    Syntax& node = make(SyntaxKind::name, token.begin, {});
    node.text = token.text;
    return &node;
  }
  case Token::Kind::number: {
    ++at_;
    Syntax& node = make(SyntaxKind::constant, token.begin, {});
    node.value = token.value;
    return &node;
  }
  case Token::Kind::text: return texts();
  case Token::Kind::keyword: return word();
  default: break;
  }
  if (accept("(")) return bracketed(token.begin);
  if (accept("[")) return list(token.begin);
  if (token.is("{")) return unsupported("`{...}`");
  if (token.is("...")) return unsupported("`...`");
  unexpected();
  return nullptr;
}

const Syntax* Parser::word() {
  const Token& token = peek();
  Value value;
  if (token.text == "True" || token.text == "False") {
    value = Value::of(token.text == "True");
  } else if (token.text != "None") {
    if (is_one_of(token.text, {"await", "yield"}))
      return unsupported("`" + std::string(token.text) + "`");
    unexpected();
    return nullptr;
  }
  ++at_;
  Syntax& node = make(SyntaxKind::constant, token.begin, {});
  node.value = value;
  return &node;
}

const Syntax* Parser::texts() {
  const Token& first = peek();
  ++at_;
  Value value = first.value;
  if (peek().kind == Token::Kind::text) {
    std::string all = *value.text;
    for (; peek().kind == Token::Kind::text; ++at_) {
      if (peek().value.kind != value.kind) {
        fail("bytes and texts cannot be joined");
        return nullptr;
      }
      all += *peek().value.text;
    }
    value = value.is_text() ? expressions_.heap_.text(std::move(all))
                            : expressions_.heap_.bytes(std::move(all));
  }
  Syntax& node = make(SyntaxKind::constant, first.begin, {});
  node.value = value;
  return &node;
}

const Syntax* Parser::bracketed(std::uint32_t begin) {
  if (accept(")")) return &make(SyntaxKind::tuple, begin, {});
  const Syntax* first = named_test();
  if (first == nullptr) return nullptr;
  if (peek().is("for")) {
    const Syntax* generator = comprehension(first, begin, true);
    return generator != nullptr && expect(")") ? generator : nullptr;
  }
  if (!peek().is(",")) return expect(")") ? first : nullptr;
  std::vector<const Syntax*> items{first};
  while (accept(",") && !peek().is(")")) {
    items.push_back(named_test());
    if (items.back() == nullptr) return nullptr;
  }
  if (!expect(")")) return nullptr;
  return &make(SyntaxKind::tuple, begin, items);
}

const Syntax* Parser::list(std::uint32_t begin) {
  std::vector<const Syntax*> items;
  while (!peek().is("]")) {
    items.push_back(named_test());
    if (items.back() == nullptr) return nullptr;
    if (items.size() == 1 && peek().is("for")) {
      const Syntax* all = comprehension(items[0], begin, false);
      return all != nullptr && expect("]") ? all : nullptr;
    }
    if (!accept(",")) break;
  }
  if (!expect("]")) return nullptr;
  return &make(SyntaxKind::list, begin, items);
}

const Syntax* Parser::comprehension(const Syntax* item, std::uint32_t begin, bool is_generator) {
  Syntax& node = make(SyntaxKind::comprehension, begin, {item});
  node.is_generator = is_generator;
  std::vector<Syntax::Clause> clauses;
  while (accept("for")) {
    Syntax::Clause clause;
    clause.target = target();
    if (clause.target == nullptr || !expect("in")) return nullptr;
    clause.iterable = disjunction();
    if (clause.iterable == nullptr) return nullptr;
    deepen(node, clause.iterable);
    std::vector<const Syntax*> conditions;
    while (accept("if")) {
      conditions.push_back(disjunction());
      if (conditions.back() == nullptr) return nullptr;
      deepen(node, conditions.back());
    }
    clause.conditions = keep(Parts(conditions));
    clauses.push_back(clause);
  }
  node.clauses = keep(std::span<const Syntax::Clause>(clauses));
  node.end = tokens_[at_ - 1].end;
  return &node;
}

const Syntax* Parser::target() {
  const std::uint32_t begin = peek().begin;
  const bool has_bracket = accept("(");
  std::vector<const Syntax*> names;
  while (peek().kind == Token::Kind::name || peek().is("(")) {
    names.push_back(peek().is("(") ? target() : atom());
    if (names.back() == nullptr) return nullptr;
    if (!accept(",")) break;
  }
  if (has_bracket && !expect(")")) return nullptr;
  if (names.empty()) {
    unexpected();
    return nullptr;
  }
  const bool is_one = names.size() == 1 && !tokens_[at_ - 1].is(",");
  return is_one ? names[0] : &make(SyntaxKind::tuple, begin, names);
}

}  // namespace smurf::xacro
