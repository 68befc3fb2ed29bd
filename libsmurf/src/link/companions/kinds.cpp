// SPDX-License-Identifier: BSD-3-Clause
// The kinds of companions, recognised by their keys. To add a kind, add a row here, list its names
// in parameter_names.cpp, and write its rules.
#include "link/companions/kinds.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "ast/ros_parameters.hpp"
#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "smurf/limits.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

constexpr int kDeepestKey = 8;  // the mappings of namespaces, a node, and its parameters

/// The keys of a file, and what its values say about its kind.
struct Content {
  std::set<std::string_view> keys;
  bool has_controller = false;  ///< a `type` is a controller of ros2_controllers
  bool has_trajectory = false;  ///< a `type` ends with /JointTrajectoryController, as in ROS 1

  bool has(std::string_view key) const { return keys.contains(key); }
  bool has_any(std::initializer_list<std::string_view> some) const {
    return std::any_of(some.begin(), some.end(), [&](std::string_view one) { return has(one); });
  }
  std::size_t count_of(std::initializer_list<std::string_view> some) const {
    return static_cast<std::size_t>(
        std::count_if(some.begin(), some.end(), [&](std::string_view one) { return has(one); }));
  }
  /// Whether a key is this one, or a misspelling of it.
  bool has_similar(std::string_view wanted) const {
    constexpr int kEdits = 2;
    return has(wanted) || std::any_of(keys.begin(), keys.end(), [&](std::string_view key) {
             const auto longer = std::max(key.size(), wanted.size());
             return longer - std::min(key.size(), wanted.size()) <= kEdits &&
                    edit_distance(key, wanted, kEdits) <= kEdits;
           });
  }
  void add(std::string_view key, std::string_view value) {
    keys.insert(key);
    if (key != "type") return;
    has_controller = has_controller || find_controller_class(value) != nullptr;
    has_trajectory = has_trajectory || value.ends_with("/JointTrajectoryController");
  }
};

void read(yaml::View value, int depth, Content& content) {
  if (depth > kDeepestKey || (!value.is_mapping() && !value.is_sequence())) return;
  for (const yaml::View member : value) {
    if (value.is_mapping()) content.add(member.key(), trimmed(member.text()));
    read(member, depth + 1, content);
  }
}

std::string_view unquoted(std::string_view text) {
  text = trimmed(text);
  const bool is_quoted = text.size() > 1 && text.front() == text.back() &&
                         (text.front() == '"' || text.front() == '\'');
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

/// The keys at the beginnings of the lines of a text that is not YAML.
Content read_lines(std::string_view text) {
  Content content;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    while (line.starts_with("- ") || line.starts_with('{')) line = trimmed(line.substr(1));
    const std::size_t colon = line.find(':');
    if (line.starts_with('#') || colon == std::string_view::npos) continue;
    std::string_view value = line.substr(colon + 1);
    if (const std::size_t comment = value.find(" #"); comment != std::string_view::npos) {
      value = value.substr(0, comment);
    }
    content.add(unquoted(line.substr(0, colon)), unquoted(value));
    // {type: x, joints: [..]}
    value = trimmed(value);
    if (value.starts_with('{')) {
      const std::size_t inner = value.find(':');
      if (inner != std::string_view::npos) {
        const std::size_t stop = std::min(value.find_first_of(",}", inner), value.size());
        content.add(unquoted(value.substr(1, inner - 1)),
                    unquoted(value.substr(inner + 1, stop - inner - 1)));
      }
    }
  }
  return content;
}

bool is_controllers(const Content& content) {
  if (content.has_any({"controller_list", "moveit_simple_controller_manager", "action_ns"})) {
    return content.has("ros__parameters") && content.has("controller_manager") &&
           content.has_any({"command_interfaces", "update_rate"});
  }
  const bool has_manager = content.has_similar("controller_manager");
  const bool has_parameters = content.has_similar("ros__parameters");
  const bool has_interfaces = content.has("command_interfaces");
  return (has_parameters && (has_manager || has_interfaces || content.has_controller)) ||
         (has_manager && content.has_controller);
}

