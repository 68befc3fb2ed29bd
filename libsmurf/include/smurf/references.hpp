// SPDX-License-Identifier: BSD-3-Clause
// Every definition and every use of a name in a model or a scene.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "smurf/linked.hpp"
#include "smurf/names.hpp"
#include "smurf/source.hpp"
#include "smurf/xacro.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// A place where a name is written. `name` points into the model.
struct Reference {
  static constexpr std::uint32_t kNothing = 0xffffffffU;
  enum class Notation : std::uint8_t { yaml, yaml_key, xml_attribute, xml_text, program };
  /// In a file around the robot, which the robot may share with others that have the name, too.
  enum class Around : std::uint8_t {
    no,
    own,     ///< a file that is given to the robot
    any,     ///< a file that other robots may have as well
    memory,  ///< the same, and its reader ignores a name that it does not know
  };

  /// The kind of the named thing; for an unknown name, the first allowed kind.
  NameKind kind{};
  Notation notation{};
  bool is_definition = false;
  /// The name may be defined elsewhere: in another robot of the scene, or in a program.
  bool is_vague = false;
  /// The name is made by an expression of xacro; `span` is the expression.
  bool is_computed = false;
  Around around = Around::no;
  NameKinds kinds;  ///< all allowed kinds
  /// The yaml::NodeId or xml::ElementId; of a key, the node under it.
  std::uint32_t place = kNothing;
  std::string_view name;  ///< decoded
  Span span;              ///< span of the name without quotes; for `inertial_LINK`, span of LINK
  /// The whole text that contains the name: a YAML scalar with its quotes, or an attribute value
  /// without quotes. Where the text is a YAML alias, `span` is the alias.
  Span text;
  /// The named thing as in NameTable: the index of a link, joint, motor or sensor; for a visual or
  /// collision, the index of its link; for an entity, its number in the scene files. kNothing: the
  /// name is unknown.
  std::uint32_t item = kNothing;
  ModelIndex model{kNothing};  ///< in a scene: the model with the name; kNothing for entities
  /// The pieces of a computed name that stand in a file; positions are those in the name.
  std::vector<xacro::Copied> copied = {};

  bool is_known() const { return item != kNothing; }
};

/// All references of a model, file by file. In custom sections and extensions that no reader knows,
/// texts are references if they equal the name of something.
std::vector<Reference> references_of(const LinkedModel& model);
/// The references in an SRDF to the model. Their `name` points into the SRDF.
std::vector<Reference> references_of(const LinkedModel& model, const xml::Document& srdf);
/// All references of a scene: those in its scene files, then those in its models.
std::vector<Reference> references_of(const LinkedScene& scene);

/// Moves references in an expanded robot to the places in the xacro files where the names are
/// written.
void place_in_xacro(const xacro::Expansions& expansions, std::vector<Reference>& references);

/// The references in a model whose name is unknown, or names a thing of another kind than expected.
/// Omits the others, so it is cheaper than references_of().
std::vector<Reference> doubtful_references(const LinkedModel& model);

}  // namespace smurf
