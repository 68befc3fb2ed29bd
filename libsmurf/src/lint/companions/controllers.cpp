// SPDX-License-Identifier: BSD-3-Clause
// Sources: ros2_control controller_manager.cpp; rclcpp parameter files.
#include "lint/companions/controllers.hpp"

#include <map>
#include <set>

#include "base/files/path.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

/// The name of a node without its namespace: "/arm/controller" and "controller" are one.
std::string_view without_namespace(std::string_view key) {
  const std::size_t slash = key.rfind('/');
  return slash == std::string_view::npos ? key : key.substr(slash + 1);
}

struct Node {
  std::string_view name;
  yaml::View parameters;
  Span place;  ///< its key
};

/// The nodes of a file, which may be in mappings of namespaces.
void collect(yaml::View value, int depth, std::vector<Node>& nodes) {
  constexpr int kDeepest = 6;
  if (!value.is_mapping() || depth > kDeepest) return;
  for (const yaml::View member : value) {
    if (member.is_repeated() || !member.is_mapping()) continue;
    if (const yaml::View own = member.find("ros__parameters"); own && own.is_mapping()) {
      nodes.push_back({without_namespace(member.key()), own, member.key_span()});
    }
    if (member.key() != "ros__parameters") collect(member, depth + 1, nodes);
  }
}

/// The parameters of the first node of each name.
using NodesByName = std::map<std::string_view, yaml::View>;

void read_manager(yaml::View manager, const NodesByName& nodes, ControllerFile& file) {
  for (const yaml::View member : manager) {
    if (member.is_repeated() || !member.is_mapping()) continue;
    RosController one{.name = member.key(),
                      .declared = member,
                      .type = member.find("type"),
                      .section = {},
                      .place = member.key_span()};
    const auto node = nodes.find(one.name);
    if (node != nodes.end()) one.section = node->second;
    if (!one.type && one.section) one.type = one.section.find("type");
    if (one.type && one.type.is_scalar())
      one.known = find_controller_class(trimmed(one.type.text()));
    file.controllers.push_back(one);
  }
}

/// Whether the parameters of a node are those of a controller: with a class that is known, or of
/// another package, for joints or interfaces.
bool is_of_controller(yaml::View parameters) {
  const yaml::View type = parameters.find("type");
  if (!type || !type.is_scalar()) return false;
  const std::string_view text = trimmed(type.text());
  if (find_controller_class(text) != nullptr) return true;
  const bool is_class = text.find('/') != std::string_view::npos;
  return is_class && parameters.find("joints") && parameters.find("command_interfaces");
}

/// Controllers whose type stands in their own section, as `spawner --param-file` reads it.
void read_spawned(const std::vector<Node>& nodes, ControllerFile& file) {
  std::set<std::string_view> known;
  for (const RosController& one : file.controllers) known.insert(one.name);
  for (const Node& node : nodes) {
    if (known.contains(node.name) || node.name == "controller_manager" ||
        !is_of_controller(node.parameters))
      continue;
    known.insert(node.name);
    RosController one{.name = node.name,
                      .declared = {},
                      .type = node.parameters.find("type"),
                      .section = node.parameters,
                      .place = node.place};
    one.known = find_controller_class(trimmed(one.type.text()));
    file.controllers.push_back(one);
  }
}

}  // namespace

yaml::View RosController::parameter(std::string_view key) const {
  return section ? section.find(key) : yaml::View();
}

std::vector<yaml::View> RosController::list(std::string_view key) const {
  std::vector<yaml::View> items;
  const yaml::View value = parameter(key);
  if (!value || !value.is_sequence()) return items;
  for (const yaml::View item : value) {
    if (item.is_scalar()) items.push_back(item);
  }
  return items;
}

void for_each_controller_file(const Companions& companions,
                              const std::function<void(const ControllerFile&)>& visit) {
  for (const Companion& one : companions.files) {
    if (one.kind != CompanionKind::controllers || !one.document || !one.document->view()) continue;
    std::vector<Node> nodes;
    collect(one.document->view(), 0, nodes);
    NodesByName by_name;
    for (const Node& node : nodes) by_name.try_emplace(node.name, node.parameters);
    ControllerFile file{&one, {}, {}};
    for (const Node& node : nodes) {
      if (node.name != "controller_manager") continue;
      if (!file.manager) file.manager = node.parameters;
      read_manager(node.parameters, by_name, file);
    }
    read_spawned(nodes, file);
    visit(file);
  }
}

void for_each_known_controller(
    const Companions& companions,
    const std::function<void(const RosController&, const std::vector<RosParameter>&)>& visit) {
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& controller : file.controllers) {
      if (controller.known == nullptr || !controller.section) continue;
      visit(controller, parameters_of(*controller.known));
    }
  });
}

void for_each_parameter(
    yaml::View mapping, const std::vector<RosParameter>& known,
    const std::function<void(yaml::View, const std::string&, const RosParameter&)>& visit,
    const std::string& prefix) {
  for (const yaml::View member : mapping) {
    if (member.is_repeated()) continue;
    const std::string path = prefix + std::string(member.key());
    if (const RosParameter* parameter = find_parameter(known, path)) {
      visit(member, path, *parameter);
    } else if (member.is_mapping()) {
      for_each_parameter(member, known, visit, path + ".");
    }
  }
}

char rcl_type_of(yaml::View value) {
  if (value.is_null() || is_placeholder(value.text())) return 0;
  switch (value.type()) {
  case yaml::ScalarType::integer: return 'i';
  case yaml::ScalarType::number: return 'd';
  case yaml::ScalarType::boolean: return 'b';
  case yaml::ScalarType::null: return 0;
  case yaml::ScalarType::text: break;
  }
  const std::string lower = path::to_lower(value.text());
  const bool is_plain = value.style() == yaml::Style::plain;
  return is_plain && is_one_of(lower, {"yes", "no", "on", "off", "y", "n"}) ? 'b' : 's';
}

std::string title_of(const RosController& controller) {
  return "controller " + quoted(controller.name);
}

bool is_placeholder(std::string_view text) {
  return text.find("$(") != std::string_view::npos || text.find("${") != std::string_view::npos ||
         text.find('<') != std::string_view::npos || text.find("{{") != std::string_view::npos;
}

}  // namespace smurf
