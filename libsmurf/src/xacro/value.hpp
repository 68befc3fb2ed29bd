// SPDX-License-Identifier: BSD-3-Clause
// The values of expressions: those of Python, as far as the language of xacro has them.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/source.hpp"
#include "xacro/arena.hpp"
#include "xacro/bigint.hpp"
#include "xacro/meter.hpp"

namespace smurf::xacro {

struct Node;
class Table;
struct Syntax;
struct Locals;
struct Call;

/// Where a value was written: an index of Heap::place(). 0: computed.
enum class OriginId : std::uint32_t {};
inline constexpr OriginId kComputed{0};

enum class Kind : std::uint8_t {
  failed,  ///< the evaluation has reported a failure
  none,
  boolean,
  integer,
  big,  ///< an integer that needs more than 64 bits
  real,
  complex,
  text,
  bytes,
  date,  ///< of YAML; only its text is known
  list,
  tuple,
  set,
  iterator,
  dict,
  range,
  slice,
  function,
  type,
  name_space,
  block
};

enum class Type : std::uint8_t {
  none,
  boolean,
  integer,
  real,
  complex,
  text,
  bytes,
  list,
  tuple,
  set,
  frozen_set,
  dict,
  range,
  slice,
  type,
  function,
  map,
  filter,
  zip,
  enumerate,
  reversed,
  dict_keys,
  dict_values,
  dict_items,
  yaml_list,
  yaml_dict,
  other
};

struct List;
struct Dict;
struct Range;
struct Slice;
struct Function;

/// A value and the place where it was written. The heap owns what it points to.
struct Value {
  Kind kind = Kind::none;
  bool is_wrapped = false;  ///< a dict of YAML, whose members are attributes, too
  OriginId origin = kComputed;
  union {
    bool boolean;
    std::int64_t integer = 0;
    double real;
    const BigInt* big;
    const std::complex<double>* complex;
    const std::string* text;  ///< also of bytes and dates
    List* list;               ///< also of tuples, sets and iterators
    Dict* dict;
    const Range* range;
    const Slice* slice;
    const Function* function;
    Type type;
    Table* table;
    const Node* block;
  };

  static Value failure() {
    Value value;
    value.kind = Kind::failed;
    return value;
  }
  static Value of(bool from) {
    Value value;
    value.kind = Kind::boolean;
    value.boolean = from;
    return value;
  }
  static Value of(std::int64_t from) {
    Value value;
    value.kind = Kind::integer;
    value.integer = from;
    return value;
  }
  static Value of(double from) {
    Value value;
    value.kind = Kind::real;
    value.real = from;
    return value;
  }
  static Value of(Type from) {
    Value value;
    value.kind = Kind::type;
    value.type = from;
    return value;
  }

  bool is_failed() const { return kind == Kind::failed; }
  bool is_text() const { return kind == Kind::text; }
  bool is_sequence() const { return kind == Kind::list || kind == Kind::tuple; }
  /// A bool, an integer or a float.
  bool is_number() const {
    return kind == Kind::boolean || kind == Kind::integer || kind == Kind::big ||
           kind == Kind::real;
  }
  bool is_integral() const {
    return kind == Kind::boolean || kind == Kind::integer || kind == Kind::big;
  }
  Value at(OriginId place) const {
    Value value = *this;
    value.origin = place;
    return value;
  }
};

struct List {
  std::vector<Value> items;
  std::size_t next = 0;  ///< of an iterator
  Type type = Type::list;
  std::uint16_t depth = 1;  ///< of nested lists
  bool is_wrapped = false;  ///< a list of YAML whose members are wrapped when they are looked up
  bool is_part = false;     ///< of another list or dictionary
};

struct Dict {
  std::vector<std::pair<Value, Value>> items;  ///< in the order of insertion
  std::map<std::string, std::size_t, std::less<>> by_key;
  std::uint16_t depth = 1;
  bool is_part = false;  ///< of a list or another dictionary

