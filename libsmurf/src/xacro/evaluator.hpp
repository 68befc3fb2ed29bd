// SPDX-License-Identifier: BSD-3-Clause
// Computes expressions. A failure is kept; it becomes a finding where the place is known.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/xacro.hpp"
#include "xacro/scope.hpp"
#include "xacro/syntax.hpp"
#include "xacro/value.hpp"

namespace smurf::xacro {

class Evaluator;

/// Why something could not be computed.
struct Failure {
  const Rule* rule = nullptr;
  std::string message;
  std::string help;
  std::uint32_t begin = 0, end = 0;  ///< in the expression; both 0: all of it
  Span span;                         ///< a place outside of the expression; empty: none
  std::string argument;              ///< the one that has no value
  std::string missing;               ///< the path of a file that does not exist
  const Circumstance* which = nullptr;
  bool is_missing_file = false;  ///< an optional include may ignore it
  std::vector<std::pair<Span, std::string>> labels;
};

/// Something in an expression that can be computed, and is not what it seems.
struct Remark {
  const Rule* rule = nullptr;
  std::string message;
  std::string help;
  std::uint32_t begin = 0, end = 0;          ///< in the expression
  std::uint32_t fix_begin = 0, fix_end = 0;  ///< the bytes to replace
  std::string replacement = {};              ///< empty: there is no fix
};

/// What expressions ask of the expansion around them.
class Host {
 public:
  virtual ~Host() = default;
  /// The value of a property, which may have to be evaluated first.
  virtual Value resolve(Table& table, Table::Entry& entry, std::string_view name) = 0;
  virtual Value load_yaml(const std::string& path) = 0;
  virtual std::string whole_path(const std::string& path) = 0;
  virtual Value argument(const std::string& name) = 0;
  virtual Value environment(const std::string& name, const Value* fallback) = 0;
  virtual Value find_package(const std::string& name) = 0;
  /// What xacro.warning() and its kind print.
  virtual void say(std::string_view kind, const std::string& text) = 0;
  /// Sets a property: `(x := 1)`.
  virtual void assign(Table& table, std::string_view name, const Value& value) = 0;
};

/// A call of a function of the language.
struct Call {
  Evaluator& evaluator;
  std::string_view name;
  Value self;
  std::vector<Value> values;
  std::vector<std::pair<std::string_view, Value>> keywords;

  std::size_t count() const { return values.size(); }
  /// The parameter at a position, or of a name, which is removed; null if it is absent.
  const Value* take(std::size_t position, std::string_view keyword = {});
  /// Reports a call with other numbers of parameters, or with keywords.
  bool has_count(std::size_t least, std::size_t most);
};

class Evaluator {
 public:
  Evaluator(Heap& heap, Expressions& expressions, const Limits& limits, Host& host)
      : heap_(heap),
        meter_(heap.meter()),
        expressions_(expressions),
        limits_(limits),
        host_(host) {}

  /// Where the text of the expression that is being computed begins; none if it is not written
  /// in one place.
  void set_code_place(std::optional<Span> place) { code_place_ = place; }
  std::optional<Span> code_place() const { return code_place_; }

  struct Scope {
    Table* table = nullptr;
    const Locals* locals = nullptr;  ///< in a lambda or a comprehension
  };

  /// The value of an expression; fails with the fault of its syntax, and when an expansion has used
  /// up what it may: nothing is thrown beyond this.
  Value evaluate(std::string_view text, Table& table);
  Value evaluate(const Syntax& syntax, const Scope& scope);
  Value call(const Value& function, std::vector<Value> values,
             std::vector<std::pair<std::string_view, Value>> keywords = {});

  /// Keeps the first failure.
  Value fail(const Rule& rule, std::string message, std::string help = {});
  Value fail(std::string message);  ///< of a computation
  Value fail_unsupported(const std::string& what);
  const Failure& failure() const { return failure_; }
  Failure& failure() { return failure_; }
  bool has_failed() const { return failure_.rule != nullptr; }
  Failure take_failure() { return std::exchange(failure_, {}); }

  /// Counts work that is not done by a primitive.
  void step(std::uint64_t count = 1) { meter_.step(count); }
  /// The failure of an expansion that has used up what it may.
  Value fail_exhausted();

