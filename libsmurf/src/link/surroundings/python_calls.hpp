// SPDX-License-Identifier: BSD-3-Clause
// The calls in a Python file that describes something, such as a launch file or a setup.py, read
// without executing it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "link/surroundings/python_tokens.hpp"
#include "smurf/source.hpp"

namespace smurf::python {

/// A part of a text that is put together.
struct Piece {
  enum class Kind : std::uint8_t {
    literal,
    share,     ///< the installed share folder of the package `text`
    argument,  ///< the launch argument `text`
    unknown,
  };
  Kind kind = Kind::unknown;
  std::string text;
  Span span;  ///< of several literals that were joined, the last
  struct Part {
    std::size_t end = 0;  ///< in `text`
    Span span;
  };
  std::vector<Part> parts = {};  ///< these literals; empty if it is one

  /// The literal with the character at this place of `text`.
  Span span_at(std::size_t at) const;
};

struct Keyword;

/// The value of an expression, as far as it is known.
struct Value {
  enum class Kind : std::uint8_t { unknown, text, list, mapping, call };
  Kind kind = Kind::unknown;
  Span span;
  std::vector<Piece> pieces;    ///< text: one after the other
  std::vector<Value> items;     ///< list; of a call: its arguments; of a mapping: keys and values
  std::vector<Keyword> named;   ///< keyword arguments of a call
  std::string callee;           ///< "Node"; "open.read" of open(..).read()
  bool is_conditional = false;  ///< below an `if`, a loop or the like
  /// An object that launch replaces by its text later, such as LaunchConfiguration: no `str`.
  bool is_lazy = false;

  bool is_text() const { return kind == Kind::text; }
  bool is_list() const { return kind == Kind::list; }
  bool is_call(std::string_view name) const { return kind == Kind::call && callee == name; }
  /// A keyword argument; null if it is not written.
  const Value* find(std::string_view name) const;
  /// Null if it is not known as a whole.
  const std::string* literal() const;
};

struct Keyword {
  std::string name;
  Value value;
};

/// A call as it is written, with what its values are as far as Python's own checks need it.
struct WrittenCall {
  std::string callee;  ///< "Node", "launch_ros.actions.Node"; not of the methods of a value
  Span span;
  struct Argument {
    std::string name;  ///< empty: given by its position
    Span name_span, span;
    enum class Kind : std::uint8_t { other, number, truth, nothing, text, mapping, list, lazy };
    Kind kind = Kind::other;
    std::string text;  ///< of a literal
  };
  std::vector<Argument> arguments;
  bool has_star = false;  ///< `*list`, `**mapping`
};

/// `'text' + LaunchConfiguration(..)`: Python cannot add these.
struct BadSum {
  Span span;
};

struct File {
  std::vector<WrittenCall> written;
  std::vector<BadSum> bad_sums;
  std::set<std::string, std::less<>> bound;                  ///< names that anything binds anywhere
  std::map<std::string, std::string, std::less<>> imported;  ///< names, and from which module
  bool has_star_import = false;
  struct Function {
    std::string name;
    Span span;
    bool returns = false;
  };
  std::vector<Function> functions;                   ///< at the beginning of a line
  std::vector<Value> calls;                          ///< in the order in which they end
  std::vector<std::pair<std::string, Value>> names;  ///< that are assigned once, in their order
  /// Whether names are bound or texts are made in ways that are not read: loops, `+=`, functions.
  bool has_loops = false;
  std::optional<Fault> fault;
};
/// Never fails: what it does not understand is unknown.
File read_file(std::string_view text, SourceId source);

/// A text of pieces that begin one after the other; an item of another kind is unknown.
Value join_texts(const std::vector<Value>& parts, std::string_view between);

}  // namespace smurf::python
