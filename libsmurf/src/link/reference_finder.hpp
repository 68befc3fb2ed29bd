// SPDX-License-Identifier: BSD-3-Clause
// The only code that knows where names are used: in rows of key tables for YAML, in elements and
// attributes for URDF and SRDF.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ast/sections.hpp"
#include "smurf/companions.hpp"
#include "smurf/references.hpp"

namespace smurf {

/// The place of a name, as in Reference.
struct NamePlace {
  Reference::Notation notation{};
  std::uint32_t place = Reference::kNothing;
  Span span, text;
};
/// The place of the name in a scalar, in a key, or in an attribute value.
NamePlace place_of_name(yaml::View scalar);
NamePlace place_of_key(yaml::View member);
NamePlace place_of_value(xml::View element, const xml::Attribute& attribute);
/// A part of the name: `size` bytes from `offset` on.
NamePlace part_of(NamePlace place, std::size_t offset, std::size_t size);

/// Whether a word means an address ("topicName"): "/arm/elbow" is then not a joint.
bool is_address(std::string_view word);
/// The kinds of things that a word ("jointName", "base_link") suggests.
NameKinds kinds_in_word(std::string_view word);

class ReferenceFinder {
 public:
  enum class Keep : std::uint8_t { all, doubtful };
  ReferenceFinder(const LinkedModel& model, Keep keep) : model_(model), keep_(keep) {}

  void read_annotations();
  void read_urdf();
  void read_companion(const Companion& companion);
  /// Where the names that follow stand.
  void set_around(Reference::Around around) { around_ = around; }
  /// Makes the groups of an SRDF known.
  void add_groups(const srdf::Description& srdf);
  /// Reads the names in a value by its row, including lists and mappings of names.
  void read_key(const KeySpec& row, yaml::View value, yaml::View entry);
  /// Reads joint pose sets in the form of `poses`.
  void read_section(const SectionSpec& section, yaml::View value);
  void add(const Naming& naming, std::string_view name, const NamePlace& place);
  /// Adds a name of the first of these kinds that has it, if any.
  bool add_if_known(NameKinds kinds, std::string_view name, const NamePlace& place);
  /// An element that no reader knows.
  void read_extension(xml::View element);
  std::vector<Reference> take() { return std::exchange(found_, {}); }

  /// The things of this name; none if there are none.
  std::optional<std::uint32_t> find(NameKind kind, std::string_view name);

 private:
  bool keeps_all() const { return keep_ == Keep::all; }
  void keep(const Reference& reference);
  bool resolve(Reference& reference);

  using Rows = std::vector<const KeySpec*>;  ///< rows of a section
  /// `all` is empty unless unknown keys are kept, too.
  void read_entry(const Rows& all, const Rows& rows, yaml::View entry);
  void read_members(KeyTable members, yaml::View value);
  /// Keys without a row: their words decide whether they name something.
  void read_unknown(yaml::View value, std::string_view word);

  void read_field(const Naming& naming, const Field<std::string>& field, xml::ElementId element);
  void read_link(const urdf::Link& link);
  void read_end(const urdf::Joint& joint, std::string_view end, const Field<std::string>& link);
  void read_material(xml::View material);
  /// Elements in it that URDF does not define.
  void read_inner(xml::View element);
  void read_attributes(xml::View element);
  void read_text(xml::View element);
  bool read_part(std::string_view text, std::string_view part, NameKinds kinds,
                 const NamePlace& place);
  void read_gazebo_name(std::string_view text, const NamePlace& place);
  void read_groups(xml::View root);

  const LinkedModel& model_;
  Keep keep_;
  std::vector<Reference> found_;
  std::optional<NameTable> nodes_, poses_;
  NameTable groups_;
  Reference::Around around_ = Reference::Around::no;
};

}  // namespace smurf
