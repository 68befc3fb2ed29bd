// SPDX-License-Identifier: BSD-3-Clause
// Files may contain parameters of other programs, so other keys are allowed. Launch files replace
// `$(...)`, so texts are allowed for numbers, too.
#include "schema/ros_schemas.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "ast/ros_parameters.hpp"

namespace smurf::test {
namespace {

constexpr const char* kPlaceholder = "^.*[$<{].*$";

Json number_or_placeholder(std::string_view type) {
  return {{"anyOf", Json::array({{{"type", std::string(type)}},
                                 {{"type", "string"}, {"pattern", kPlaceholder}}})}};
}

Json scalar(char type) {
  switch (type) {
  case 'd': return number_or_placeholder("number");
  case 'i': return number_or_placeholder("integer");
  case 'b': return number_or_placeholder("boolean");
  default: return {{"type", "string"}};
  }
}

/// 0 rather than 0.0.
Json number(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  return static_cast<double>(whole) == value ? Json(whole) : Json(value);
}

void add_condition(const ValueCondition& condition, Json& schema) {
  Json& target = schema.contains("anyOf") ? schema["anyOf"][0] : schema;
  switch (condition.kind) {
  case ValueCondition::Kind::above: target["exclusiveMinimum"] = number(condition.bound); break;
  case ValueCondition::Kind::at_least: target["minimum"] = number(condition.bound); break;
  case ValueCondition::Kind::below: target["exclusiveMaximum"] = number(condition.bound); break;
  case ValueCondition::Kind::at_most: target["maximum"] = number(condition.bound); break;
  case ValueCondition::Kind::unique: schema["uniqueItems"] = true; break;
  case ValueCondition::Kind::size:
    schema["minItems"] = schema["maxItems"] = static_cast<int>(condition.bound);
    break;
  case ValueCondition::Kind::one_of: {
    Json words = Json::array();
    for (const std::string_view one : condition.texts) words.push_back(std::string(one));
    // Editors offer the words; a text such as `$(var mode)` is filled in when the file is launched.
    target.erase("type");
    target["anyOf"] = Json::array({{{"enum", std::move(words)}}, {{"pattern", kPlaceholder}}});
    break;
  }
  }
}

Json value(const RosParameter& parameter) {
  const bool is_list = parameter.type >= 'A' && parameter.type <= 'Z';
  Json item = scalar(static_cast<char>(is_list ? parameter.type + 32 : parameter.type));
  Json schema;
  if (is_list) schema = {{"type", {"array", "string"}}};
  for (const ValueCondition& one : conditions_of(parameter)) {
    const bool is_of_list =
        one.kind == ValueCondition::Kind::unique || one.kind == ValueCondition::Kind::size;
    add_condition(one, is_list && is_of_list ? schema : item);
  }
  if (!is_list) return item;
  schema["items"] = std::move(item);
  return schema;
}

std::string description(const RosParameter& parameter, const std::string& readers) {
  std::string text(sentence_about(parameter.path));
  if (!text.empty()) text += " ";
  const std::string_view type = type_name(parameter);
  text += (type.starts_with('i') ? "An " : "A ") + std::string(type) + ".";
  if (!parameter.fallback.empty()) text += " Default: " + std::string(parameter.fallback) + ".";
  if (const std::string names = distribution_names(parameter.distributions); !names.empty()) {
    text += " Only in " + names + ".";
  }
  if (!readers.empty()) text += " Read by " + readers + ".";
  return text;
}

/// Adds a parameter to the tree of mappings: `*` are additionalProperties.
void add(const RosParameter& parameter, const std::string& readers, Json& root) {
  Json* at = &root;
  std::string_view path = parameter.path;
  while (true) {
    const std::size_t dot = path.find('.');
    const std::string name(path.substr(0, dot));
    Json& schema = name == "*" ? (*at)["additionalProperties"] : (*at)["properties"][name];
    if (dot == std::string_view::npos) {
      if (!schema.is_null()) return;  // another controller has it, too
      schema["description"] = description(parameter, readers);
      schema.update(value(parameter));
      return;
    }
    if (!schema.contains("type")) schema["type"] = {"object", "null"};
    at = &schema;
    path.remove_prefix(dot + 1);
  }
}

Json moveit_schema(const MoveitFile& file, const std::string& name) {
  Json schema = head(name, "MoveIt: " + std::string(file.name),
                     "Parameters that MoveIt reads; other keys are allowed.");
  schema["type"] = "object";
  for (const RosParameter& one : parameters_of(file)) add(one, "", schema);
  for (const char* wrapper : {"/**", "move_group", "ros__parameters", "robot_description_planning",
                              "robot_description_kinematics"}) {
    schema["properties"][wrapper] = {{"$ref", "#"}};
  }
  return schema;
}

/// The parameters of all classes: the class of a node is in another part of the file.
Json node_schema() {
  std::vector<std::pair<RosParameter, std::string>> all;
  for (const ControllerClass& type : controller_classes()) {
    const std::string reader(type.name.substr(type.name.find('/') + 1));
    for (const RosParameter& one : parameters_of(type)) {
      const auto known = std::find_if(
          all.begin(), all.end(), [&](const auto& other) { return other.first.path == one.path; });
      if (known == all.end()) {
        all.emplace_back(one, reader);
      } else if (known->second.find(reader) == std::string::npos) {
        known->second += ", " + reader;
      }
    }
  }
  Json schema{{"type", {"object", "null"}}};
  for (auto& [parameter, readers] : all) {
    constexpr std::size_t kMostNames = 120;  // of a list that still helps
    const bool is_common = readers.size() > kMostNames;
    // Only what all readers agree on.
    if (readers.find(',') != std::string::npos) parameter.conditions = {};
    add(parameter, is_common ? "many controllers" : readers, schema);
  }
  return schema;
}

Json manager_schema() {
  Json schema{{"type", {"object", "null"}}};
  for (const RosParameter& one : manager_parameters()) add(one, "controller_manager", schema);
  Json types = Json::array();
  for (const ControllerClass& one : controller_classes()) types.push_back(std::string(one.name));
  schema["additionalProperties"] = {
      {"type", {"object", "string", "number", "boolean", "array", "null"}},
      {"properties",
       {{"type",
         {{"description", "The class of the controller, PACKAGE/CLASS."},
          {"anyOf", Json::array({{{"enum", std::move(types)}}, {{"type", "string"}}})}}}}}};
  return schema;
}

Json controllers_schema() {
  Json schema = head("ros2-controllers", "ros2_control: controllers.yaml",
                     "Parameters of controller_manager and of the controllers of "
                     "ros2_controllers; other keys are allowed.");
  schema["type"] = "object";
  schema["properties"]["controller_manager"] = {
      {"type", "object"},
      {"properties", {{"ros__parameters", {{"$ref", "#/definitions/manager"}}}}}};
  schema["additionalProperties"] = {{"$ref", "#/definitions/node"}};
  schema["definitions"]["manager"] = manager_schema();
  schema["definitions"]["parameters"] = node_schema();
  schema["definitions"]["node"] = {
      {"type", {"object", "string", "number", "boolean", "array", "null"}},
      {"properties",
       {{"ros__parameters", {{"$ref", "#/definitions/parameters"}}},
        {"controller_manager", {{"$ref", "#/properties/controller_manager"}}}}},
      {"additionalProperties", {{"$ref", "#/definitions/node"}}}};
  return schema;
}

}  // namespace

std::map<std::string, Json> ros_schemas() {
  std::map<std::string, Json> schemas{{"ros2-controllers", controllers_schema()}};
  for (const MoveitFile& file : moveit_files()) {
    std::string name(file.name.substr(0, file.name.find('.')));
    std::replace(name.begin(), name.end(), '_', '-');
    if (!name.starts_with("moveit-")) name = "moveit-" + name;
    schemas[name] = moveit_schema(file, name);
  }
  return schemas;
}

}  // namespace smurf::test
