// SPDX-License-Identifier: BSD-3-Clause
// Keys of annotations as tables: one row defines type, target field and meaning of a key. The
// reader, the JSON schemas and the suggestions for misspelt keys use the same rows.
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

/// The form of a value. Quoted text is text; a null is treated as an absent key.
enum class ValueType : std::uint8_t {
  text,          ///< any scalar
  frame,         ///< any scalar; an unknown frame is reported when frames are looked up
  number,        ///< finite plain number
  integer,       ///< plain whole number; without explicit bounds it must fit in 32 bits, as in MARS
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
  mapping,       ///< with the keys in `members`, or with any keys
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

/// The kinds of things that a text names.
struct Naming {
  NameKinds kinds = {};   ///< empty: the text is not a name
  bool defines = false;   ///< the text is the name of the entry
  bool is_vague = false;  ///< the name may be defined elsewhere, so only misspellings are reported
};
constexpr Naming defines(NameKinds kinds) { return {kinds, true, false}; }
constexpr Naming may_name(NameKinds kinds) { return {kinds, false, true}; }

/// Kinds of nodes in MARS. The inertia of a link is a node called `inertial_LINK`.
inline constexpr NameKinds kNodeKinds =
    NameKind::link | NameKind::visual | NameKind::collision | NameKind::node;

/// A key and its value. The texts go into the schema.
struct KeySpec {
  std::string_view name;
  ValueType type = ValueType::any;
  std::string_view doc = {};   ///< one sentence
  std::string_view unit = {};  ///< "rad/s"; may be empty
  std::string_view fallback =
      {};  ///< the default of MARS if the key is absent, as JSON text; may be empty
  /// Titles of readers, separated by commas, "Rock" or "nobody"; empty: the readers of the section.
  std::string_view read_by = {};
  bool required = false;
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool positive = false;  ///< a number that must be above 0
  bool is_limit = false;  ///< only compared; the largest double means "no limit"
  std::span<const std::string_view> choices = {};  ///< allowed texts; empty: any
  KeyTable members = {};  ///< keys of a mapping, or of the mappings in a list
  /// Kinds of things that its text names, or each text of its list, or each key of a number_map.
  /// References are found by this (link/references.cpp).
  Naming names = {};
  Naming (*names_in)(yaml::View entry) = nullptr;  ///< if it depends on the rest of the entry
  bool is_path = false;  ///< the value is a file name, relative to the folder of its file
};

inline std::span<const KeySpec> KeyTable::keys() const { return {first, size}; }

/// Bounds of a number, both inclusive; infinite where there are none.
struct Bounds {
  double minimum = 0;
  double maximum = 0;
};
Bounds bounds_of(const KeySpec& spec);

/// Names of the numbers in a mapping of this type: x, y, z for a vector3. Empty for other types.
std::span<const std::string_view> components_of(ValueType type);

template <class T>
using Member = std::variant<std::monostate, Field<std::string> T::*, Field<double> T::*,
                            Field<std::int64_t> T::*, Field<bool> T::*, Field<NameList> T::*,
                            Field<Vector3> T::*, Field<Color> T::*>;

/// A key and the member for its value; without a member, the value is only in the tree.
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

/// Checks a mapping against a table without members; `what` names it in messages.
void check_keys(std::span<const KeySpec> keys, yaml::View mapping, std::string_view what,
                DiagnosticSink& sink);

/// The differences between the keys of a mapping and its tables.
struct KeyDifference {
  std::vector<const KeySpec*> missing;  ///< required, but absent
  std::vector<yaml::View> unknown;      ///< present, but in no table
  std::vector<std::string_view> known;  ///< all keys of the tables, for finding misspellings
};

/// Whether the reader of the keys reports misspelt keys.
enum class Slips : std::uint8_t { ignored, reported };

/// Reports SML4004 for each required key that is absent in `mapping`, a `what` ("motor"), and
/// SML4005 for each unknown key that is a misspelling of a known key.
void report_difference(const KeyDifference& difference, yaml::View mapping, std::string_view what,
                       DiagnosticSink& sink);

/// The type of a quoted scalar without its quotes; text for other scalars.
yaml::ScalarType type_without_quotes(yaml::View value);

/// The key of an entry after which a missing key belongs: its position in other entries of the
/// list, else at the end.
Span place_to_add(yaml::View entry, std::string_view key);

/// The bytes of a scalar within its quotes, if it has any, so that an edit keeps them (JSON).
Span within_quotes(yaml::View value);
/// The same bytes if they are exactly `text`; none for blocks and for scalars with
/// escapes.
std::optional<Span> within_quotes(Span scalar, std::string_view text);

/// "a number", "a list of names": for messages.
std::string_view describe(ValueType type);
/// A description of the value for messages: "a list", "the text `abc`".
std::string describe(yaml::View value);

/// Rows in addition to the section's own table: they have no members and are optional.
using MoreKeys = std::initializer_list<std::span<const KeySpec>>;

/// The row in the first table that has the key; null if none has it.
const KeySpec* find_key(MoreKeys tables, std::string_view name);

/// No table with members is larger.
inline constexpr std::size_t kMostKeys = 64;

/// Reads `mapping` into `out` by tables. Keys without a row stay in the tree.
template <class T>
void read_keys(std::span<const Key<T>> keys, MoreKeys more, yaml::View mapping, T& out,
               std::string_view what, DiagnosticSink& sink, Slips slips = Slips::ignored) {
  assert(keys.size() <= kMostKeys);
  std::bitset<kMostKeys> seen;
  std::bitset<kMostKeys> given;
  KeyDifference difference;
  std::size_t i = 0;
  for (const yaml::View value : mapping) {
    // The search starts at the last row found, because most entries have the order of the table.
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

/// Reads an entry of a list, and stores its place in `out`.
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

/// Selects rows; null: all.
using KeyFilter = bool (*)(const KeySpec&);

/// All rows of an entry, for the schema; a name in several tables appears once.
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
