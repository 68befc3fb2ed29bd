// SPDX-License-Identifier: BSD-3-Clause
// The packages around a robot: their launch files, and what they install.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/source.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// A text in a launch file, as far as it is known without executing the file.
struct LaunchText {
  Span span;  ///< its last literal part
  std::string text;
  bool is_known = false;    ///< wholly
  bool by_default = false;  ///< with the default of a launch argument
  std::string package;      ///< it begins with the share folder of this package
  Span package_span;        ///< where its name is written
};

/// A file in the share folder of a package, or a path that is given as it is.
struct LaunchPath {
  LaunchText text;
  std::string path;        ///< in the sources; empty if its package is not here
  bool exists = false;     ///< as a file or a folder, in the sources or as installed
  bool is_judged = false;  ///< its package is here, and the text is wholly known
  std::string similar;     ///< a file beside it with a similar name
};

/// What a node gets as `robot_description`.
struct LaunchDescription {
  enum class Form : std::uint8_t {
    unknown,
    command,   ///< the output of a program
    expanded,  ///< xacro.process_file
    content,   ///< of a file, as it is
    path,      ///< the path of a file, not its text
  };
  Form form = Form::unknown;
  Span span;
  bool is_wrapped = false;        ///< ParameterValue(..., value_type=str), type="str"
  bool tolerates_errors = false;  ///< a second argument of Command
  LaunchText program;             ///< "xacro"
  bool lacks_blank = false;       ///< between the program and the path: `Command(['xacro', path])`
  std::optional<LaunchPath> file;
  /// `NAME:=VALUE`.
  struct Argument {
    std::string name;
    LaunchText value;
    Span span;
  };
  std::vector<Argument> arguments;  ///< of the xacro
  bool has_unknown_words = false;   ///< there may be more arguments
  std::set<std::string> options;    ///< "--inorder"
  bool is_of_robot = false;         ///< the file is that of the robot
};

/// A node that a launch file starts.
struct LaunchNode {
  Span span;
  LaunchText package, executable, name, name_space;
  bool has_namespace = false;
  bool is_conditional = false;
  std::vector<LaunchText> arguments;
  bool has_unknown_arguments = false;
  /// Names of parameters that are written in the launch file, with their values.
  std::vector<std::pair<LaunchText, LaunchText>> parameters;
  bool has_unknown_parameters = false;
  std::vector<LaunchDescription> descriptions;
};

/// Why a launch file is no Python, XML or YAML.
struct LaunchFault {
  Span span;
  std::string message, help;
};

/// What raises an error when a launch file is executed, and is seen without executing it.
struct LaunchMistake {
  enum class Kind : std::uint8_t {
    word,          ///< an element, attribute or keyword that launch does not have, or lacks
    type,          ///< a value of another type than launch reads
    substitution,  ///< `$(...)` that launch cannot read
    unset,         ///< an argument that nothing sets before it is read
    value,         ///< a condition that is no boolean, a name that no node can have
    program,       ///< the name of no program
  };
  Kind kind{};
  Span span;
  std::string message, help;
  std::string replacement = {};  ///< of the text at `span`; empty: none is known
  bool is_doubtful = false;      ///< others may give the argument, or another value
};

/// A package that a launch file names, that is not here, and whose name is similar to one that is.
struct LaunchPackage {
  Span span;
  std::string name, similar;
};

/// Whose a file around a robot is, besides the names in it.
enum class Whose : std::uint8_t {
  any,     ///< of each robot that has it around and fits
  own,     ///< the configuration, a launch file or a .setup_assistant gives it to the robot
  others,  ///< the same, but only to other robots
};

