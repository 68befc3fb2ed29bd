// SPDX-License-Identifier: BSD-3-Clause
// The syntax trees of expressions, and their parser: a closed part of Python.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "xacro/arena.hpp"
#include "xacro/value.hpp"

namespace smurf::xacro {

enum class SyntaxKind : std::uint8_t {
  name,
  constant,
  star,  ///< of a list or a tuple: the items of parts[0]
  tuple,
  list,
  comprehension,  ///< parts: item, target, iterable, conditions; more clauses nest in `clauses`
  unary,          ///< operation, parts[0]
  binary,
  compare,  ///< operations, parts
  logical_and,
  logical_or,
  logical_not,
  conditional,  ///< parts: value, condition, other value
  call,       ///< parts: function, arguments; `names` of the keywords, "" for others, "*" and "**"
  attribute,  ///< parts[0], text
  subscript,  ///< parts: value, index
  slice,      ///< parts; null if absent
  lambda,     ///< parts: body, defaults; `names`
  assign      ///< a name and a value: `(x := 1)`
};

enum class Operation : std::uint8_t {
  add,
  subtract,
  multiply,
  divide,
  floor_divide,
  modulo,
  power,
  matrix_multiply,
  shift_left,
  shift_right,
  bit_and,
  bit_or,
  bit_xor,
  negate,
  plus,
  invert,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  in,
  not_in,
  is,
  is_not
};
std::string_view text_of(Operation operation);

struct Syntax {
  SyntaxKind kind = SyntaxKind::constant;
  Operation operation = Operation::add;
  std::uint16_t depth = 1;
  std::uint32_t begin = 0, end = 0;  ///< in the text of the expression
  std::string_view text;             ///< of a name or an attribute
  Value value;                       ///< of a constant
  std::span<const Syntax* const> parts;
  std::span<const std::string_view> names;
  std::span<const Operation> operations;
  struct Clause {
    const Syntax* target = nullptr;
    const Syntax* iterable = nullptr;
    std::span<const Syntax* const> conditions;
  };
  std::span<const Clause> clauses;  ///< of a comprehension
  bool is_generator = false;        ///< of a comprehension
  bool has_lambda = false;          ///< this, or something in it
};

/// Why a text is no expression.
struct SyntaxFault {
  const Rule* rule = nullptr;
  std::uint32_t begin = 0, end = 0;
  std::string message;
  std::string help;
};

struct Expression {
  const Syntax* root = nullptr;
  const SyntaxFault* fault = nullptr;  ///< if there is no root
};

struct Token;

/// Owns the trees of all expressions; each text is parsed once.
class Expressions {
 public:
  explicit Expressions(Heap& heap);
  ~Expressions();
  const Expression& parse(std::string_view text);

 private:
  friend class Parser;
  Heap& heap_;  ///< the trees are in its arena
  std::deque<SyntaxFault> faults_;
  using Known = std::pair<const std::string_view, Expression>;
  std::unordered_map<std::string_view, Expression, std::hash<std::string_view>, std::equal_to<>,
                     ArenaAllocator<Known>>
      known_;
  std::vector<Token> tokens_;  ///< of the expression that is being parsed
};

}  // namespace smurf::xacro
