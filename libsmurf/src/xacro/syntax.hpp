// SPDX-License-Identifier: BSD-3-Clause
// The syntax trees of expressions, and their parser: a closed part of Python.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "smurf/diagnostic.hpp"
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
  std::vector<const Syntax*> parts;
  std::vector<std::string_view> names;
  std::vector<Operation> operations;
  struct Clause {
    const Syntax* target = nullptr;
    const Syntax* iterable = nullptr;
    std::vector<const Syntax*> conditions;
  };
  std::vector<Clause> clauses;  ///< of a comprehension
  bool is_generator = false;    ///< of a comprehension
  bool has_lambda = false;      ///< this, or something in it
};

/// Why a text is no expression.
struct SyntaxFault {
  const Rule* rule = nullptr;
  std::uint32_t begin = 0, end = 0;
  std::string message;
  std::string help;
};

struct Expression {
  const Syntax* root = nullptr;  ///< null: see `fault`
  SyntaxFault fault;
};

/// Owns the trees of all expressions; each text is parsed once.
class Expressions {
 public:
  explicit Expressions(Heap& heap) : heap_(heap) {}
  const Expression& parse(std::string_view text);

 private:
  friend class Parser;
  Heap& heap_;
  std::deque<Syntax> nodes_;
  std::unordered_map<std::string_view, Expression> known_;
};

}  // namespace smurf::xacro
