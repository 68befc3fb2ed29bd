// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/suggest.hpp"
#include "lint/companions/controllers.hpp"

namespace smurf::rules::sml3714_parameter_file_structure_file {
namespace {

constexpr Circumstance kNode{"node"};
constexpr std::string_view kParameters = "ros__parameters";
constexpr std::string_view kManager = "controller_manager";

bool is_alias(yaml::View value) {
  return value.document().nodes[static_cast<std::size_t>(value.id())].is_alias();
}

class Check {
 public:
  Check(const Companion& file, const Companions& companions, Findings& findings)
      : findings_(findings) {
    // SML3702 reports wrong types in these lists.
    for_each_known_controller(
        companions, [&](const RosController& controller, const std::vector<RosParameter>& known) {
          if (controller.section.span().source != file.source) return;
          for_each_parameter(controller.section, known,
                             [&](yaml::View value, const std::string&, const RosParameter& one) {
                               const bool is_list =
                                   std::isupper(static_cast<unsigned char>(one.type)) != 0;
                               if (is_list) judged_.insert(value.span().begin);
                             });
        });
  }

  /// The level of the nodes and their namespaces.
  // The recursion is as deep as the file, whose depth is limited.
  void nodes(yaml::View mapping) {
    for (const yaml::View member : mapping) {
      const std::string key(member.key());
      if (is_alias(member)) {
        alias(member);
      } else if (member.key().starts_with(kParameters)) {
        if (mapping.id() == mapping.document().root) {
          report(member.key_span(), "`ros__parameters` stands below no node",
                 "write it below the name of a node, such as `controller_manager:`");
        } else if (!member.is_mapping()) {
          report(member.key_span(), "`ros__parameters` is empty", "write parameters, or `{}`");
        } else {
          parameters(member);
        }
      } else if (!member.is_mapping()) {
        report(member.key_span(), quoted(key) + " stands outside of `ros__parameters`",
               "move it into the `ros__parameters` of its node");
      } else {
        section(member);
      }
    }
  }

  void manager(yaml::View root) {
    std::vector<std::string_view> names;
    collect(root, names);
    if (std::find(names.begin(), names.end(), kManager) != names.end()) return;
    for (const yaml::View member : root) {
      const std::string_view name = member.key().substr(member.key().rfind('/') + 1);
      constexpr int kMostEdits = 3;
      if (edit_distance(name, kManager, kMostEdits) > kMostEdits) continue;
      Diagnostic& found = findings_.report(member.key_span(),
                                           "the node " + quoted(member.key()) +
                                               " has parameters of a controller "
                                               "manager, but no node reads them under this name");
      found.severity = Severity::warning;
      found.when(kNode);
      found.help("did you mean `controller_manager`?");
      found.fixes.push_back({Applicability::unsafe, {{member.key_span(), std::string(kManager)}}});
    }
  }

 private:
  void section(yaml::View member) {
    if (member.find(kParameters)) return nodes(member);
    const std::string title = quoted(member.key());
    bool has_values = false;
    for (const yaml::View inner : member) {
      constexpr int kMostEdits = 3;
      if (edit_distance(inner.key(), kParameters, kMostEdits) <= kMostEdits) {
        Diagnostic& found = report(
            inner.key_span(), title + " has " + quoted(inner.key()) + ", but no `ros__parameters`",
            "did you mean `ros__parameters`, with two underscores?");
        found.fixes.push_back(
            {Applicability::unsafe, {{inner.key_span(), std::string(kParameters)}}});
        return;
      }
      has_values = has_values || !inner.is_mapping();
    }
    if (!has_values) return nodes(member);
    report(member.key_span(), title + " has parameters, but no `ros__parameters` above them",
           "write `ros__parameters:` below " + title + ", and its parameters below that");
  }

  // The recursion is as deep as the file, whose depth is limited.
  void parameters(yaml::View value) {
    if (is_alias(value)) return alias(value);
    if (value.is_mapping()) {
      for (const yaml::View member : value) parameters(member);
    } else if (value.is_sequence()) {
      items(value);
    } else if (value.is_null() && value.span().empty()) {
      report(value.place(), quoted(value.key()) + " has no value",
             "write a value, or delete the parameter");
    }
  }

  void items(yaml::View list) {
    char first = 0;
    for (const yaml::View item : list) {
      if (is_alias(item)) return alias(item);
      const char type = item.is_scalar() ? rcl_type_of(item) : '\0';
      if (type == 0) continue;
      if (first == 0) first = type;
      if (type == first || judged_.contains(list.span().begin)) continue;
      report(item.span(),
             "a list of one type begins with a " + std::string(parameter_type_name(first)) +
                 ", but " + quoted(item.text()) + " is a " + std::string(parameter_type_name(type)),
             "write all values of the list alike, such as `1.0` for a double");
      return;  // one finding per list
    }
  }

  void alias(yaml::View value) {
    report(value.span(), "an alias of YAML in a parameter file", "write the value itself");
  }

  /// The names of the nodes below a mapping.
  static void collect(yaml::View mapping, std::vector<std::string_view>& names) {
    for (const yaml::View member : mapping) {
      if (!member.is_mapping()) continue;
      names.push_back(member.key().substr(member.key().rfind('/') + 1));
      if (!member.find(kParameters)) collect(member, names);
    }
  }

  Diagnostic& report(Span place, const std::string& message, std::string help) {
    return findings_.report(place, message).help(std::move(help));
  }

  Findings& findings_;
  std::set<std::uint32_t> judged_;  ///< where lists begin
};

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for (const Companion& file : companions.files) {
    if (file.kind != CompanionKind::controllers || !file.document) continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping()) continue;
    Check check(file, companions, findings);
    check.nodes(root);
    check.manager(root);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::loses, "starts without controllers: no node of this name runs",
     "ros2_control controller_manager ros2_control_node.cpp", when(kNode)},
    {&readers::ros2_control, Effect::refuses,
     "refuses the whole file: the node ends, and no controller starts",
     "rcl rcl_yaml_param_parser/src/parse.c (rolling, 07a92fa)"},
};

}  // namespace

extern constinit const Rule sml3714_parameter_file_structure{
    .id = "SML3714",
    .name = "parameter-file-structure",
    .severity = Severity::error,
    .summary = "A parameter file has a structure that ROS 2 refuses.",
    .why = "One value outside of `ros__parameters` ends each node that gets the file.",
    .remedy = "Write all parameters of a node below `NODE: ros__parameters:`.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3714_parameter_file_structure_file