bool is_joint_limits(const Content& content) {
  return content.has_similar("joint_limits") &&
         content.has_any({"has_velocity_limits", "has_acceleration_limits", "has_position_limits",
                          "has_jerk_limits"});
}

bool is_kinematics(const Content& content) {
  return content.has("kinematics_solver") ||
         content.count_of({"kinematics_solver_search_resolution", "kinematics_solver_timeout",
                           "kinematics_solver_attempts"}) > 1;
}

bool is_moveit_controllers(const Content& content) {
  // In ROS 1, controllers are in a list, those of the simulation also without an action.
  const bool has_manager =
      content.has_any({"controller_names", "moveit_simple_controller_manager"});
  const bool has_controllers =
      content.has("action_ns") || (content.has("type") && content.has("joints"));
  return (has_manager && has_controllers) ||
         (content.has("controller_list") && content.has("joints")) ||
         (content.has_trajectory && content.has("joints") && !content.has("ros__parameters"));
}

bool is_ompl_planning(const Content& content) { return content.has("planner_configs"); }

bool is_sensors_3d(const Content& content) {
  return content.has("sensors") && content.has("sensor_plugin");
}

bool is_setup_assistant(const Content& content) {
  return content.has("moveit_setup_assistant_config");
}

constexpr std::array kCompanionKinds = {
    CompanionSpec{CompanionKind::srdf, "SRDF", true},
    CompanionSpec{CompanionKind::controllers, "controllers.yaml", false},
    CompanionSpec{CompanionKind::joint_limits, "joint_limits.yaml", false},
    CompanionSpec{CompanionKind::kinematics, "kinematics.yaml", false},
    CompanionSpec{CompanionKind::moveit_controllers, "moveit_controllers.yaml", false},
    CompanionSpec{CompanionKind::ompl_planning, "ompl_planning.yaml", false},
    CompanionSpec{CompanionKind::sensors_3d, "sensors_3d.yaml", false},
    CompanionSpec{CompanionKind::setup_assistant, ".setup_assistant", false},
};
using IsOne = bool (*)(const Content& content);
constexpr IsOne kIsOne[] = {nullptr,       is_controllers,        is_joint_limits,
                            is_kinematics, is_moveit_controllers, is_ompl_planning,
                            is_sensors_3d, is_setup_assistant};
static_assert(std::size(kIsOne) == kCompanionKinds.size());

const CompanionSpec* kind_of(const Content& content, bool is_setup) {
  for (std::size_t i = 1; i < kCompanionKinds.size(); ++i) {
    const bool may_be = (kCompanionKinds[i].kind == CompanionKind::setup_assistant) == is_setup;
    if (may_be && kIsOne[i](content)) return &kCompanionKinds[i];
  }
  return nullptr;
}

bool is_setup(std::string_view path) { return path::file_name(path) == ".setup_assistant"; }

/// Whether a line has a word such as `<namespace>`.
bool has_word_in_brackets(std::string_view line) {
  for (std::size_t at = line.find('<'); at != std::string_view::npos; at = line.find('<', at + 1)) {
    const auto is_inner = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    std::size_t end = at + 1;
    while (end < line.size() && is_inner(line[end])) ++end;
    if (end > at + 1 && end < line.size() && line[end] == '>') return true;
  }
  return false;
}

/// Whether reading the text stopped: a key that is written twice, for example, loses nothing.
bool is_broken(const DiagnosticSink& found) {
  return std::any_of(found.diagnostics().begin(), found.diagnostics().end(), [](const auto& one) {
    const auto is = [&](const Rule& rule) { return one.rule == &rule; };
    return one.severity == Severity::error &&
           (is(rules::sml0010_yaml_syntax) || is(rules::sml0003_invalid_utf8) ||
            is(rules::sml0005_unsupported_encoding) || is(rules::sml0002_file_too_large) ||
            is(rules::sml0014_nesting_too_deep) || is(rules::sml0016_cyclic_alias) ||
            is(rules::sml0015_alias_expansion));
  });
}

