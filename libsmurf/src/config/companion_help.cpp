// SPDX-License-Identifier: BSD-3-Clause
#include "config/companion_help.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "ast/ros_parameters.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

constexpr std::string_view kParameters = "ros__parameters";
constexpr std::string_view kTrueOrFalse[] = {"true", "false"};

/// What a file may contain at a place: parameters, and the path from which they are counted.
struct ParameterPlace {
  std::vector<RosParameter> parameters;
  std::string owner;
  std::span<const std::string> path;
};

/// The type that a controller has in the text: "NAME:", then "type: TYPE".
std::string_view controller_type_in(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find(name); at != std::string_view::npos;
       at = text.find(name, at + 1)) {
    std::string_view rest = text.substr(at + name.size());
    const bool is_key = rest.starts_with(':') && (at == 0 || is_blank(text[at - 1]));
    if (!is_key) continue;
    rest = trimmed(rest.substr(1));
    if (!rest.starts_with("type:")) continue;
    rest = rest.substr(5, rest.substr(0, rest.find('\n')).size() - 5);
    rest = trimmed(rest.substr(0, rest.find('#')));
    if (rest.size() > 1 && (rest.front() == '"' || rest.front() == '\'')) {
      rest = rest.substr(1, rest.size() - 2);
    }
    return rest;
  }
  return {};
}

ParameterPlace place_in_controllers(const CompanionLanguage& language,
                                    std::span<const std::string> path) {
  const auto found = std::find(path.begin(), path.end(), kParameters);
  const auto index = static_cast<std::size_t>(found - path.begin());
  if (found == path.end() || index == 0) return {};
  const std::string& node = path[index - 1];
  const std::span<const std::string> inner = path.subspan(index + 1);
  if (node == "controller_manager") {
    const bool is_controller = !inner.empty() && inner[0] != "hardware_components_initial_state" &&
                               inner[0] != "defaults" && inner[0] != "overruns";
    if (!is_controller) return {manager_parameters(), "controller_manager", inner};
    RosParameter type;
    type.path = "type";
    type.is_required = true;
    return {{type}, "controller", inner.subspan(1)};
  }
  const ControllerClass* known = find_controller_class(controller_type_in(language.text, node));
  if (known == nullptr) return {};
  return {parameters_of(*known), std::string(known->name.substr(known->name.find('/') + 1)), inner};
}

ParameterPlace parameter_place_of(const CompanionLanguage& language,
                                  std::span<const std::string> path) {
  if (language.title == "controllers.yaml") return place_in_controllers(language, path);
  const MoveitFile* file = find_moveit_file(language.title);
  if (file == nullptr) return {};
  while (!path.empty() &&
         is_one_of(path[0], {"/**", "move_group", kParameters, "robot_description_planning",
                             "robot_description_kinematics"})) {
    path = path.subspan(1);
  }
  return {parameters_of(*file), std::string(file->name), path};
}

std::string dotted(std::span<const std::string> path) {
  std::string text;
  for (const std::string& one : path) text += (text.empty() ? "" : ".") + one;
  return text;
}

/// What follows a prefix in a path, where `*` is one name; none if the path begins differently.
std::optional<std::string_view> rest_behind(std::string_view path,
                                            std::span<const std::string> prefix) {
  for (const std::string& one : prefix) {
    const std::size_t dot = path.find('.');
    const std::string_view name = path.substr(0, dot);
    if (dot == std::string_view::npos || (name != "*" && name != one)) return std::nullopt;
    path.remove_prefix(dot + 1);
  }
  return path;
}

std::string_view readers_of(std::string_view distributions) {
  struct Row {
    std::string_view letters, names;
  };
  constexpr Row kRows[] = {
      {"h", "ROS Humble"},
      {"hj", "ROS Humble and Jazzy"},
      {"hjk", "ROS Humble, Jazzy and Kilted"},
      {"jkr", "ROS Jazzy, Kilted and Rolling"},
      {"j", "ROS Jazzy"},
      {"kr", "ROS Kilted and Rolling"},
      {"r", "ROS Rolling"},
  };
  const auto found = std::find_if(std::begin(kRows), std::end(kRows),
                                  [&](const Row& one) { return one.letters == distributions; });
  return found == std::end(kRows) ? std::string_view() : found->names;
}

