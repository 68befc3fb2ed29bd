// SPDX-License-Identifier: BSD-3-Clause
// Which keys a file may have, and what they mean: for people who write one. Made from the tables
// that the readers use.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/names.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// Which keys a YAML file may have.
enum class KeyLanguage : std::uint8_t { main, annotation, scene, configuration };
/// By the name of a file; none for one that is no YAML.
std::optional<KeyLanguage> key_language(std::string_view path);

/// How a value is written.
enum class ValueForm : std::uint8_t { scalar, boolean, list, mapping, any };

/// A key of a YAML file, or an attribute of a URDF.
struct KeyHelp {
  std::string owner;            ///< "motor", "scene", "limit"
  std::string name;             ///< "maxEffort"
  std::string_view doc = {};    ///< one sentence
  std::string_view value{};     ///< "a number"
  std::string_view unit{};      ///< "N m or N"; may be empty
  std::string_view fallback{};  ///< what is taken when it is absent, as JSON; may be empty
  std::string_view read_by{};   ///< the programs, as text; may be empty
  bool required = false;
  ValueForm form = ValueForm::scalar;
  bool is_usual = false;  ///< without it, an element of a URDF makes little sense
  std::vector<std::string_view> choices = {};  ///< the only values; empty: any
  std::vector<std::string_view> known = {};    ///< words that readers know, among others
  NameKinds names = {};                        ///< what the value is the name of
  bool defines = false;                        ///< the thing gets its name here
  bool is_path = false;                        ///< of a file, relative to the folder of this one
  bool is_color = false;
};

/// The item of a list, in a path of keys.
inline constexpr std::string_view kItem = "-";
/// From the root of a YAML file: {"motors", "-", "joint"}.
using KeyPath = std::vector<std::string>;
/// The path of a node.
KeyPath key_path(const yaml::Document& document, yaml::NodeId id);

/// The keys that the mapping at a path may have.
std::vector<KeyHelp> keys_in(KeyLanguage language, std::span<const std::string> path);
/// The last key of a path; none when no table has it.
std::optional<KeyHelp> key_help(KeyLanguage language, std::span<const std::string> path);

/// An element of a URDF.
struct ElementHelp {
  std::string_view name;
  std::string_view doc;
  std::vector<KeyHelp> attributes;
  std::vector<std::string_view> children;
  std::vector<std::string_view> usual_children;  ///< without them it makes no sense
};
/// None for one that URDF does not define.
std::optional<ElementHelp> element_help(std::string_view name);
/// The root element of a document.
std::string_view root_element();

/// Meaning, value, unit, default and readers; the first line is the name. Names are in backticks.
std::vector<std::string> describe(const KeyHelp& help);

/// All keys of this name: "maxEffort", or "motors.maxEffort" and "limit.effort" for one of them.
std::vector<KeyHelp> find_keys(std::string_view name);
/// The names that find_keys() knows.
std::vector<std::string> key_names();

}  // namespace smurf
