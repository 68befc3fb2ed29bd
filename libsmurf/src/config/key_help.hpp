// SPDX-License-Identifier: BSD-3-Clause
// Describes the keys that a file may have, for people who write one. Generated from the tables that
// the readers use.
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
/// The kind of a file, by its name; none for files that are not YAML.
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
  std::string_view fallback{};  ///< the default as JSON; may be empty
  std::string_view read_by{};   ///< the programs, as text; may be empty
  bool required = false;
  ValueForm form = ValueForm::scalar;
  bool is_usual = false;                       ///< an element of a URDF is incomplete without it
  std::vector<std::string_view> choices = {};  ///< the allowed values; empty: any
  std::vector<std::string_view> known = {};    ///< values that readers know; others are allowed
  NameKinds names = {};                        ///< the kinds of things that the value can name
  bool defines = false;                        ///< the value is the name of this entry
  bool is_path = false;  ///< the value is a file name, relative to the folder of this file
  bool is_color = false;
};

/// Stands for an item of a list in a path of keys.
inline constexpr std::string_view kItem = "-";
/// Path from the root of a YAML file: {"motors", "-", "joint"}.
using KeyPath = std::vector<std::string>;
/// The path of a node.
KeyPath key_path(const yaml::Document& document, yaml::NodeId id);

/// The keys that the mapping at a path may have.
std::vector<KeyHelp> keys_in(KeyLanguage language, std::span<const std::string> path);
/// The last key of a path; none if no table has the key.
std::optional<KeyHelp> key_help(KeyLanguage language, std::span<const std::string> path);

/// An element of a URDF.
struct ElementHelp {
  std::string_view name;
  std::string_view doc;
  std::vector<KeyHelp> attributes;
  std::vector<std::string_view> children;
  std::vector<std::string_view> usual_children;  ///< an element without them is incomplete
};
/// None for an element that URDF does not define.
std::optional<ElementHelp> element_help(std::string_view name);
/// The root element of a document.
std::string_view root_element();

/// Meaning, value, unit, default and readers; the first line is the name. Names are in backticks.
std::vector<std::string> describe(const KeyHelp& help);

/// All keys of this name: "maxEffort" finds several, "motors.maxEffort" or "limit.effort" one.
std::vector<KeyHelp> find_keys(std::string_view name);

}  // namespace smurf