KeyHelp parameter_help(const RosParameter& parameter, std::string_view name,
                       const std::string& owner) {
  KeyHelp help{owner, std::string(name), sentence_about(parameter.path), type_name(parameter)};
  help.fallback = parameter.fallback;
  help.read_by = readers_of(parameter.distributions);
  help.required = parameter.is_required;
  const bool is_list = std::isupper(static_cast<unsigned char>(parameter.type)) != 0;
  help.form = is_list ? ValueForm::list : ValueForm::scalar;
  if (parameter.type == 'b') {
    help.form = ValueForm::boolean;
    help.choices.assign(std::begin(kTrueOrFalse), std::end(kTrueOrFalse));
  }
  for (const ValueCondition& one : conditions_of(parameter)) {
    help.choices.insert(help.choices.end(), one.texts.begin(), one.texts.end());
  }
  const bool is_of_controller = parameter.path.find("interface") == std::string_view::npos;
  if (holds_joints(name) && is_of_controller) help.names = NameKind::joint;
  if (name == "type" && owner == "controller") {
    for (const ControllerClass& one : controller_classes()) help.known.push_back(one.name);
  }
  return help;
}

struct ElementRow {
  std::string_view parent, name, doc;
  std::string_view attributes;  ///< `!` behind those that are needed
};

/// Elements of SRDF and of `ros2_control`. Sources: srdfdom model.cpp, component_parser.cpp.
constexpr ElementRow kElements[] = {
    {"", "robot", "The root; its name is that of the URDF.", "name!"},
    {"robot", "virtual_joint", "The joint between the world and the root link of the robot.",
     "name! type! parent_frame! child_link!"},
    {"robot", "group", "Joints that are planned together.", "name!"},
    {"group", "link", "Adds the joint above the link.", "name!"},
    {"group", "joint", "Adds a joint.", "name!"},
    {"group", "chain", "Adds all joints from one link to a link below it.", "base_link! tip_link!"},
    {"group", "group", "Adds the joints of another group.", "name!"},
    {"robot", "group_state", "Positions of the joints of a group that have a name.",
     "name! group!"},
    {"group_state", "joint", "The position of a joint, in rad or m.", "name! value!"},
    {"robot", "end_effector", "A group that is attached to a link of another group.",
     "name! group! parent_link! parent_group"},
    {"robot", "disable_collisions", "Two links that are not checked against each other.",
     "link1! link2! reason"},
    {"robot", "enable_collisions", "Two links that are checked despite disable_default_collisions.",
     "link1! link2! reason"},
    {"robot", "disable_default_collisions", "A link that is not checked against any other.",
     "link!"},
    {"robot", "passive_joint", "A joint that no motor moves.", "name!"},
    {"robot", "joint_property", "A property of a joint, such as motion_model.",
     "joint_name! property_name! value!"},
    {"robot", "link_sphere_approximation", "The spheres that stand for a link.", "link!"},
    {"link_sphere_approximation", "sphere", "A sphere in the frame of the link, in m.",
     "center! radius!"},
    {"robot", "ros2_control", "Hardware with its joints, sensors and other parts.",
     "name! type! rw_rate is_async"},
    {"ros2_control", "hardware", "The plugin that talks to the hardware.", ""},
    {"ros2_control", "joint", "A movable joint of the robot and its interfaces.", "name! mimic"},
    {"ros2_control", "sensor", "A sensor and its state interfaces.", "name!"},
    {"ros2_control", "gpio", "Inputs and outputs that belong to no joint.", "name!"},
    {"ros2_control", "transmission", "What is between motors and joints.", "name!"},
    {"hardware", "plugin", "The class of the plugin, PACKAGE/CLASS.", ""},
    {"hardware", "group", "Hardware that stops together.", ""},
    {"hardware", "param", "A parameter of the plugin.", "name!"},
    {"joint", "command_interface", "A value that controllers write.", "name! data_type size"},
    {"joint", "state_interface", "A value that controllers read.", "name! data_type size"},
    {"sensor", "state_interface", "A value that controllers read.", "name! data_type size"},
    {"gpio", "command_interface", "A value that controllers write.", "name! data_type size"},
    {"gpio", "state_interface", "A value that controllers read.", "name! data_type size"},
    {"command_interface", "param", "A limit or another property: min, max, initial_value.",
     "name!"},
    {"state_interface", "param", "A property of the interface, such as initial_value.", "name!"},
};