/// A launch file, as far as it is known.
struct LaunchFile {
  enum class Form : std::uint8_t { python, xml, yaml };
  Form form = Form::python;
  SourceId source{};
  std::string path, package;
  std::string_view text;
  Whose whose = Whose::any;
  bool is_ros1 = false;
  std::optional<LaunchFault> fault;  ///< the first
  std::vector<LaunchMistake> mistakes;
  std::vector<LaunchNode> nodes;
  std::vector<LaunchPackage> misspelt_packages;
  std::vector<LaunchPath> paths;  ///< that it gives to nodes, includes and functions
  std::vector<LaunchDescription> descriptions;
  std::vector<LaunchText> moveit_configs;  ///< names of robots, MoveItConfigsBuilder
  std::vector<std::string> builder_methods;
  std::set<std::string> included_packages;  ///< whose launch files it includes
  bool sets_resource_path = false;          ///< GZ_SIM_RESOURCE_PATH, GAZEBO_MODEL_PATH
  bool has_includes = false;
  bool is_included = false;  ///< by another one around the robot
  bool is_of_robot = false;  ///< it describes the robot, or names a parameter file of it
};

/// A fault in the build files of a package.
struct InstallFault {
  enum class Kind : std::uint8_t {
    no_folder,      ///< install(DIRECTORY x) of a folder that does not exist
    not_installed,  ///< a folder that the robot or a launch file names
    glob_folder,    ///< glob('x/*') matches a folder
    glob_empty,     ///< glob('x/*.y') matches nothing
    wrong_package,  ///< share/OTHER
    project_name,   ///< project() differs from the name in package.xml
    no_xml,         ///< package.xml is not well-formed: what is wrong, and the help
  };
  Kind kind{};
  Span span;
  std::string what, other;
};

/// A package around a robot, and what is wrong in its build file.
struct SurroundingPackage {
  std::string name, folder;
  SourceId manifest{};
  std::optional<SourceId> build_file;  ///< CMakeLists.txt or setup.py
  bool is_ament = false;
  std::map<std::string, Span, std::less<>> dependencies;  ///< where its package.xml names them
  std::vector<InstallFault> faults;
  Span name_span, depend_span, export_span;  ///< in its package.xml
  bool has_hooks = false;                    ///< that set variables of the environment
  std::vector<std::string> config_files;     ///< names in its folder config
};

/// A file that names frames of a robot for other programs than ros2_control and MoveIt.
struct FrameFile {
  enum class Form : std::uint8_t { parameters, rviz, lua };
  Form form = Form::parameters;
  SourceId source{};
  std::string path;
  std::optional<yaml::Document> document;  ///< not of lua
  std::string_view text;
  Whose whose = Whose::any;
};

/// An argument that a xacro declares.
struct XacroArgument {
  std::string name;
  bool has_default = false;
  Span span = {};  ///< of the name in `xacro:arg`; empty: it is only used
};

/// A world of Gazebo that a launch file starts.
struct LaunchWorld {
  Span place;                     ///< of its name
  std::set<std::string> plugins;  ///< file names
};

/// Of one robot. Findings in its files do not depend on other robots.
struct Surroundings {
  bool is_xacro = false, is_expanded = true;  ///< false: arguments are missing
  std::vector<XacroArgument> arguments;       ///< of the xacro of the robot and what it includes
  bool has_all_arguments = true;  ///< false: it may have more in files that are not here
  std::vector<FrameFile> frame_files;
  std::vector<std::string> other_robots;  ///< texts of other descriptions in the package
  bool has_frame_prefix = false;          ///< in a launch file
  /// What breaks the text of the robot when it is read as YAML.
  std::optional<Span> not_yaml;
  std::vector<Span> noisy_calls;     ///< about which xacro warns
  bool may_choose_hardware = false;  ///< the xacro names the hardware of Gazebo, too
  std::vector<LaunchWorld> worlds;
  /// Meshes that are where their package installs them: indices in LinkedModel::meshes, paths.
  std::map<std::size_t, std::string> installed_meshes;

  std::vector<SurroundingPackage> packages;  ///< that of the robot first
  std::vector<LaunchFile> launch_files;
  std::set<SourceId> sources;
  /// Whether a package launches Gazebo; Gazebo Classic.
  bool launches_gazebo = false, launches_classic = false;
};

}  // namespace smurf
