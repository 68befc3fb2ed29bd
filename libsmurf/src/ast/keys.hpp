// SPDX-License-Identifier: BSD-3-Clause
// Keys of annotations as tables: one row says what a key holds, where it goes and what it means.
// The reader, the JSON schemas and the suggestions for misspelt keys are made from the same rows.
#pragma once

#include <bitset>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/model.hpp"
#include "smurf/names.hpp"

namespace smurf {

/// How a value is written. Quoted text is text; a null means the same as an absent key.
enum class ValueType : std::uint8_t {
  text,          ///< any scalar
  frame,         ///< any scalar; one that names no frame is reported where frames are looked up
  number,        ///< finite plain number
  integer,       ///< plain whole number; without bounds of its own it fits in 32 bits, as in MARS
  boolean,       ///< true or false; 1 or 0
  names,         ///< text or list of texts
  name_list,     ///< list of texts
  number_list,   ///< list of numbers
  number_map,    ///< mapping from any names to numbers
  vector2,       ///< mapping x, y
  vector3,       ///< mapping x, y, z
  vector3_list,  ///< list of three numbers
  quaternion,    ///< mapping w, x, y, z
  orientation,   ///< mapping w, x, y, z or roll, pitch, yaw
  color,         ///< mapping r, g, b, a; each 0 to 1
  position,      ///< list of three numbers, or mapping x, y, z
  rotation,      ///< number, list of one, three or four numbers, or mapping w, x, y, z
  mapping,       ///< of the keys in `members`, or of any
  list,          ///< of mappings with the keys in `members`, or of anything
  any
};

struct KeySpec;

/// A table of keys; a view of an array.
struct KeyTable {
  const KeySpec* first = nullptr;
  std::size_t size = 0;

