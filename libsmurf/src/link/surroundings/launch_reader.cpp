// SPDX-License-Identifier: BSD-3-Clause
// Sources: launch and launch_ros, branches humble, jazzy and rolling; roslaunch of noetic.
#include "link/surroundings/launch_reader.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "base/text/words.hpp"
#include "link/surroundings/launch_mistakes.hpp"
#include "link/surroundings/launch_texts.hpp"
#include "link/surroundings/python_calls.hpp"

namespace smurf {
namespace {

using launch::path_of;
using launch::read_command;
using launch::Texts;
using launch::words_of;
using python::Value;

bool is_node(const Value& call) {
  return is_one_of(call.callee, {"Node", "LifecycleNode", "ComposableNode"});
}

class PythonLaunch {
 public:
  PythonLaunch(const FindLaunchPath& find, LaunchFile& file) : find_(find), file_(file) {}

  void run(std::string_view text) {
    const python::File python = python::read_file(text, file_.source);
    if (python.fault) {
      file_.fault = LaunchFault{python.fault->span, python.fault->message, python.fault->help};
    }
    for (const Value& call : python.calls) {
      if (call.callee != "DeclareLaunchArgument") continue;
      const std::string* name = call.items.empty() ? nullptr : call.items.front().literal();
      const Value* fallback = call.find("default_value");
      if (fallback == nullptr && call.items.size() > 1) fallback = &call.items[1];
      Value value = fallback != nullptr ? *fallback : Value{};
      if (value.is_list()) value = python::join_texts(value.items, "");
      if (name != nullptr) texts_.declare(*name, value);
    }
    for (const Value& call : python.calls) read(call);
    if (!python.fault) launch::find_mistakes(python, texts_, file_);
    file_.sets_resource_path = file_.sets_resource_path ||
                               text.find("GZ_SIM_RESOURCE_PATH") != std::string_view::npos ||
                               text.find("IGN_GAZEBO_RESOURCE_PATH") != std::string_view::npos ||
                               text.find("GAZEBO_MODEL_PATH") != std::string_view::npos;
  }

 private:
  void read(const Value& call) {
    if (is_node(call)) {
      node(call);
    } else if (call.callee == "IncludeLaunchDescription") {
      file_.has_includes = true;
    } else if (call.callee == "MoveItConfigsBuilder") {
      const Value* name = call.items.empty() ? call.find("robot_name") : &call.items.front();
      LaunchText text = name != nullptr ? texts_.of(*name) : LaunchText{};
      const bool has_package = call.find("package_name") != nullptr || call.items.size() > 1;
      if (!has_package) file_.moveit_configs.push_back(std::move(text));
    } else if (call.callee == "ParameterValue" || call.callee == "Command" ||
               call.callee.ends_with("process_file")) {
      // Read where a node gets them.
    }
    if (call.callee == "MoveItConfigsBuilder") begin_builder(call);
    if (call.callee.starts_with("MoveItConfigsBuilder.")) {
      file_.builder_methods.push_back(call.callee.substr(call.callee.rfind('.') + 1));
      builder_method(call);
    }
    note_paths(call);
  }

  /// The builder looks for relative paths in the package of the MoveIt configuration.
  /// Source: moveit_configs_utils moveit_configs_builder.py, branches humble to rolling.
  void begin_builder(const Value& call) {
    builder_ = {};
    const Value* package = call.find("package_name");
    if (package == nullptr && call.items.size() > 2) package = &call.items[2];
    const Value* name = call.items.empty() ? call.find("robot_name") : &call.items.front();
    if (package == nullptr) package = name;
    const LaunchText text = package != nullptr ? texts_.of(*package) : LaunchText{};
    if (text.is_known && text.package.empty() && !text.text.empty())
      builder_.package = text.text + (package == name ? "_moveit_config" : "");
    builder_.items = call.items.size();
    builder_.named = call.named.size();
  }