  const Value* find(std::string_view key) const {
    const auto found = by_key.find(key);
    return found == by_key.end() ? nullptr : &items[found->second].second;
  }
};

struct Range {
  std::int64_t begin = 0, end = 0, step = 1;
  std::int64_t size() const;
};

struct Slice {
  Value begin, end, step;
};

/// A function of the language, a method with its object, or a lambda.
struct Function {
  std::string_view name;
  Value (*call)(Call& call) = nullptr;
  Value self;
  const Syntax* lambda = nullptr;
  const Locals* captured = nullptr;
};

/// Bytes of a source.
struct Place {
  Span span;
  bool is_exact = false;  ///< the bytes are the text of the value
};

/// Owns all values of an expansion, and counts their bytes.
class Heap {
 public:
  explicit Heap(Meter& meter) : meter_(meter) {}

  Value text(std::string text);
  Value bytes(std::string text);
  Value integer(BigInt value);
  Value complex(std::complex<double> value);
  Value list(std::vector<Value> items, Kind kind = Kind::list);
  Value iterator(std::vector<Value> items, Type type);
  Value dict(Dict dict);
  Value range(Range range);
  Value slice(Slice slice);
  Value function(Function function);
  /// Before a list or a dictionary gets more items: false if one of them is not allowed, because
  /// the list is a part of another one. So no list contains itself, and depths stay true.
  bool adopt(const Value& owner, std::span<const Value> items);
  /// A copy of a text that lives as long as the heap.
  std::string_view keep(std::string_view text);
  /// For what ends with the heap and is not destroyed.
  Arena& arena() { return arena_; }

  OriginId add(Place place);
  const Place& place(OriginId id) const { return places_[static_cast<std::size_t>(id)]; }

  /// Counts memory that something else takes.
  void charge(std::size_t bytes) { meter_.keep(bytes); }
  Meter& meter() { return meter_; }

 private:
  /// One more than the deepest of the items.
  template <class Items, class Get>
  std::uint16_t depth_of(const Items& items, const Get& get);
  static int depth_of(const Value& value);

  Meter& meter_;
  Arena arena_;
  std::deque<std::string> texts_;
  std::deque<BigInt> integers_;
  std::deque<std::complex<double>> complexes_;
  std::deque<List> lists_;
  std::deque<Dict> dicts_;
  std::deque<Range> ranges_;
  std::deque<Slice> slices_;
  std::deque<Function> functions_;
  std::vector<Place> places_{1};
};

/// Precondition: a bool, an integer or a big integer.
BigInt to_big(const Value& value);
/// Of a bool, an integer or a float; none for an integer that is too large.
std::optional<double> to_real(const Value& value);
Type type_of(const Value& value);
std::string_view name_of(Type type);
/// "a text", "a list": for messages.
std::string_view kind_name(const Value& value);

bool is_true(const Value& value);
bool are_equal(const Value& a, const Value& b, Meter& meter);
/// Negative, 0 or positive; 2 if one is not a number (NaN); none if the two cannot be ordered.
std::optional<int> compare(const Value& a, const Value& b, Meter& meter);
/// Equal for keys that are equal; none for values that cannot be keys.
std::optional<std::string> hash_key(const Value& value, Meter& meter);
void insert(Dict& dict, const Value& key, const Value& value, Meter& meter);

/// The items of a set by their keys.
class KeySet {
 public:
  KeySet(const std::vector<Value>& items, Meter& meter);
  bool has(const Value& item) const;
  bool has_all(const std::vector<Value>& items) const;

 private:
  Meter& meter_;
  std::set<std::string> keys_;
};

/// Why a value has no text.
struct NoText {
  Meter& meter;
  std::string reason;
  std::uint64_t most = ~std::uint64_t{0};  ///< bytes; longer texts have a reason and are incomplete
};
/// As str() and repr(); on failure, `problem` says why.
std::string text_of(const Value& value, NoText& problem);
std::string repr_of(const Value& value, NoText& problem);

}  // namespace smurf::xacro
