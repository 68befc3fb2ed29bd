// SPDX-License-Identifier: BSD-3-Clause
// The files of ROS that name the joints and links of a robot, found beside its description.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/load.hpp"
#include "smurf/references.hpp"
#include "smurf/srdf.hpp"
#include "smurf/surroundings.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

/// In the order of the table of kinds.
enum class CompanionKind : std::uint8_t {
  srdf,
  controllers,  ///< of ros2_control
  joint_limits,
  kinematics,
  moveit_controllers,
  ompl_planning,
  sensors_3d,
  setup_assistant,
};

/// A kind of companion.
struct CompanionSpec {
  CompanionKind kind{};
  std::string_view title;  ///< for reports: "SRDF", "controllers.yaml"
  bool is_xml = false;
};
std::span<const CompanionSpec> companion_kinds();
const CompanionSpec& spec_of(CompanionKind kind);
/// The kind of a file by its content, also where it cannot be parsed; null if it is not a
/// companion.
const CompanionSpec* find_companion_kind(std::string_view path, std::string_view text);

/// Why a file is thought to belong to a robot, the strongest reason first. Names in the file are
/// compared only where several robots have the same reason.
enum class Evidence : std::uint8_t {
  configured,       ///< `companions` of the configuration
  plugin,           ///< a plugin of the robot names it in `parameters`
  setup_assistant,  ///< the `.setup_assistant` above it names the robot
  launch,           ///< a launch file names both
  command_line,     ///< a user named both
  robot_name,       ///< an SRDF with the name of the robot, and what is beside that SRDF
  package,          ///< it is in the package of the robot
  dependency,       ///< its package depends on that of the robot, or the reverse
  below,            ///< an SRDF with the name of the robot below the searched folder
};
/// Whether a file belongs to the robot whatever names are in it.
constexpr bool is_tie(Evidence evidence) { return evidence <= Evidence::launch; }

/// A file that belongs to a robot.
struct Companion {
  CompanionKind kind{};
  SourceId source{};
  std::string folder;                      ///< in which it is
  std::optional<srdf::Description> srdf;   ///< kind srdf
  std::optional<yaml::Document> document;  ///< the other kinds
  Evidence evidence = Evidence::package;
  std::string stated_by;  ///< the launch file or .setup_assistant that gives it to the robot
  /// How many names of joints and links in it the robot has, how many there are, and which of the
  /// others are probably misspellings of names that the file does not use.
  std::size_t known_names = 0, names = 0;
  std::set<std::string, std::less<>> near_names;
  /// What all names that the robot lacks would have before or after them, if that makes most of
  /// them known: "left_".
  std::string lost_prefix;
  bool is_broken = false;  ///< it cannot be parsed; it has no `document`
  /// Files that it names and that do not exist: of a `.setup_assistant`.
  std::vector<yaml::NodeId> missing;
  /// Names that the robot lacks, but that files of xacro around it write.
  std::set<std::string, std::less<>> of_variants;
  bool is_compared = false;  ///< with variants of the robot
  bool is_ros2 = false;      ///< its package is built with ament, or it is only of use in ROS 2
};

/// A parameter file that a plugin of Gazebo for ros2_control names.
struct PluginFile {
  enum class State : std::uint8_t {
    unknown,      ///< it may be made when the robot is built or launched
    missing,      ///< its package was found, but not the file
    other,        ///< it has no section controller_manager
    controllers,  ///< one of the companions
  };
  xml::ElementId element{};  ///< `parameters`
  std::string path;
  State state{};
};

/// A class that a package around the robot exports for pluginlib.
struct ExportedClass {
  std::string package;
  std::string name;  ///< "arm_driver/Arm"
  std::string base;  ///< "hardware_interface::SystemInterface"
};

/// A file in reach of a robot that does not fit it.
struct RejectedCompanion {
  std::string path;
  std::size_t known_names = 0, names = 0;
};

/// The companions of one robot, in the order of their paths. Views point into them and into the
/// SourceMap, so they are moved, not copied.
struct Companions {
  std::vector<Companion> files;
  std::vector<PluginFile> plugin_files;
  /// The hardware is one of Gazebo, and no description around the robot writes the plugin that
  /// loads it, also not for other arguments.
  bool lacks_simulation = false;
  /// Of the packages that the hardware and the controllers name, if they are around the robot.
  std::vector<ExportedClass> classes;
  bool checks_first_only = false;  ///< the robot was loaded to check the first of the files
  Surroundings surroundings;
  std::vector<RejectedCompanion> rejected;
};

/// A robot of xacro with other arguments, and the companions that are meant for it.
struct Variant {
  LinkedModel model;
  Companions companions;
  std::string arguments;  ///< "dof:=6"
};

/// A robot and its companions.
struct Accompanied {
  LinkedModel model;
  Companions companions;
  std::vector<Variant> variants = {};  ///< of the robot, with companions that do not fit it
};

/// Whether a path is that of a companion that can be checked alone: an .srdf.
bool is_companion_path(std::string_view path);

/// Reads the files that may be companions of a robot, with the evidence of that: those that are
/// tied to it, and those in its package and in packages that depend on it that fit it. Several
/// robots may have the same file; choose_owners() decides (src/plan/ownership.hpp).
Companions load_companions(const LinkedModel& model, LoadContext& context);

/// Loads a companion with the robot that it belongs to, or any other file as load_model() does,
/// with its companions.
Accompanied load_accompanied(const std::string& path, LoadContext& context);

/// Adds what surrounds a robot: files of its package, and launch files that name it in packages
/// that depend on that one. Gives meshes their places in the sources of packages that install them
/// elsewhere.
void add_surroundings(Accompanied& robot, LoadContext& context);

/// Moves each companion that has names which the robot lacks, an SRDF with the other files in its
/// folder, to a variant of the robot: if other values of the arguments of its xacro give it more of
/// the names. Tries `values` of arguments, too, and those that the files around the robot use.
void split_variants(Accompanied& robot, LoadContext& context,
                    const std::map<std::string, std::vector<std::string>>& values = {});

/// All names in companions, those that the robot does not have included.
std::vector<Reference> companion_references(const LinkedModel& model, const Companions& companions);

/// The names of the robot in its surroundings: in launch files, and in files of navigation and
/// RViz. Omits those that it does not have, which may be frames of other programs, and files that
/// are given to other robots.
std::vector<Reference> surrounding_references(const LinkedModel& model,
                                              const Companions& companions);

}  // namespace smurf