  /// `.robot_description(file_path=..., mappings={...})` or another method: the arguments of the
  /// calls before it stand in the same lists.
  void builder_method(const Value& call) {
    const std::size_t before = std::min(builder_.items, call.items.size());
    const std::span<const Value> items = std::span(call.items).subspan(before);
    const std::size_t own = call.named.size() - std::min(builder_.named, call.named.size());
    const std::span<const python::Keyword> named = std::span(call.named).first(own);
    builder_.items = call.items.size();
    builder_.named = call.named.size();
    const auto argument = [&](std::string_view name, std::size_t at) -> const Value* {
      for (const python::Keyword& one : named) {
        if (one.name == name) return &one.value;
      }
      return at < items.size() ? &items[at] : nullptr;
    };
    const Value* path = argument("file_path", 0);
    if (path == nullptr || !path->is_text()) return;
    LaunchText text = texts_.of(*path);
    const bool is_in_config =
        text.package.empty() && !text.text.starts_with('/') && !builder_.package.empty();
    if (is_in_config) {
      text.package = builder_.package;
      text.text.insert(0, "/");
    }
    if (!text.is_known || text.package.empty()) return;
    if (!call.callee.ends_with(".robot_description")) {
      if (is_in_config) add_path(text);
      return;
    }
    LaunchDescription found;
    found.span = text.span;
    found.form = LaunchDescription::Form::expanded;
    found.is_wrapped = true;
    found.tolerates_errors = true;
    found.file = path_of(text, find_);
    if (const Value* given = argument("mappings", 1)) mappings(given, found);
    file_.descriptions.push_back(std::move(found));
  }

  /// The paths that a call gets; a part of a longer path is in the arguments of no call.
  void note_paths(const Value& call) {
    if (is_one_of(call.callee, {"Command", "makedirs", "mkdir", "exists", "isfile", "isdir",
                                "os.path.exists", "os.path.isfile", "print"})) {
      return;
    }
    // A function of the author may look whether the file is there.
    const std::string_view last = std::string_view(call.callee).substr(call.callee.rfind('.') + 1);
    const bool is_function = !last.empty() && last.front() >= 'a' && last.front() <= 'z';
    if (is_function && !is_one_of(last, {"open", "read", "process_file", "load_yaml", "load_file",
                                         "append", "add_action", "extend"})) {
      return;
    }
    for (const Value& item : call.items) note_path(item, call);
    for (const auto& [name, value] : call.named) note_path(value, call);
  }

  void note_path(const Value& value, const Value& call) {
    if (value.is_text()) {
      const LaunchText text = texts_.of(value);
      const bool has_rest = text.text.find_first_not_of("/") != std::string::npos;
      if (call.callee.ends_with("LaunchDescriptionSource") && !text.package.empty()) {
        file_.included_packages.insert(text.package);
      }
      const bool is_one = text.text.find(' ') == std::string::npos;
      if (text.is_known && !text.package.empty() && has_rest && is_one) {
        add_path(text);
        return;
      }
      // Words of an argument, such as those of `gz_args`.
      if (value.pieces.size() > 1) {
        for (const Value& word : words_of(value)) {
          const LaunchText part = texts_.of(word);
          const bool is_path = part.text.find_first_not_of("/") != std::string::npos;
          if (part.is_known && !part.package.empty() && is_path) add_path(part);
        }
      }
    } else if (value.is_list()) {
      const bool is_words =
          std::any_of(value.items.begin(), value.items.end(), [](const Value& one) {
            const std::string* literal = one.literal();
            return literal != nullptr && literal->ends_with(" ");
          });
      if (is_words) {
        note_path(python::join_texts(value.items, ""), call);
      } else {
        for (const Value& item : value.items) note_path(item, call);
      }
    } else if (value.kind == Value::Kind::mapping) {
      for (const Value& item : value.items) note_path(item, call);
    }
  }

  void add_path(const LaunchText& text) {
    const bool is_known = std::any_of(file_.paths.begin(), file_.paths.end(), [&](const auto& one) {
      return one.text.package == text.package && one.text.text == text.text;
    });
    if (!is_known) file_.paths.push_back(path_of(text, find_));
  }