/// The text with a word for each expression that a launch file fills in within a line: a text that
/// is no YAML even so is none after it is filled in.
std::string filled_in(std::string_view text) {
  std::string filled;
  while (!text.empty()) {
    const std::size_t at = text.find('$');
    const char open = at + 1 < text.size() ? text[at + 1] : '\0';
    const std::size_t end = open == '(' || open == '{' ? text.find(open == '(' ? ')' : '}', at)
                                                       : std::string_view::npos;
    const bool is_expression = at != std::string_view::npos && end != std::string_view::npos &&
                               text.substr(at, end - at).find('\n') == std::string_view::npos;
    if (is_expression) {
      filled += std::string(text.substr(0, at)) + "x";
      text.remove_prefix(end + 1);
    } else {
      const std::size_t size = at == std::string_view::npos ? text.size() : at + 1;
      filled += text.substr(0, size);
      text.remove_prefix(size);
    }
  }
  return filled;
}

/// Whether the text is broken whatever a launch file fills in.
bool stays_broken(std::string_view text) {
  SourceMap sources;
  DiagnosticSink found;
  const SourceId source = sources.add("template", filled_in(text));
  const auto document = parse_yaml(sources, source, Limits{}, found);
  return !is_template(sources.text(source)) && (!document || is_broken(found));
}

bool may_become_yaml(std::string_view text) { return is_template(text) && !stays_broken(text); }

Recognised recognise_broken(std::string_view path, std::string_view text) {
  const CompanionSpec* spec = kind_of(read_lines(text), is_setup(path));
  if (spec == nullptr) return {};
  return {spec, may_become_yaml(text) ? CompanionState::a_template : CompanionState::broken};
}

}  // namespace

std::span<const CompanionSpec> companion_kinds() { return kCompanionKinds; }

const CompanionSpec& spec_of(CompanionKind kind) {
  return *std::find_if(kCompanionKinds.begin(), kCompanionKinds.end(),
                       [&](const CompanionSpec& one) { return one.kind == kind; });
}

bool may_be_parameters(std::string_view path) {
  const std::string name = path::to_lower(path);
  // Directives of Drake, which smurfs-flatten writes: an input must not be written over.
  if (name.ends_with(".dmd.yaml")) return false;
  return name.ends_with(".yaml") || name.ends_with(".yml") || is_setup(path);
}

bool is_template(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line = line.substr(0, line.starts_with('#') ? 0 : line.find(" #"));
    for (const std::string_view marker : {"{{", "{%", "$(", "${"}) {
      if (line.find(marker) != std::string_view::npos) return true;
    }
    if (has_word_in_brackets(line)) return true;
  }
  return false;
}

bool is_broken_yaml(std::string_view text, const std::optional<yaml::Document>& document,
                    const DiagnosticSink& found) {
  return (!document || is_broken(found)) && !may_become_yaml(text);
}

Diagnostic& report_of_yaml(const Diagnostic& finding, DiagnosticSink& sink) {
  Diagnostic& reported = sink.report(*finding.rule, finding.span, finding.message);
  reported.caret = finding.caret;
  reported.labels = finding.labels;
  reported.help_text = finding.help_text;
  return reported;
}

void report_broken_yaml(const Diagnostic& finding, DiagnosticSink& sink) {
  report_of_yaml(finding, sink)
      .note("the program of ROS that reads this file ends: nothing in it takes effect");
}

Recognised recognise(std::string_view path, std::string_view text,
                     const std::optional<yaml::Document>& document, const DiagnosticSink& found) {
  if (!document || is_broken(found)) return recognise_broken(path, text);
  Content content;
  if (const yaml::View root = document->view()) read(root, 0, content);
  const CompanionSpec* spec = kind_of(content, is_setup(path));
  return {spec, spec == nullptr ? CompanionState::other : CompanionState::readable};
}

Recognised recognise(std::string_view path, std::string_view text) {
  if (is_companion_path(path)) {
    return {&spec_of(CompanionKind::srdf), CompanionState::readable};
  }
  if (!may_be_parameters(path)) return {};
  SourceMap sources;
  const SourceId source = sources.add(std::string(path), std::string(text));
  DiagnosticSink ignored;
  auto document = parse_yaml(sources, source, Limits{}, ignored);
  return recognise(path, text, document, ignored);
}

const CompanionSpec* find_companion_kind(std::string_view path, std::string_view text) {
  return recognise(path, text).spec;
}

}  // namespace smurf