  /// The items of anything that a loop may visit.
  bool items_of(const Value& value, std::vector<Value>& items);
  /// A list or dict of YAML as its members are seen.
  Value wrapped(const Value& value);
  Value text(std::string text);
  Value list(std::vector<Value> items, Kind kind = Kind::list);
  Value integer(BigInt value);
  /// The text of a value, as str().
  std::string string_of(const Value& value);
  std::string repr(const Value& value);

  /// Values that were looked up by name since begin_uses(), and their places.
  using Used = std::span<const std::pair<std::string_view, OriginId>>;
  Used used() const { return Used(used_).subspan(first_used_); }
  void use(std::string_view name, OriginId origin) { used_.emplace_back(name, origin); }
  /// Expressions evaluate others: returns what end_uses() needs to go back to those around.
  struct Uses {
    std::size_t first = 0, count = 0;
  };
  Uses begin_uses() { return {std::exchange(first_used_, used_.size()), used_.size()}; }
  void end_uses(Uses outer) {
    used_.resize(outer.count);
    first_used_ = outer.first;
  }
  std::vector<Remark>& remarks() { return remarks_; }

  Heap& heap() { return heap_; }
  Meter& meter() { return meter_; }
  Host& host() { return host_; }
  const Limits& limits() const { return limits_; }

 private:
  Value evaluate_text(std::string_view text, Table& table);
  std::string written(const Value& value, std::string (*write)(const Value&, NoText&));
  /// `is_called`: functions have similar names, too.
  Value name(const Syntax& syntax, const Scope& scope, bool is_called = false);
  void remark_on(const Syntax& comparison, std::size_t index, const Value& left,
                 const Value& right);
  void remark_on_call(const Syntax& call);
  Value compare_chain(const Syntax& syntax, const Scope& scope);
  Value call_syntax(const Syntax& syntax, const Scope& scope);
  Value comprehension(const Syntax& syntax, const Scope& scope);
  bool run_clauses(const Syntax& syntax, std::size_t clause, const Scope& scope, Locals& locals,
                   std::vector<Value>& items);
  bool bind(const Syntax& target, const Value& value, Locals& locals);
  /// Names that a lambda may see after their loop; with the values that they have then.
  Locals& kept_locals();
  Value call_lambda(const Function& function, const Call& call);
  /// A text that is written in a list, with its place.
  Value placed(const Value& value, const Syntax& syntax);
  Value parts_of(const Syntax& syntax, const Scope& scope, Kind kind);
  bool check_names(const Syntax& syntax);

  Heap& heap_;
  Meter& meter_;
  Expressions& expressions_;
  const Limits& limits_;
  Host& host_;
  std::optional<Span> code_place_;
  Failure failure_;
  int depth_ = 0;
  std::deque<Locals> captured_;
  std::vector<std::pair<std::string_view, OriginId>> used_;
  std::size_t first_used_ = 0;
  std::vector<Remark> remarks_;
};

// operators.cpp
Value compute(Evaluator& evaluator, Operation operation, const Value& a, const Value& b);
Value compute(Evaluator& evaluator, Operation operation, const Value& a);
/// True or false, or a failure.
Value compare_values(Evaluator& evaluator, Operation operation, const Value& a, const Value& b);
// attributes.cpp
Value attribute_of(Evaluator& evaluator, const Value& value, std::string_view name);
Value subscript_of(Evaluator& evaluator, const Value& value, const Value& index);
// types.cpp
Value call_type(Evaluator& evaluator, Type type, Call& call);
bool is_subtype(Type type, Type of);
// format_strings.cpp
Value percent_format(Evaluator& evaluator, const std::string& format, const Value& values);
Value brace_format(Call& call);
// builtins.cpp, tokenize.cpp, math_functions.cpp
Value sorted(Call& call);
Value tokenize(Call& call);
/// Fills the table of functions.
void add_functions(Table& root, Heap& heap, std::deque<Table>& tables);
/// Fills the table of `$(eval ...)`.
void add_eval_functions(Table& root, Heap& heap);
void add_math(Table& table, Heap& heap);
// methods.cpp
/// A method of a text, a list or a dict; null if no method has the name.
struct Method {
  std::string_view name;
  Value (*call)(Call& call);  ///< null: not supported
};
/// The row of a table; null if it has none.
const Method* find_method(std::span<const Method> rows, std::string_view name);
std::span<const Method> text_methods();
std::span<const Method> list_methods();
std::span<const Method> dict_methods();
std::span<const Method> real_methods();
std::span<const Method> integer_methods();

}  // namespace smurf::xacro