constexpr std::string_view kTypes[] = {"system", "actuator", "sensor"};
constexpr std::string_view kJointTypes[] = {"fixed", "floating", "planar"};
constexpr std::string_view kInterfaces[] = {"position", "velocity", "effort", "acceleration"};
constexpr std::string_view kReasons[] = {"Adjacent", "Never", "Default", "Always", "User"};

void set_known_words(std::string_view element, KeyHelp& help) {
  const auto are = [&](const auto& words) {
    help.known.assign(std::begin(words), std::end(words));
  };
  if (help.name == "type" && element == "ros2_control") are(kTypes);
  if (help.name == "type" && element == "virtual_joint") are(kJointTypes);
  if (help.name == "name" && element.ends_with("_interface")) are(kInterfaces);
  if (help.name == "reason") are(kReasons);
  if (help.name == "mimic" || help.name == "is_async") are(kTrueOrFalse);
}

}  // namespace

std::vector<KeyHelp> companion_keys_in(const CompanionLanguage& language,
                                       std::span<const std::string> path) {
  const ParameterPlace place = parameter_place_of(language, path);
  std::vector<KeyHelp> keys;
  for (const RosParameter& one : place.parameters) {
    const auto rest = rest_behind(one.path, place.path);
    if (!rest) continue;
    const std::string_view name = rest->substr(0, rest->find('.'));
    const bool is_known =
        std::any_of(keys.begin(), keys.end(), [&](const KeyHelp& key) { return key.name == name; });
    if (name == "*" || is_known) continue;
    KeyHelp help = parameter_help(one, name, place.owner);
    if (rest->find('.') != std::string_view::npos) {
      help = KeyHelp{place.owner, std::string(name), {}, "a mapping"};
      help.form = ValueForm::mapping;
    }
    keys.push_back(std::move(help));
  }
  return keys;
}

std::optional<KeyHelp> companion_key_help(const CompanionLanguage& language,
                                          std::span<const std::string> path) {
  if (path.empty()) return std::nullopt;
  const ParameterPlace place = parameter_place_of(language, path);
  if (place.path.empty()) return std::nullopt;
  const RosParameter* found = find_parameter(place.parameters, dotted(place.path));
  if (found == nullptr) return std::nullopt;
  return parameter_help(*found, place.path.back(), place.owner);
}

NameKinds companion_names_in(const CompanionLanguage& language, std::span<const std::string> path) {
  const ParameterPlace place = parameter_place_of(language, path);
  if (has_joints_as_keys(dotted(place.path))) return NameKind::joint;
  const bool is_by_group = place.path.empty() && !place.owner.empty() &&
                           is_one_of(language.title, {"kinematics.yaml", "ompl_planning.yaml"});
  return is_by_group ? NameKinds(NameKind::group) : NameKinds();
}

std::optional<ElementHelp> companion_element_help(std::string_view parent, std::string_view name) {
  const auto row = std::find_if(std::begin(kElements), std::end(kElements), [&](const auto& one) {
    return one.parent == parent && one.name == name;
  });
  if (row == std::end(kElements)) return std::nullopt;
  ElementHelp help{row->name, row->doc, {}, {}, {}};
  for (std::size_t at = 0;;) {
    std::string_view word = next_word(row->attributes, at);
    if (word.empty()) break;
    KeyHelp key;
    key.owner = row->name;
    key.required = key.is_usual = word.ends_with('!');
    if (key.required) word.remove_suffix(1);
    key.name = word;
    key.value = "a text";
    set_known_words(row->name, key);
    help.attributes.push_back(std::move(key));
  }
  // A joint of a group has no interfaces, and a group in a group is only a name.
  const bool is_name_only = is_one_of(parent, {"group", "group_state"});
  for (const ElementRow& one : kElements) {
    if (one.parent == name && !is_name_only) help.children.push_back(one.name);
  }
  return help;
}

}  // namespace smurf
