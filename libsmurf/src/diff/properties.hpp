// SPDX-License-Identifier: BSD-3-Clause
// Things with names, and their values as trees of properties, which are compared. Every property
// knows its place in the source, but not how it was written.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diff.hpp"
#include "smurf/names.hpp"
#include "smurf/references.hpp"
#include "smurf/source.hpp"

namespace smurf {

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// A value, or a group of values with keys. A file of a megabyte has hundreds of thousands, so they
/// refer to the model where possible.
struct Property {
  enum class Form : std::uint8_t {
    absent,
    boolean,   ///< numbers[0] is 0 or 1
    number,    ///< numbers[0]
    text,      ///< text
    texts,     ///< a list of texts only, such as names
    numbers,   ///< numbers
    rotation,  ///< numbers: w, x, y, z, of unit length
    pose,      ///< numbers: x, y, z, then w, x, y, z
    file,      ///< text: its name as written; path: its resolved path
    list,      ///< members, in their order
    group,     ///< members, in any order, with keys
    choice     ///< one of several types for an element: text
  };

  std::string_view key;
  Span key_span;  ///< place of a key that is a renamable name; otherwise empty
  Span span;
  Form form = Form::absent;
  bool is_default = false;  ///< equal to the default of readers
  std::string_view unit;
  std::string_view fallback;
  std::span<const std::string_view> parts;  ///< names of `numbers`
  std::string text;
  std::string_view path;
  std::vector<Spanned<std::string_view>> texts;
  std::vector<double> numbers;
  std::vector<Property> members;

  bool has_members() const {
    return form == Form::list || form == Form::group || form == Form::choice;
  }
};

/// A thing, such as a link, motor or entity, that is added, removed and renamed as a whole.
struct Thing {
  std::string kind;  ///< "link"
  std::string name;  ///< may be empty
  std::string path;  ///< in nested scenes, with the names of outer scenes; otherwise empty
  Span place;        ///< place of the name, or of the whole thing
  std::optional<NameKind> names;  ///< the kind of its name, if other things name it
  std::size_t parent = kNone;     ///< the thing that contains it; has a smaller index
  std::size_t brings = kNone;     ///< for an entity that includes a scene: that scene file
  bool is_scene = false;          ///< a scene file, identified by the entity that includes it
  Property properties;            ///< a group
};

/// All things of a model or a scene, in the order of the files.
struct Things {
  std::vector<Thing> all;
  std::vector<std::size_t> links, joints;  ///< by LinkIndex and JointIndex
  const KinematicTree* tree = nullptr;     ///< of a model with a robot
  std::vector<Reference> references;       ///< sorted by place
};

/// Leaves of properties.
Property number_property(std::string_view key, double value, Span span, std::string_view unit = {});
Property text_property(std::string_view key, std::string_view text, Span span);
Property texts_property(std::string_view key, std::vector<Spanned<std::string_view>> texts,
                        Span span);
Property numbers_property(std::string_view key, std::vector<double> values, Span span,
                          std::string_view unit = {});
Property pose_property(std::string_view key, const Pose& pose, Span span);
Property rotation_property(std::string_view key, const Quaternion& rotation, Span span);
Property group_property(std::string_view key, Span span);

/// Adds a member; a number is added to an existing key.
void add_member(Property& group, Property member);

Pose pose_of(const Property& property);
Quaternion rotation_of(const Property& property);
/// Renames a text that is written at a place.
using NameAt = std::function<std::string(std::string_view text, Span place)>;
/// The value, after renaming texts with `name_at` if it is given.
DiffValue value_of(const Property& property, const NameAt& name_at = {});
/// One line for people; for a group, its members; "none" if it is absent.
std::string summary_of(const Property& property);

/// Whether both values mean the same. `before` is the old text with the names of the new version.
bool is_same_leaf(const Property& before, std::string_view text_before, const Property& after,
                  double tolerance);

}  // namespace smurf
