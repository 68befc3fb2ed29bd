// SPDX-License-Identifier: BSD-3-Clause
// Sources: the parse methods and constructors of launch 1.0.7, 3.4.3 and 3.7.1 and launch_ros
// 0.19.8, 0.26.6 and 0.28.0 (humble, jazzy, rolling), asked by calling them.
#include "link/surroundings/launch_words.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "base/text/words.hpp"

namespace smurf::launch {
namespace {

// What `executable`, `node` and `node_container` share.
#define SMURF_RUN                                                                                  \
  " name cwd output launch-prefix respawn respawn_delay:real respawn_max_retries:count "           \
  "sigkill_timeout:real sigterm_timeout:real shell:truth emulate_tty:truth on_exit if unless"
#define SMURF_NODE " pkg exec args ros_args node-name exec_name namespace" SMURF_RUN

constexpr Action kActions[] = {
    {"append_env", "name value prepend:truth separator if unless", "name value", ""},
    {"arg", "name default description if unless", "name", "choice"},
    {"arg/choice", "value", "value", ""},
    {"executable", "cmd" SMURF_RUN, "cmd", "env"},
    {"executable/env", "name value", "name value", ""},
    {"group", "scoped:truth forwarding:truth if unless", "", "* keep"},
    {"group/keep", "name value", "name value", ""},
    {"include", "file if unless", "file", "arg"},
    {"include/arg", "name value", "name value", ""},
    {"let", "name value if unless", "name value", ""},
    {"load_composable_node", "target if unless", "target", "composable_node"},
    {"log", "message if unless", "message", ""},
    {"node", SMURF_NODE, "exec", "param remap env"},
    {"node/param", "name from value:any type allow_substs:truth", "", "param"},
    {"node/remap", "from to", "from to", ""},
    {"node/env", "name value", "name value", ""},
    {"param/param", "name value:any type", "name", "param"},
    {"node_container", SMURF_NODE, "exec name namespace", "param remap env composable_node"},
    {"node_container/param", "name from value:any type allow_substs:truth", "", "param"},
    {"node_container/remap", "from to", "from to", ""},
    {"node_container/env", "name value", "name value", ""},
    {"push-ros-namespace", "namespace if unless", "namespace", ""},
    {"push_ros_namespace", "namespace if unless", "namespace", ""},
    {"reset", "if unless", "", "keep"},
    {"reset/keep", "name value", "name value", ""},
    {"reset_env", "if unless", "", ""},
    {"ros_timer", "period:real cancel_on_shutdown:truth if unless", "period", "*"},
    {"set_env", "name value if unless", "name value", ""},
    {"set_parameter", "name value if unless", "name value", ""},
    {"set_parameters_from_file", "filename if unless", "filename", ""},
    {"set_remap", "from to if unless", "from to", ""},
    {"set_ros_log_dir", "new_log_dir if unless", "new_log_dir", ""},
    {"set_use_sim_time", "value if unless", "value", ""},
    {"shutdown", "reason if unless", "", ""},
    {"timer", "period:real cancel_on_shutdown:truth if unless", "period", "*"},
    {"unset_env", "name if unless", "name", ""},
};

#undef SMURF_NODE
#undef SMURF_RUN

constexpr int kAny = 99;

constexpr Substitution kSubstitutions[] = {
    {"all", 0, kAny},
    {"and", 2, 2},
    {"anon", 1, 1},
    {"any", 0, kAny},
    {"command", 1, 2},
    {"dirname", 0, 0},
    {"env", 1, 2},
    {"equals", 2, 2},
    {"eval", 1, 2},
    {"exec-in-pkg", 2, 2},
    {"file-content", 1, 1},
    {"filename", 0, 0},
    {"find-exec", 1, 1},
    {"find-pkg-prefix", 1, 1},
    {"find-pkg-share", 1, 1},
    {"if", 2, 3},
    {"launch_log_dir", 0, 0},
    {"log_dir", 0, 0},
    {"not", 1, 1},
    {"not-equals", 2, 2},
    {"or", 2, 2},
    {"param", 1, 2},
    {"var", 1, 2},
    {"xacro", 1, kAny},
};

#define SMURF_PROCESS                                                                              \
  "prefix cwd env additional_env process_description shell sigterm_timeout sigkill_timeout "       \
  "emulate_tty output output_format cached_output log_cmd on_exit respawn respawn_delay "          \
  "condition respawn_max_retries"

constexpr Class kClasses[] = {
    {"AndSubstitution", "left right", "left right", 2},
    {"AnonName", "name", "name", 1},
    {"AnyLaunchDescriptionSource", "launch_file_path", "launch_file_path", 1},
    {"AppendEnvironmentVariable", "name value prepend separator condition", "name value", 4},
    {"Command", "command on_stderr", "command", 1},
    {"ComposableNodeContainer",
     SMURF_PROCESS
     " name namespace composable_node_descriptions executable package exec_name parameters remappings ros_arguments arguments",
     "name namespace", 0},
    {"DeclareLaunchArgument", "name default_value description choices condition", "name", 1},
    {"EnvironmentVariable", "name default_value", "name", 1},
    {"ExecutableInPackage", "executable package", "executable package", 2},
    {"ExecuteProcess", SMURF_PROCESS " cmd name", "cmd", 0},
    {"FindExecutable", "name", "name", 0},
    {"FindPackagePrefix", "package", "package", 1},
    {"FindPackageShare", "package", "package", 1},
    {"GroupAction", "actions scoped forwarding launch_configurations condition", "actions", 1},
    {"IfCondition", "predicate_expression", "predicate_expression", 1},
    {"IncludeLaunchDescription", "launch_description_source launch_arguments condition",
     "launch_description_source", 1},
    {"LaunchConfiguration", "variable_name default", "variable_name", 1},
    {"LaunchConfigurationEquals", "launch_configuration_name expected_value",
     "launch_configuration_name expected_value", 2},
    {"LaunchConfigurationNotEquals", "launch_configuration_name expected_value",
     "launch_configuration_name expected_value", 2},
    {"LaunchDescription", "initial_entities deprecated_reason", "", 1},
    {"LifecycleNode",
     SMURF_PROCESS
     " name namespace executable package exec_name parameters remappings ros_arguments arguments",
     "name namespace", 0},
    {"LoadComposableNodes", "composable_node_descriptions target_container condition",
     "composable_node_descriptions target_container", 0},
    {"LogInfo", "msg condition", "msg", 0},
    {"Node",
     SMURF_PROCESS
     " executable package name namespace exec_name parameters remappings ros_arguments arguments",
     "executable", 0},
    {"NotSubstitution", "value", "value", 1},
    {"OnExecutionComplete",
     "target_action on_completion action_matcher on_event target_event_cls target_action_cls matcher handle_once",
     "on_completion", 0},
    {"OnProcessExit",
     "target_action on_exit action_matcher on_event target_event_cls target_action_cls matcher handle_once",
     "on_exit", 0},
    {"OnProcessIO",
     "target_action on_stdin on_stdout on_stderr action_matcher on_event target_event_cls target_action_cls matcher handle_once",
     "", 0},
    {"OnProcessStart",
     "target_action on_start action_matcher on_event target_event_cls target_action_cls matcher handle_once",
     "on_start", 0},
    {"OnShutdown", "on_shutdown matcher handle_once", "on_shutdown", 0},
    {"OpaqueFunction", "function args kwargs condition", "function", 0},
    {"OrSubstitution", "left right", "left right", 2},
    {"Parameter", "name value value_type", "name value", 2},
    {"ParameterFile", "param_file allow_substs", "param_file", 1},
    {"ParameterValue", "value value_type", "value", 1},
    {"PathJoinSubstitution", "substitutions", "substitutions", 1},
    {"PushROSNamespace", "namespace condition", "namespace", 1},
    {"PushRosNamespace", "namespace condition", "namespace", 1},
    {"PythonExpression", "expression python_modules", "expression", 2},
    {"PythonLaunchDescriptionSource", "launch_file_path", "launch_file_path", 1},
    {"RegisterEventHandler", "event_handler condition", "event_handler", 1},
    {"SetEnvironmentVariable", "name value condition", "name value", 2},
    {"SetLaunchConfiguration", "name value condition", "name value", 2},
    {"SetParameter", "name value condition", "name value", 2},
    {"SetParametersFromFile", "filename condition", "filename", 1},
    {"SetROSLogDir", "new_log_dir condition", "new_log_dir", 1},
    {"SetRemap", "src dst condition", "src dst", 2},
    {"SetUseSimTime", "value condition", "value", 1},
    {"TextSubstitution", "text", "text", 0},
    {"ThisLaunchFileDir", "", "", 0},
    {"TimerAction", "period actions cancel_on_shutdown condition", "period actions", 0},
    {"UnlessCondition", "predicate_expression", "predicate_expression", 1},
    {"UnsetEnvironmentVariable", "name condition", "name", 1},
    {"UnsetLaunchConfiguration", "name condition", "name", 1},
};

#undef SMURF_PROCESS

constexpr OldWord kOldWords[] = {
    {"node", "type", "write `exec`"},
    {"node", "executable", "write `exec`"},
    {"node", "package", "write `pkg`"},
    {"node", "ns", "write `namespace`"},
    {"node", "required", "delete it; `on_exit=\"shutdown\"` does the same since Jazzy"},
    {"node", "clear_params", "delete it"},
    {"node", "rosparam", "write `<param from=\"...\"/>`"},
    {"include", "ns", "write a `group` with `push_ros_namespace` around it"},
    {"include", "pass_all_args", "delete it: an included file sees all arguments"},
    {"include", "clear_params", "delete it"},
    {"group", "ns", "write `push_ros_namespace` in the group"},
    {"arg", "value", "write `default`, or `let` for a value that nobody gives"},
    {"arg", "doc", "write `description`"},
    {"include/arg", "default", "write `value`"},
    {"push_ros_namespace", "ns", "write `namespace`"},
    {"push-ros-namespace", "ns", "write `namespace`"},
    {"", "rosparam", "write `<param from=\"...\"/>` in the node"},
    {"", "param", "write it in the node, or `set_parameter`"},
    {"", "remap", "write it in the node, or `set_remap`"},
    {"", "env", "write `set_env`"},
    {"", "machine", "delete it: ROS 2 has no such element"},
    {"", "master", "delete it: ROS 2 has no such element"},
    {"", "test", "delete it: ROS 2 has no such element"},
    {"", "argument", "write `arg`"},
    {"$", "find", "write `find-pkg-share`"},
    {"$", "arg", "write `var`"},
    {"$", "optenv", "write `env`, with the default behind the name"},
};

}  // namespace

std::span<const Action> actions() { return kActions; }
std::span<const Substitution> substitutions() { return kSubstitutions; }
std::span<const Class> classes() { return kClasses; }
std::span<const OldWord> old_words() { return kOldWords; }

const Action* find_action(std::string_view parent, std::string_view name) {
  const auto find = [](std::string_view wanted) -> const Action* {
    const auto found = std::find_if(std::begin(kActions), std::end(kActions),
                                    [&](const Action& one) { return one.name == wanted; });
    return found == std::end(kActions) ? nullptr : &*found;
  };
  if (!parent.empty()) {
    if (const Action* own = find(std::string(parent) + "/" + std::string(name))) return own;
  }
  return find(name);
}

const Class* find_class(std::string_view name) {
  const auto found = std::find_if(std::begin(kClasses), std::end(kClasses),
                                  [&](const Class& one) { return one.name == name; });
  return found == std::end(kClasses) ? nullptr : &*found;
}

bool has_word(std::string_view list, std::string_view word, std::string_view* mark) {
  for (std::size_t at = 0;;) {
    std::string_view one = next_word(list, at);
    if (one.empty()) return false;
    const std::size_t colon = one.find(':');
    if (one.substr(0, colon) != word) continue;
    if (mark != nullptr)
      *mark = colon == std::string_view::npos ? std::string_view() : one.substr(colon + 1);
    return true;
  }
}

}  // namespace smurf::launch