  void node(const Value& call) {
    LaunchNode node;
    node.span = call.span;
    node.is_conditional = call.is_conditional || call.find("condition") != nullptr;
    const auto text = [&](std::initializer_list<std::string_view> names) {
      for (const std::string_view name : names) {
        if (const Value* value = call.find(name)) return texts_.of(*value);
      }
      return LaunchText{};
    };
    node.package = text({"package"});
    node.executable = text({"executable", "node_executable", "plugin"});
    node.name = text({"name", "node_name"});
    node.name_space = text({"namespace", "node_namespace"});
    node.has_namespace =
        call.find("namespace") != nullptr || call.find("node_namespace") != nullptr;
    if (const Value* arguments = call.find("arguments")) words(*arguments, node);
    if (const Value* parameters = call.find("parameters")) {
      if (!parameters->is_list()) node.has_unknown_parameters = true;
      for (const Value& one : parameters->items) parameter(one, node);
    }
    file_.nodes.push_back(std::move(node));
  }

  void words(const Value& arguments, LaunchNode& node) {
    if (!arguments.is_list()) node.has_unknown_arguments = true;
    for (const Value& one : arguments.items) {
      LaunchText text = texts_.of(one);
      node.has_unknown_arguments = node.has_unknown_arguments || !text.is_known;
      node.arguments.push_back(std::move(text));
    }
  }

  void parameter(const Value& one, LaunchNode& node) {
    if (one.kind != Value::Kind::mapping) {
      const LaunchText text = texts_.of(one);
      if (!text.is_known) node.has_unknown_parameters = true;
      return;
    }
    for (std::size_t i = 0; i + 1 < one.items.size(); i += 2) {
      const LaunchText name = texts_.of(one.items[i]);
      if (!name.is_known) {
        node.has_unknown_parameters = true;
        continue;
      }
      if (name.text == "robot_description") description(one.items[i + 1], node);
      node.parameters.emplace_back(name, texts_.of(one.items[i + 1]));
    }
  }

  void description(const Value& value, LaunchNode& node) {
    LaunchDescription found;
    found.span = value.span;
    const Value* inner = &value;
    if (value.is_call("ParameterValue")) {
      const Value* type = value.find("value_type");
      found.is_wrapped = type != nullptr || value.items.size() > 1;
      if (value.items.empty()) return;
      inner = &value.items.front();
    }
    if (inner->is_call("Command") && !inner->items.empty()) {
      const Value& command = inner->items.front();
      found.span = inner->span;
      found.tolerates_errors = inner->find("on_stderr") != nullptr || inner->items.size() > 1;
      Value joined = command.is_list() ? python::join_texts(command.items, "") : command;
      if (joined.is_text() && !joined.pieces.empty()) read_command(joined, texts_, find_, found);
    } else if (inner->kind == Value::Kind::call &&
               inner->callee.find("process_file") != std::string::npos) {
      found.form = LaunchDescription::Form::expanded;
      if (!inner->items.empty()) found.file = path_of(texts_.of(inner->items.front()), find_);
      if (const Value* given = inner->find("mappings")) {
        mappings(given, found);
      } else {
        found.has_unknown_words = inner->items.size() > 1;
      }
    } else if (inner->is_call("open.read") && !inner->items.empty()) {
      found.form = LaunchDescription::Form::content;
      found.file = path_of(texts_.of(inner->items.front()), find_);
    } else if (inner->is_text()) {
      launch::read_path(texts_.of(*inner), find_, found);
    }
    file_.descriptions.push_back(found);
    node.descriptions.push_back(std::move(found));
  }

  /// `mappings={'name': 'value'}` of xacro.process_file.
  void mappings(const Value* given, LaunchDescription& found) const {
    found.has_unknown_words = given == nullptr || given->kind != Value::Kind::mapping;
    if (found.has_unknown_words) return;
    for (std::size_t i = 0; i + 1 < given->items.size(); i += 2) {
      const std::string* name = given->items[i].literal();
      found.has_unknown_words = found.has_unknown_words || name == nullptr;
      if (name == nullptr) continue;
      found.arguments.push_back(
          {*name, texts_.of(given->items[i + 1]), given->items[i].pieces.front().span});
    }
  }

  /// What the calls of a chain `MoveItConfigsBuilder(...).a(...).b(...)` have had so far.
  struct Builder {
    std::string package;  ///< of the configuration; empty: not known
    std::size_t items = 0, named = 0;
  };

  const FindLaunchPath& find_;
  LaunchFile& file_;
  Texts texts_;
  Builder builder_;
};

}  // namespace

void read_python_launch(std::string_view text, const FindLaunchPath& find, LaunchFile& file) {
  PythonLaunch(find, file).run(text);
}

}  // namespace smurf
