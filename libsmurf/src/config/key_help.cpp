// SPDX-License-Identifier: BSD-3-Clause
#include "config/key_help.hpp"

#include <algorithm>
#include <utility>

#include "ast/known_words.hpp"
#include "ast/model_reader.hpp"
#include "ast/scene_keys.hpp"
#include "ast/sections.hpp"
#include "ast/urdf_schema.hpp"
#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "smurf/config.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/readers.hpp"

namespace smurf {
namespace {

constexpr std::string_view kBooleans[] = {"true", "false"};
constexpr std::string_view kLevels[] = {"error", "warning", "info"};
constexpr std::string_view kThresholds[] = {"error", "warning", "info", "never"};

ValueForm form_of(ValueType type) {
  switch (type) {
  case ValueType::boolean: return ValueForm::boolean;
  case ValueType::names: return ValueForm::any;
  case ValueType::name_list:
  case ValueType::number_list:
  case ValueType::vector3_list:
  case ValueType::position:
  case ValueType::list: return ValueForm::list;
  case ValueType::number_map:
  case ValueType::vector2:
  case ValueType::vector3:
  case ValueType::quaternion:
  case ValueType::orientation:
  case ValueType::color:
  case ValueType::mapping: return ValueForm::mapping;
  case ValueType::rotation:
  case ValueType::any: return ValueForm::any;
  default: return ValueForm::scalar;
  }
}

/// All kinds that the key may name, if they depend on the rest of the entry.
NameKinds kinds_of(const KeySpec& spec) {
  return spec.names_in == nullptr
             ? spec.names.kinds
             : NameKind::joint | NameKind::motor | NameKind::link | NameKind::collision;
}

/// `read_by` names the readers of the section, for keys without separate readers.
KeyHelp help_of(const KeySpec& spec, std::string_view owner, std::string_view read_by = {}) {
  KeyHelp help{std::string(owner), std::string(spec.name), spec.doc, describe(spec.type),
               spec.unit,          spec.fallback};
  help.read_by = spec.read_by.empty() ? read_by : spec.read_by;
  help.required = spec.required;
  help.form = form_of(spec.type);
  help.choices.assign(spec.choices.begin(), spec.choices.end());
  const auto known = known_words(owner, spec.name);
  help.known.assign(known.begin(), known.end());
  if (spec.type == ValueType::boolean) help.choices.assign(kBooleans, std::end(kBooleans));
  help.names = kinds_of(spec);
  help.defines = spec.names.defines;
  help.is_path = spec.is_path;
  help.is_color = spec.type == ValueType::color;
  return help;
}

/// The keys that may occur at a place, and the keys below each of them.
struct Place {
  std::string_view owner;
  std::vector<const KeySpec*> keys;
  const SectionSpec* section = nullptr;  ///< the value of this key, before an entry is chosen
  const KeySpec* key = nullptr;          ///< the key with this value
  std::string_view read_by = {};         ///< readers of the section or key around it
};

std::vector<const KeySpec*> rows_of(std::span<const KeySpec> table) {
  std::vector<const KeySpec*> rows;
  for (const KeySpec& spec : table) rows.push_back(&spec);
  return rows;
}

const KeySpec* find_row(const Place& place, std::string_view name) {
  const auto found = std::find_if(place.keys.begin(), place.keys.end(),
                                  [&](const KeySpec* one) { return one->name == name; });
  return found == place.keys.end() ? nullptr : *found;
}

Place value_of(const KeySpec& row) {
  const bool is_list = row.type == ValueType::list;
  return {row.name, is_list ? std::vector<const KeySpec*>() : rows_of(row.members.keys()), nullptr,
          &row, row.read_by};
}

Place value_of(const SectionSpec& section) {
  Place place{section.entry, {}, &section, nullptr, section.read_by};
  if (section.form == SectionForm::list_or_mapping) place.keys = section.keys();
  return place;
}

Place root_of(KeyLanguage language) {
  if (language == KeyLanguage::scene) return {"scene", rows_of(scene_keys())};
  if (language != KeyLanguage::main) return {"annotation file", {}};
  Place root{"main file", {}};
  for (const Key<Model>& key : main_keys()) root.keys.push_back(&key.spec);
  return root;
}

bool has_sections(KeyLanguage language) {
  return language == KeyLanguage::main || language == KeyLanguage::annotation;
}

/// A scene has a separate set of keys.
const SectionSpec* section_at_root(KeyLanguage language, std::string_view name) {
  if (language == KeyLanguage::scene && name != "lights") return nullptr;
  return find_section(name);
}

Place step_into(const Place& place, std::string_view step, KeyLanguage language, bool is_root) {
  if (is_root) {
    if (const SectionSpec* section = section_at_root(language, step)) return value_of(*section);
  }
  if (place.section != nullptr && place.section->form == SectionForm::named) {
    return {place.section->entry, place.section->keys()};
  }
  if (step == kItem) {
    if (place.section != nullptr) return {place.section->entry, place.section->keys()};
    if (place.key != nullptr) return {place.key->name, rows_of(place.key->members.keys())};
    return {};
  }
  if (const KeySpec* row = find_row(place, step)) {
    if (row->name == "poses" && language == KeyLanguage::scene) return value_of(sections::poses);
    return value_of(*row);
  }
  return {};
}

Place place_at(KeyLanguage language, std::span<const std::string> path) {
  Place place = root_of(language);
  for (std::size_t i = 0; i < path.size(); ++i) {
    Place next = step_into(place, path[i], language, i == 0);
    if (next.read_by.empty()) next.read_by = place.read_by;
    place = std::move(next);
    // Nothing is known below, however deep the path is.
    if (place.keys.empty() && place.section == nullptr && place.key == nullptr) break;
  }
  return place;
}

KeyHelp help_of(const SectionSpec& section, std::string_view name) {
  KeyHelp help{"section", std::string(name), section.doc, "a list of mappings"};
  help.read_by = section.read_by;
  help.form = ValueForm::list;
  if (section.form == SectionForm::named) help.form = ValueForm::mapping;
  return help;
}

std::string_view value_of(SettingType type) {
  switch (type) {
  case SettingType::files: return "a path or a list of paths";
  case SettingType::rules: return "a list of rules";
  case SettingType::targets: return "a list of readers";
  case SettingType::formats: return "a list of FORMAT[=FILE]";
  case SettingType::patterns: return "a list of patterns";
  case SettingType::levels: return "a mapping from rules to severities";
  case SettingType::tolerances: return "a mapping from rules to numbers";
  case SettingType::paths: return "a mapping from patterns to settings";
  case SettingType::folders: return "a mapping from names to folders";
  case SettingType::schemas: return "a mapping from names to files";
  case SettingType::threshold: return "error, warning, info or never";
  case SettingType::count: return "a whole number";
  case SettingType::boolean: return "true or false";
  case SettingType::file: return "a path";
  case SettingType::xacro:
    return "a list of robots: `file`, and `arguments` with values or lists of values";
  case SettingType::companions: return "a list of robots: `robot`, and `files` that belong to it";
  }
  return {};
}

ValueForm form_of(SettingType type) {
  switch (type) {
  case SettingType::rules:
  case SettingType::targets:
  case SettingType::formats:
  case SettingType::xacro:
  case SettingType::companions:
  case SettingType::patterns: return ValueForm::list;
  case SettingType::levels:
  case SettingType::tolerances:
  case SettingType::paths:
  case SettingType::folders:
  case SettingType::schemas: return ValueForm::mapping;
  case SettingType::boolean: return ValueForm::boolean;
  default: return ValueForm::scalar;
  }
}

std::vector<std::string_view> choices_of(SettingType type) {
  switch (type) {
  case SettingType::boolean: return {std::begin(kBooleans), std::end(kBooleans)};
  case SettingType::threshold: return {std::begin(kThresholds), std::end(kThresholds)};
  case SettingType::levels: return {std::begin(kLevels), std::end(kLevels)};
  case SettingType::targets: return target_names();
  case SettingType::rules: return rule_words();
  default: return {};
  }
}

KeyHelp help_of(const SettingSpec& setting) {
  KeyHelp help{"configuration", std::string(setting.name), setting.doc, value_of(setting.type)};
  help.form = form_of(setting.type);
  help.choices = choices_of(setting.type);
  help.is_path = setting.type == SettingType::files || setting.type == SettingType::file;
  return help;
}

/// Settings, settings of the files of a pattern, and rules.
std::vector<KeyHelp> settings_in(std::span<const std::string> path) {
  const bool is_of_pattern = path.size() == 2 && path[0] == "paths";
  std::vector<KeyHelp> keys;
  if (path.empty() || is_of_pattern) {
    for (const SettingSpec& one : is_of_pattern ? config_path_settings() : config_settings()) {
      keys.push_back(help_of(one));
    }
  } else if (path.back() == "severity" || path.back() == "tolerances") {
    const bool are_tolerances = path.back() == "tolerances";
    for (const Rule* rule : all_rules()) {
      if (are_tolerances && rule->tolerance.meaning.empty()) continue;
      KeyHelp help{"rule", std::string(rule->name), rule->summary,
                   are_tolerances ? "a number" : "error, warning or info"};
      help.unit = rule->tolerance.unit;
      if (!are_tolerances) help.choices = choices_of(SettingType::levels);
      keys.push_back(std::move(help));
    }
  }
  return keys;
}

/// In the order of urdf::Form.
constexpr std::string_view kForms[] = {"a number", "three numbers", "four numbers", "a text"};

KeyHelp help_of(const urdf::AttributeSpec& attribute, std::string_view element) {
  KeyHelp help{std::string(element), std::string(attribute.name),
               attribute.doc,        kForms[static_cast<std::size_t>(attribute.form)],
               attribute.unit,       attribute.fallback};
  help.required = attribute.is_required();
  help.is_usual = attribute.need != urdf::Need::optional;
  help.choices.assign(attribute.values.begin(), attribute.values.end());
  help.names = attribute.names;
  help.is_path = attribute.is_path;
  help.is_color = attribute.name == "rgba";
  return help;
}

/// Calls `visit` with the prefix of a key's full name ("motors" of "motors.maxEffort"), and the
/// key.
template <class Visit>
void for_each_key(const Visit& visit) {
  for (const SectionSpec* section : all_sections()) {
    visit(std::string_view(), help_of(*section, section->name));
    for (const KeySpec* spec : section->keys()) {
      visit(section->name, help_of(*spec, section->entry, section->read_by));
    }
  }
  for (const Key<Model>& key : main_keys()) visit("smurf", help_of(key.spec, "main file"));
  for (const KeySpec& spec : scene_keys()) visit("smurfs", help_of(spec, "scene"));
  for (const KeySpec& spec : all_entity_keys()) visit("entities", help_of(spec, "entity"));
  for (const KeySpec& spec : all_physics_keys()) visit("physics", help_of(spec, "physics"));
  for (const KeySpec& spec : environment_keys()) {
    visit("environment", help_of(spec, "environment"));
  }
  for (const SettingSpec& setting : config_settings()) visit("config", help_of(setting));
  for (const urdf::ElementSpec& element : urdf::all_element_specs()) {
    for (const urdf::AttributeSpec& attribute : element.attributes) {
      visit(element.name, help_of(attribute, element.name));
    }
  }
}

}  // namespace

std::optional<KeyLanguage> key_language(std::string_view path) {
  if (path::file_name(path) == kConfigName) return KeyLanguage::configuration;
  const std::string extension = path::to_lower(path::extension(path));
  if (extension == ".smurf") return KeyLanguage::main;
  if (extension == ".smurfs" || extension == ".smurfa") return KeyLanguage::scene;
  if (extension == ".yml" || extension == ".yaml") return KeyLanguage::annotation;
  return std::nullopt;
}

KeyPath key_path(const yaml::Document& document, yaml::NodeId id) {
  KeyPath path;
  while (id != yaml::kNoNode && id != document.root) {
    const yaml::Node& node = document.nodes[static_cast<std::size_t>(id)];
    path.emplace_back(node.key_span().empty() ? kItem : node.key());
    id = node.parent;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<KeyHelp> keys_in(KeyLanguage language, std::span<const std::string> path) {
  if (language == KeyLanguage::configuration) return settings_in(path);
  std::vector<KeyHelp> keys;
  const Place place = place_at(language, path);
  for (const KeySpec* spec : place.keys) keys.push_back(help_of(*spec, place.owner, place.read_by));
  if (place.key != nullptr && place.keys.empty()) {
    for (const std::string_view part : components_of(place.key->type)) {
      keys.push_back({std::string(place.key->name), std::string(part), {}, "a number"});
    }
  }
  if (path.empty() && has_sections(language)) {
    for (const SectionSpec* section : all_sections()) {
      keys.push_back(help_of(*section, section->name));
    }
  }
  return keys;
}

std::optional<KeyHelp> key_help(KeyLanguage language, std::span<const std::string> path) {
  if (path.empty()) return std::nullopt;
  const std::string& name = path.back();
  if (path.size() == 1 && has_sections(language)) {
    if (const SectionSpec* section = find_section(name)) return help_of(*section, name);
  }
  const auto around = path.first(path.size() - 1);
  if (language != KeyLanguage::configuration) {
    const Place place = place_at(language, around);
    if (const KeySpec* row = find_row(place, name))
      return help_of(*row, place.owner, place.read_by);
    if (!place.keys.empty() || place.key == nullptr) return std::nullopt;
  }
  for (KeyHelp& help : keys_in(language, around)) {
    if (help.name == name) return std::move(help);
  }
  return std::nullopt;
}

std::optional<ElementHelp> element_help(std::string_view name) {
  const urdf::ElementSpec* spec = urdf::find_element_spec(name);
  if (spec == nullptr) return std::nullopt;
  ElementHelp help{spec->name, spec->doc, {}, {}, {}};
  for (const urdf::AttributeSpec& attribute : spec->attributes) {
    help.attributes.push_back(help_of(attribute, spec->name));
  }
  for (const urdf::ChildSpec& child : spec->children) {
    help.children.push_back(child.name);
    if (child.is_usual) help.usual_children.push_back(child.name);
  }
  return help;
}

std::string_view root_element() { return urdf::all_element_specs().front().name; }

std::vector<KeyHelp> find_keys(std::string_view name) {
  std::vector<KeyHelp> found;
  for_each_key([&](std::string_view owner, const KeyHelp& help) {
    const std::string whole = owner.empty() ? help.name : std::string(owner) + "." + help.name;
    const bool is_named =
        name == help.name || name == whole || name == help.owner + "." + help.name;
    if (is_named) found.push_back(help);
  });
  return found;
}

}  // namespace smurf
