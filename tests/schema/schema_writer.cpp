// SPDX-License-Identifier: BSD-3-Clause
// One property per table row. A constraint that a row cannot express is not in the schema either,
// so that readers and schemas agree; schema_equality_test proves it.
#include "schema/schema_writer.hpp"

#include <cmath>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "ast/model_reader.hpp"
#include "ast/scene_keys.hpp"
#include "ast/sections.hpp"
#include "base/numbers/numbers.hpp"
#include "schema/ros_schemas.hpp"
#include "schema/schema_head.hpp"
#include "smurf/config.hpp"
#include "smurf/readers.hpp"

namespace smurf::test {
namespace {

constexpr const char* kScalars[] = {"string", "number", "boolean"};

Json reference(std::string_view section) { return {{"$ref", file_name(section)}}; }

/// 0 rather than 0.0.
Json to_json(double number) {
  if (std::trunc(number) == number && std::abs(number) < 1e15) {
    return static_cast<std::int64_t>(number);
  }
  return number;
}

/// A null is allowed wherever the key may be absent.
Json types(std::vector<std::string> names, bool is_nullable) {
  if (is_nullable) names.emplace_back("null");
  if (names.size() == 1) return names.front();
  return names;
}

void add_bounds(Json& schema, Bounds bounds) {
  if (std::isfinite(bounds.minimum)) schema["minimum"] = to_json(bounds.minimum);
  if (std::isfinite(bounds.maximum)) schema["maximum"] = to_json(bounds.maximum);
}

void add_components(Json& schema, ValueType type) {
  for (const std::string_view name : components_of(type)) {
    Json component{{"type", types({"number"}, true)}};
    if (type == ValueType::color) add_bounds(component, {0, 1});
    schema["properties"][std::string(name)] = std::move(component);
  }
}

/// Words; numbers among them may be written as numbers, too.
Json enumeration(const KeySpec& spec) {
  Json values = Json::array();
  for (const std::string_view choice : spec.choices) {
    values.push_back(std::string(choice));
    if (const auto number = parse_number(choice)) values.push_back(to_json(*number));
  }
  if (!spec.required) values.push_back(nullptr);
  return values;
}

Json numbers(std::size_t count) {
  Json schema{{"items", {{"type", "number"}}}};
  if (count > 0) schema["minItems"] = schema["maxItems"] = count;
  return schema;
}

Json object_of(std::span<const KeySpec* const> keys);
std::vector<const KeySpec*> pointers(std::span<const KeySpec> keys);

Json rotation() {
  Json schema = numbers(0);
  schema["minItems"] = 1;
  schema["maxItems"] = 4;
  schema["not"] = {{"type", "array"}, {"minItems", 2}, {"maxItems", 2}};
  for (const std::string_view name : components_of(ValueType::rotation)) {
    schema["properties"][std::string(name)] = {{"type", "number"}};
    schema["required"].push_back(std::string(name));
  }
  return schema;
}

std::vector<std::string> type_names(ValueType type) {
  switch (type) {
  case ValueType::text:
  case ValueType::frame: return {std::begin(kScalars), std::end(kScalars)};
  case ValueType::number: return {"number"};
  case ValueType::integer: return {"integer"};
  case ValueType::names: return {"string", "number", "boolean", "array"};
  case ValueType::name_list:
  case ValueType::number_list:
  case ValueType::vector3_list:
  case ValueType::list: return {"array"};
  case ValueType::number_map:
  case ValueType::vector2:
  case ValueType::vector3:
  case ValueType::quaternion:
  case ValueType::orientation:
  case ValueType::color:
  case ValueType::mapping: return {"object"};
  case ValueType::position: return {"array", "object"};
  case ValueType::rotation: return {"number", "array", "object"};
  case ValueType::boolean:
  case ValueType::any: return {};
  }
  return {};
}

/// Mappings, or names for them.
Json items_of(const KeySpec& spec) {
  Json item = object_of(pointers(spec.members.keys()));
  if (!spec.names.kinds.empty()) item["type"] = {"object", "string", "number", "boolean"};
  return item;
}

/// The keywords besides `type`. Keywords for lists do not restrict mappings, and vice versa.
Json value_parts(const KeySpec& spec) {
  switch (spec.type) {
  case ValueType::names:
  case ValueType::name_list: return {{"items", {{"type", kScalars}}}};
  case ValueType::number_list: return numbers(0);
  case ValueType::vector3_list:
  case ValueType::position: return numbers(3);
  case ValueType::rotation: return rotation();
  case ValueType::number_map:
    return {{"additionalProperties", {{"type", types({"number"}, true)}}}};
  case ValueType::mapping:
    if (spec.members.size == 0) return Json::object();
    return object_of(pointers(spec.members.keys()));
  case ValueType::list:
    if (spec.members.size == 0) return Json::object();
    return {{"items", items_of(spec)}};
  default: return Json::object();
  }
}

Json schema_of(const KeySpec& spec) {
  Json schema = Json::object();
  schema["description"] =
      std::string(spec.doc) + (spec.unit.empty() ? "" : " [" + std::string(spec.unit) + "]");
  if (spec.type == ValueType::boolean) {
    schema["enum"] = {true, false, 1, 0};
    if (!spec.required) schema["enum"].push_back(nullptr);
  } else if (!spec.choices.empty()) {
    schema["enum"] = enumeration(spec);
  } else if (spec.type != ValueType::any) {
    schema["type"] = types(type_names(spec.type), !spec.required);
  }
  if (!spec.fallback.empty()) schema["default"] = Json::parse(spec.fallback);
  const Json parts = value_parts(spec);
  for (const auto& [keyword, value] : parts.items()) {
    if (keyword != "type") schema[keyword] = value;
  }
  if (spec.type != ValueType::rotation) add_components(schema, spec.type);
  if (spec.type == ValueType::number || spec.type == ValueType::integer) {
    add_bounds(schema, bounds_of(spec));
    if (spec.positive) schema["exclusiveMinimum"] = 0;
  }
  return schema;
}

std::vector<const KeySpec*> pointers(std::span<const KeySpec> keys) {
  std::vector<const KeySpec*> result;
  for (const KeySpec& key : keys) result.push_back(&key);
  return result;
}

/// In a scene, `lights` and `poses` are sections of annotations.
bool is_section(const KeySpec& spec) {
  return spec.type == ValueType::list && spec.members.size == 0 && find_section(spec.name);
}

Json object_of(std::span<const KeySpec* const> keys) {
  Json schema{{"type", "object"}};
  for (const KeySpec* key : keys) {
    if (key->required) schema["required"].push_back(std::string(key->name));
  }
  for (const KeySpec* key : keys) {
    schema["properties"][std::string(key->name)] =
        is_section(*key) ? reference(key->name) : schema_of(*key);
  }
  return schema;
}

Json section_schema(const SectionSpec& section) {
  Json schema =
      head(section.name, "SMURF annotation section " + std::string(section.name), section.doc);
  Json entry = object_of(section.keys());
  switch (section.form) {
  case SectionForm::list:
    schema["type"] = types({"array"}, true);
    schema["items"] = std::move(entry);
    break;
  case SectionForm::list_or_mapping:
    schema["type"] = types({"array", "object"}, true);
    if (entry.contains("required")) schema["required"] = entry["required"];
    schema["properties"] = entry["properties"];
    schema["items"] = std::move(entry);
    break;
  case SectionForm::named:
    schema["type"] = types({"object"}, true);
    schema["additionalProperties"] = std::move(entry);
    break;
  }
  return schema;
}

void add_sections(Json& schema) {
  for (const SectionSpec* section : all_sections()) {
    schema["properties"][std::string(section->name)] = reference(section->name);
    for (const std::string_view alias : section->aliases) {
      schema["properties"][std::string(alias)] = reference(section->name);
    }
  }
}

Json annotations_schema() {
  Json schema = head("annotations", "SMURF annotation file",
                     "A .yml file in the list `files` of a model: sections by name. Sections that "
                     "are not listed here may have any value.");
  schema["type"] = "object";
  add_sections(schema);
  return schema;
}

Json model_schema() {
  Json schema =
      head("smurf", "SMURF model (.smurf)",
           "The main file of a model: which files belong to it. It may contain sections of "
           "annotations itself.");
  schema.update(object_of(specs_of(main_keys())));
  add_sections(schema);
  return schema;
}

Json scene_schema() {
  Json schema = head("smurfs", "SMURF scene (.smurfs) or assembly (.smurfa)",
                     "Entities and where they are, and the world around them. Keys that are not "
                     "listed belong to plug-ins.");
  schema.update(object_of(pointers(scene_keys())));
  return schema;
}

Json one_or_more(const Json& item) {
  return {{"anyOf", {{{"type", "null"}}, item, {{"type", "array"}, {"items", item}}}}};
}

/// A mapping whose values are `value`.
Json map_to(const Json& value) {
  return {{"type", types({"object"}, true)}, {"additionalProperties", value}};
}

/// Names for completion; other texts are invalid.
Json words(std::span<const std::string_view> names) {
  Json values = Json::array();
  for (const std::string_view name : names) values.push_back(std::string(name));
  return {{"enum", std::move(values)}};
}

Json rule_patterns() {
  std::vector<std::string_view> names;
  for (const Rule* rule : all_rules()) names.push_back(rule->id);
  for (const Rule* rule : all_rules()) names.push_back(rule->name);
  return {{"anyOf", {words(names), {{"type", "string"}, {"pattern", "^SML[0-9]{0,3}$"}}}}};
}

Json tolerances() {
  Json schema{{"type", types({"object"}, true)}, {"additionalProperties", false}};
  for (const Rule* rule : all_rules()) {
    const Tolerance& tolerance = rule->tolerance;
    if (tolerance.meaning.empty()) continue;
    std::string doc(tolerance.meaning);
    if (!tolerance.unit.empty()) doc += " [" + std::string(tolerance.unit) + "]";
    for (const std::string_view name : {rule->id, rule->name}) {
      schema["properties"][std::string(name)] = {{"description", doc},
                                                 {"type", "number"},
                                                 {"minimum", 0},
                                                 {"default", to_json(tolerance.value)}};
    }
  }
  return schema;
}

Json object_of(std::span<const SettingSpec> settings);

/// Robots of xacro: a file, and values of its arguments.
Json xacro_setting() {
  const Json text{{"type", kScalars}};
  return {{"type", types({"array"}, true)},
          {"items",
           {{"type", "object"},
            {"additionalProperties", false},
            {"required", {"file"}},
            {"properties",
             {{"file", {{"type", "string"}}}, {"arguments", map_to(one_or_more(text))}}}}}};
}

Json companion_setting() {
  return {{"type", types({"array"}, true)},
          {"items",
           {{"type", "object"},
            {"additionalProperties", false},
            {"required", {"robot"}},
            {"properties",
             {{"robot", {{"type", "string"}}}, {"files", one_or_more({{"type", "string"}})}}}}}};
}

Json setting(SettingType type) {
  const Json text{{"type", kScalars}};
  const Json rule{{"$ref", "#/definitions/rule"}};
  const std::string_view levels[] = {"error", "warning", "info"};
  const std::string_view thresholds[] = {"error", "warning", "info", "never"};
  switch (type) {
  case SettingType::files:
  case SettingType::patterns: return one_or_more(text);
  case SettingType::formats:
    return one_or_more({{"type", "string"}, {"pattern", "^[a-z]+(=.*)?$"}});
  case SettingType::rules: return one_or_more(rule);
  case SettingType::targets: return one_or_more(words(target_names()));
  case SettingType::levels: {
    Json schema = map_to(words(levels));
    schema["propertyNames"] = rule;
    return schema;
  }
  case SettingType::tolerances: return tolerances();
  case SettingType::paths: return map_to(object_of(config_path_settings()));
  case SettingType::folders: return map_to(text);
  case SettingType::schemas:
    return {{"type", types({"object"}, true)},
            {"additionalProperties", false},
            {"properties", {{"entities", map_to(text)}, {"sections", map_to(text)}}}};
  case SettingType::threshold: {
    Json schema = words(thresholds);
    schema["enum"].push_back(nullptr);
    return schema;
  }
  case SettingType::count: return {{"type", types({"integer"}, true)}, {"minimum", 0}};
  case SettingType::boolean: return {{"type", types({"boolean"}, true)}};
  case SettingType::xacro: return xacro_setting();
  case SettingType::companions: return companion_setting();
  case SettingType::file: return {{"type", {"string", "number", "boolean", "null"}}};
  }
  return {};
}

Json object_of(std::span<const SettingSpec> settings) {
  Json schema{{"type", types({"object"}, true)}, {"additionalProperties", false}};
  for (const SettingSpec& spec : settings) {
    Json& property = schema["properties"][std::string(spec.name)];
    property["description"] = std::string(spec.doc);
    property.update(setting(spec.type));
  }
  return schema;
}

Json config_schema() {
  Json schema = head("config", "Configuration of smurf-lint (.smurf-lint.yaml)",
                     "What is checked, and how strictly. Paths are relative to the configuration.");
  schema.update(object_of(config_settings()));
  schema["definitions"]["rule"] = rule_patterns();
  return schema;
}

/// Indents by two spaces; values that fit are on one line.
void print(const Json& json, std::size_t indent, std::size_t used, std::string& out) {
  constexpr std::size_t kWidth = 100;
  const std::string line = json.dump(-1);
  if (!json.is_structured() || json.empty() || indent + used + line.size() <= kWidth) {
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      out += line[i];
      if (line[i] == '"' && (i == 0 || line[i - 1] != '\\')) is_quoted = !is_quoted;
      if (!is_quoted && (line[i] == ',' || line[i] == ':')) out += ' ';
    }
    return;
  }
  const std::string margin(indent + 2, ' ');
  out += json.is_array() ? "[" : "{";
  const char* separator = "\n";
  for (const auto& [key, value] : json.items()) {
    const std::string label = json.is_array() ? "" : Json(key).dump() + ": ";
    out += separator + margin + label;
    separator = ",\n";
    print(value, indent + 2, label.size() + 1, out);
  }
  out += "\n" + std::string(indent, ' ') + (json.is_array() ? "]" : "}");
}

}  // namespace

std::string to_text(const Json& json) {
  std::string text;
  print(json, 0, 0, text);
  return text + "\n";
}

std::map<std::string, std::string> write_schemas() {
  std::map<std::string, std::string> files;
  files[file_name("smurf")] = to_text(model_schema());
  files[file_name("smurfs")] = to_text(scene_schema());
  files[file_name("annotations")] = to_text(annotations_schema());
  files[file_name("config")] = to_text(config_schema());
  for (const SectionSpec* section : all_sections()) {
    files[file_name(section->name)] = to_text(section_schema(*section));
  }
  for (const auto& [name, schema] : ros_schemas()) files[file_name(name)] = to_text(schema);
  return files;
}

}  // namespace smurf::test