  constexpr KeyTable() = default;
  template <std::size_t N>
  constexpr KeyTable(const KeySpec (&keys)[N]) : first(keys), size(N) {}
  std::span<const KeySpec> keys() const;
};

/// What a text is the name of.
struct Naming {
  NameKinds kinds = {};   ///< empty: it is no name
  bool defines = false;   ///< the thing gets its name here
  bool is_vague = false;  ///< it may be known elsewhere, so that only a misspelling is a fault
};
constexpr Naming defines(NameKinds kinds) { return {kinds, true, false}; }
constexpr Naming may_name(NameKinds kinds) { return {kinds, false, true}; }

/// What is a node to MARS. It also knows the inertia of a link, as `inertial_LINK`.
inline constexpr NameKinds kNodeKinds =
    NameKind::link | NameKind::visual | NameKind::collision | NameKind::node;

/// What a key holds. The texts go into the schema.
struct KeySpec {
  std::string_view name;
  ValueType type = ValueType::any;
  std::string_view doc = {};   ///< one sentence
  std::string_view unit = {};  ///< "rad/s"; may be empty
  std::string_view fallback =
      {};  ///< what MARS takes when it is absent, as JSON text; may be empty
  /// Titles of readers, separated by commas, "Rock" or "nobody"; empty: the readers of the section.
  std::string_view read_by = {};
  bool required = false;
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool positive = false;  ///< a number that must be above 0
  bool is_limit = false;  ///< readers only compare it, and the largest double means "no limit"
  std::span<const std::string_view> choices = {};  ///< of a text; empty: any
  KeyTable members = {};                           ///< of a mapping, or of the mappings in a list
  /// What its text names, or each text of its list, or each key of a number_map. References are
  /// found by this (link/references.cpp), so that a new key that names something needs no more.
  Naming names = {};
  Naming (*names_in)(yaml::View entry) = nullptr;  ///< where that depends on the rest of the entry
  bool is_path = false;  ///< of a file, relative to the folder of the file that it stands in
};

inline std::span<const KeySpec> KeyTable::keys() const { return {first, size}; }

/// Bounds of a number, both inclusive; infinite where there are none.
struct Bounds {
  double minimum = 0;
  double maximum = 0;
};
Bounds bounds_of(const KeySpec& spec);

/// The names of the numbers in a mapping of this type: x, y, z of a vector3. Empty for others.
std::span<const std::string_view> components_of(ValueType type);

template <class T>
using Member = std::variant<std::monostate, Field<std::string> T::*, Field<double> T::*,
                            Field<std::int64_t> T::*, Field<bool> T::*, Field<NameList> T::*,
                            Field<Vector3> T::*, Field<Color> T::*>;

/// A key and the member that keeps its value; without a member the value stays in the tree only.
template <class T>
struct Key {
  KeySpec spec;
  Member<T> member;
};

using Target =
    std::variant<std::monostate, Field<std::string>*, Field<double>*, Field<std::int64_t>*,
                 Field<bool>*, Field<NameList>*, Field<Vector3>*, Field<Color>*>;

/// Checks one value against its row and stores it. Reports SML4001 (wrong type), SML4002 (not one
/// of the choices), SML4003 (out of range), and SML4004 (missing key) inside `members`.
void read_value(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink);

/// Checks a mapping against a table that keeps no values; `what` names it in messages.
void check_keys(std::span<const KeySpec> keys, yaml::View mapping, std::string_view what,
                DiagnosticSink& sink);

/// How the keys of a mapping differ from its tables.
struct KeyDifference {
  std::vector<const KeySpec*> missing;  ///< required, but not given
  std::vector<yaml::View> unknown;      ///< given, but in no table
  std::vector<std::string_view> known;  ///< all keys of the tables, when slips are looked for
};

/// Whether unknown keys that are nearly known ones are reported where the keys are read.
enum class Slips : std::uint8_t { ignored, reported };

/// Reports SML4004 for each required key that `mapping`, a `what` ("motor"), does not hold, and
/// SML4005 for each unknown key that is a misspelling of another one.
void report_difference(const KeyDifference& difference, yaml::View mapping, std::string_view what,
                       DiagnosticSink& sink);

/// The type of a quoted scalar without its quotes; text for everything else.
yaml::ScalarType type_without_quotes(yaml::View value);

/// The key of an entry after which a missing one would be looked for: where other entries of the
/// list have it, else at the end.
Span place_to_add(yaml::View entry, std::string_view key);

/// The bytes of a scalar within its quotes, if it has any, so that an edit keeps them (JSON).
Span within_quotes(yaml::View value);
/// Same, for a scalar that reads `text`; none where it is written otherwise: as a block or with
/// escapes.
std::optional<Span> within_quotes(Span scalar, std::string_view text);

/// "a number", "a list of names": for messages.
std::string_view describe(ValueType type);
/// What is written there, for messages: "a list", "the text `abc`".
std::string describe(yaml::View value);

/// Rows beside those of a section's own table: they keep no value and none of them is required.
using MoreKeys = std::initializer_list<std::span<const KeySpec>>;

/// Null when no table has the key; the first table that has it counts.
const KeySpec* find_key(MoreKeys tables, std::string_view name);

/// No table whose values are kept is larger.
inline constexpr std::size_t kMostKeys = 64;

/// Reads `mapping` into `out` by tables. Keys without a row are left to the tree.
template <class T>
void read_keys(std::span<const Key<T>> keys, MoreKeys more, yaml::View mapping, T& out,
               std::string_view what, DiagnosticSink& sink, Slips slips = Slips::ignored) {
  assert(keys.size() <= kMostKeys);
  std::bitset<kMostKeys> seen;
  std::bitset<kMostKeys> given;
  KeyDifference difference;
  std::size_t i = 0;
  for (const yaml::View value : mapping) {
    // Many write the keys in the order of the table: the search goes on from the last one.
    std::size_t left = keys.size();
    while (left > 0 && keys[i].spec.name != value.key()) {
      i = i + 1 == keys.size() ? 0 : i + 1;
      --left;
    }
    if (left == 0) {
      const KeySpec* spec = find_key(more, value.key());
      if (spec == nullptr) difference.unknown.push_back(value);
      if (spec != nullptr && !value.is_repeated()) read_value(*spec, value, {}, sink);
      continue;
    }
    if (seen[i]) continue;
    seen[i] = true;
    given[i] = !value.is_null();
    const Target target = std::visit(
        [&](auto member) -> Target {
          if constexpr (std::is_same_v<decltype(member), std::monostate>) {
            return std::monostate{};
          } else {
            return &(out.*member);
          }
        },
        keys[i].member);
    read_value(keys[i].spec, value, target, sink);
  }
  for (std::size_t key = 0; key < keys.size(); ++key) {
    if (keys[key].spec.required && !given[key]) difference.missing.push_back(&keys[key].spec);
  }
  if (slips == Slips::reported && !difference.unknown.empty()) {
    for (const Key<T>& key : keys) difference.known.push_back(key.spec.name);
    for (const std::span<const KeySpec> table : more) {
      for (const KeySpec& spec : table) difference.known.push_back(spec.name);
    }
  }
  report_difference(difference, mapping, what, sink);
}

/// Reads an entry of a list; `out` learns its place as well.
template <class T>
void read_entry(std::span<const Key<T>> keys, MoreKeys more, yaml::View mapping, T& out,
                std::string_view what, DiagnosticSink& sink, Slips slips = Slips::ignored) {
  out.span = mapping.span();
  out.node = mapping.id();
  if (mapping.is_mapping()) read_keys(keys, more, mapping, out, what, sink, slips);
}

template <class T>
void read_entry(std::span<const Key<T>> keys, yaml::View mapping, T& out, std::string_view what,
                DiagnosticSink& sink) {
  read_entry<T>(keys, {}, mapping, out, what, sink);
}

/// Which rows are wanted; null: all.
using KeyFilter = bool (*)(const KeySpec&);

/// All rows of an entry, for the schema; a name that an earlier table has is not repeated.
template <class T>
std::vector<const KeySpec*> specs_of(std::span<const Key<T>> keys, MoreKeys more = {},
                                     KeyFilter takes = nullptr) {
  const auto is_wanted = [&](const KeySpec& spec) { return takes == nullptr || takes(spec); };
  std::vector<const KeySpec*> specs;
  for (const Key<T>& key : keys) {
    if (is_wanted(key.spec)) specs.push_back(&key.spec);
  }
  const std::size_t own = specs.size();
  for (const std::span<const KeySpec> table : more) {
    for (const KeySpec& spec : table) {
      if (!is_wanted(spec)) continue;
      bool is_known = find_key(more, spec.name) != &spec;
      for (std::size_t i = 0; i < own; ++i) is_known = is_known || specs[i]->name == spec.name;
      if (!is_known) specs.push_back(&spec);
    }
  }
  return specs;
}

}  // namespace smurf
