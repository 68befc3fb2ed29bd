// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/deadline.hpp"
#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "link/companions/companion_names.hpp"
#include "link/companions/exported_classes.hpp"
#include "link/companions/library.hpp"
#include "link/companions/places.hpp"
#include "link/companions/plugin_files.hpp"
#include "link/companions/read_companion.hpp"
#include "link/package_search.hpp"
#include "smurf/companions.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostCandidates = 400;                // files that may be companions
constexpr std::size_t kMostRobots = 6;                      // that are tried for an SRDF
constexpr std::uint64_t kMostBytesOfPlugins = 256U << 10U;  // of a description

using NameLists = std::initializer_list<std::vector<std::string> NamesInFolder::*>;

/// Files of these kinds in these folders, each once.
std::vector<std::string> candidates(const std::vector<std::string>& folders, NameLists wanted,
                                    LoadContext& context) {
  CompanionLibrary& library = *search_of(context).companions;
  std::vector<std::string> found;
  std::set<std::string> seen;
  for (const std::string& place : folders) {
    const NamesInFolder& inside = library.folders->names_in(place, context.files);
    for (const auto kind : wanted) {
      for (const std::string& name : inside.*kind) {
        std::string path = path::join(place, name);
        if (!seen.insert(context.files.identity(path)).second) continue;
        found.push_back(std::move(path));
        if (found.size() >= kMostCandidates) return found;
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Whether an SRDF may be for a robot: half of its names are enough if it has the name of the
/// robot. Others are for another robot, unless the robot has nearly all of them.
bool may_belong_to(const LinkedModel& robot, const Companion& companion) {
  const srdf::Text& name = companion.srdf->name;
  const std::size_t known = companion.known_names + companion.near_names.size();
  if (robot.robot && robot.robot->name && name && *robot.robot->name == *name) {
    return known * 2 >= companion.names;
  }
  constexpr std::size_t kFewest = 4;  // fewer may be the same by chance
  return companion.names >= kFewest && known * 10 >= companion.names * 9;
}

/// Whether two names differ at most in capitals: `icub` and `iCub`.
bool is_same_word(std::string_view a, std::string_view b) {
  return path::to_lower(a) == path::to_lower(b);
}

/// Whether one of these files describes a robot of this name.
bool has_robot(const std::vector<std::string>& paths, std::string_view name,
               const LoadContext& context) {
  return std::any_of(paths.begin(), paths.end(), [&](const std::string& path) {
    const FileContent content = context.files.read(path, context.limits.file_bytes);
    return content.status == ReadStatus::ok && robot_name_in(content.text) == name;
  });
}

/// The names of the robots in these files, at most so many. Parts of a xacro have none.
std::set<std::string> robot_names(const std::vector<std::string>& paths, const LoadContext& context,
                                  std::size_t most) {
  std::set<std::string> names;
  for (const std::string& path : paths) {
    if (names.size() >= most) break;
    if (is_companion_path(path)) continue;
    const FileContent content = context.files.read(path, context.limits.file_bytes);
    const std::string_view name = robot_name_in(content.text);
    if (content.status == ReadStatus::ok && !name.empty()) names.emplace(name);
  }
  return names;
}

class Finder {
 public:
  Finder(const LinkedModel& model, LoadContext& context)
      : model_(model),
        context_(context),
        reader_(context),
        library_(*search_of(context).companions) {}

  Companions run() {
    for (const ModelFile& file : model_.files) {
      own_.insert(context_.files.identity(context_.sources.path(file.source)));
    }
    read_ties();
    found_.plugin_files = plugin_files_of(model_, context_);
    for (const PluginFile& one : found_.plugin_files) {
      if (one.state == PluginFile::State::controllers) look_at(one.path, Evidence::plugin);
    }
    places_ = companion_places(std::string(path::parent(model_.urdf_path)), context_.files,
                               search_of(context_));
    read_stated(Evidence::setup_assistant);
    read_stated(Evidence::launch);
    const bool is_named = library_.named_robots.contains(context_.files.identity(model_.path));
    for (const NearCompanion& one : library_.near) {
      if (is_named && one.is_named) look_at(one.path, Evidence::command_line);
    }
    found_.lacks_simulation = lacks_simulation();
    look_in(0, places_.own, Evidence::package);
    look_in(places_.own, places_.folders.size(), Evidence::dependency);
    for (const NearCompanion& one : library_.near) {
      if (is_companion_path(one.path)) look_at(one.path, Evidence::below);
    }
    for (const NearCompanion& one : library_.near) look_at(one.path, Evidence::below);
    for (Companion& one : found_.files) count_names(model_, one);
    std::erase_if(found_.files, [&](const Companion& one) { return !fits(one); });
    mark_beside();
    std::sort(found_.files.begin(), found_.files.end(), [&](const auto& a, const auto& b) {
      return context_.sources.path(a.source) < context_.sources.path(b.source);
    });
    found_.classes = exported_classes(model_, found_, places_.packages, context_.files);
    return std::move(found_);
  }

 private:
  /// What the configuration says: files of this robot are loaded, those of others are not.
  void read_ties() {
    if (context_.ties.empty()) return;
    const std::string robot = context_.files.identity(model_.urdf_path);
    const std::string main = context_.files.identity(model_.path);
    std::vector<std::string> of_others;
    for (const CompanionTie& tie : context_.ties) {
      const std::string id = context_.files.identity(tie.robot);
      const bool is_own = id == robot || id == main;
      for (const std::string& path : tie.files) {
        if (is_own) {
          look_at(path, Evidence::configured);
        } else {
          of_others.push_back(path);
        }
      }
    }
    for (const std::string& one : of_others) own_.insert(context_.files.identity(one));
  }

  /// What launch files, or a .setup_assistant, give to this robot.
  void read_stated(Evidence evidence) {
    const std::string robot = context_.files.identity(model_.urdf_path);
    for (const NearPackage& package : places_.packages) {
      for (const StatedTie& tie : library_.stated->in_package(package, context_)) {
        const bool is_own =
            std::find(tie.robots.begin(), tie.robots.end(), robot) != tie.robots.end();
        if (tie.evidence != evidence || !is_own) continue;
        for (const std::string& file : tie.files) look_at(file, evidence, tie.by);
      }
    }
  }

  void look_in(std::size_t begin, std::size_t end, Evidence evidence) {
    const std::vector<std::string> folders(
        places_.folders.begin() + static_cast<std::ptrdiff_t>(begin),
        places_.folders.begin() + static_cast<std::ptrdiff_t>(end));
    for (const std::string& path : candidates(folders, {&NamesInFolder::companions}, context_)) {
      look_at(path, evidence);
    }
  }

  /// Reads a file that may be for the robot, once. The strongest evidence comes first.
  void look_at(const std::string& path, Evidence evidence, const std::string& stated_by = {}) {
    const SeenCompanion& seen = library_.look_at(path, context_.files);
    if (seen.what.spec == nullptr || seen.what.state == CompanionState::a_template) return;
    if (!own_.insert(context_.files.identity(path)).second) return;
    if (evidence >= Evidence::package && is_of_other_plugin(path)) return;
    const bool is_xacro = xacro::is_xacro_file(path);
    const bool is_bound = is_tie(evidence);
    if (seen.what.spec->is_xml) {
      // A xacro file without a name is a part of others, and an expression may be any name.
      if (is_xacro && seen.robot.empty()) return;
      const bool is_computed = is_xacro && seen.robot.find('$') != std::string::npos;
      const bool is_for_any = is_computed || is_bound || evidence == Evidence::command_line;
      if (!is_for_any && !may_be_for(seen.robot, evidence)) return;
    } else if (!is_bound && seen.what.state == CompanionState::readable) {
      const NameScore score = score_of(seen.names, model_);
      const bool is_far = evidence == Evidence::below;
      const bool is_alien = is_far && (score.names == 0 ? !is_beside_srdf(path) : score.known == 0);
      if (is_alien || (!is_enough(score) && score.lost_prefix.empty())) {
        found_.rejected.push_back({path, score.known, score.names});
        return;
      }
    }
    auto companion = reader_.read(path, *seen.what.spec, is_xacro ? &model_ : nullptr);
    if (!companion) return;
    companion->evidence = evidence;
    companion->stated_by = stated_by;
    found_.files.push_back(std::move(*companion));
  }

  bool fits(const Companion& one) {
    if (is_tie(one.evidence) || !one.srdf) return true;
    return may_belong_to(model_, one) && !has_better_robot(one);
  }

  /// Where files lie that belong to the same configuration as an SRDF.
  std::set<std::string> folders_of_srdfs() const {
    std::set<std::string> folders;
    for (const Companion& one : found_.files) {
      if (!one.srdf) continue;
      folders.insert(one.folder);
      if (path::file_name(one.folder) == "srdf") {
        folders.insert(path::normalize(path::join(one.folder, "../config")));
      }
      folders.insert(path::normalize(path::join(one.folder, "..")));  // of .setup_assistant
    }
    return folders;
  }
  bool is_beside_srdf(const std::string& path) const {
    return folders_of_srdfs().contains(path::normalize(std::string(path::parent(path))));
  }

  /// What lies beside an SRDF of the robot is meant for it; files of MoveIt without joints only
  /// then, or if there is no other robot.
  void mark_beside() {
    const std::set<std::string> folders = folders_of_srdfs();
    for (Companion& one : found_.files) {
      if (!one.srdf) continue;
      const srdf::Text& name = one.srdf->name;
      const bool is_same = name && model_.robot->name && *name == *model_.robot->name;
      if (is_same && one.evidence > Evidence::robot_name) one.evidence = Evidence::robot_name;
    }
    std::erase_if(found_.files, [&](Companion& one) {
      if (one.srdf || is_tie(one.evidence)) return false;
      const bool is_beside = folders.contains(one.folder);
      // Robots of a family have the same names, and other limits: what is far away only names
      // joints, and no other ones.
      const bool is_whole = (one.kind == CompanionKind::controllers ||
                             one.kind == CompanionKind::moveit_controllers) &&
                            one.names > 0 && one.known_names + one.near_names.size() == one.names;
      if (!is_beside && one.evidence == Evidence::below && !is_whole) return true;
      if (is_beside && one.evidence > Evidence::robot_name) one.evidence = Evidence::robot_name;
      const bool is_of_moveit = one.kind != CompanionKind::controllers;
      return is_of_moveit && one.names == 0 && !one.is_broken && !is_beside && !is_only_robot();
    });
  }

  /// Whether an SRDF with this robot name may be one of the robot. Other names are mistakes if the
  /// robot is the only one around.
  bool may_be_for(std::string_view name, Evidence evidence) {
    if (model_.robot->name && is_same_word(name, *model_.robot->name)) return true;
    const auto is_urdf = [](const std::string& path) {
      return path::to_lower(path::extension(path)) == ".urdf";
    };
    const std::vector<std::string>& all = robots();
    const bool is_only_urdf = std::count_if(all.begin(), all.end(), is_urdf) == 1;
    if (!is_only_urdf && evidence == Evidence::below) return false;
    if (!names_) names_ = robot_names(all, context_, is_only_urdf ? all.size() : 2);
    return (is_only_urdf || names_->size() == 1) && !names_->contains(std::string(name));
  }

  const std::vector<std::string>& robots() {
    if (!robots_)
      robots_ =
          candidates(places_.folders, {&NamesInFolder::urdfs, &NamesInFolder::xacros}, context_);
    return *robots_;
  }

  /// Whether the plugin of another robot names the file, while that of this robot names others.
  bool is_of_other_plugin(const std::string& path) {
    const bool has_own =
        std::any_of(found_.plugin_files.begin(), found_.plugin_files.end(),
                    [](const auto& one) { return one.state == PluginFile::State::controllers; });
    if (!has_own) return false;
    if (!of_other_plugins_) {
      of_other_plugins_.emplace();
      for (const std::string& robot : robots()) {
        if (own_.contains(context_.files.identity(robot))) continue;
        const FileContent content = context_.files.read(robot, kMostBytesOfPlugins);
        add_plugin_files(content.text, *of_other_plugins_);
      }
    }
    const std::string whole = "/" + path::normalize(path);
    return std::any_of(of_other_plugins_->begin(), of_other_plugins_->end(),
                       [&](const std::string& end) { return whole.ends_with(end); });
  }

  /// Whether hardware of Gazebo has no plugin, also not in other descriptions.
  bool lacks_simulation() {
    const std::string_view own = context_.sources.text(model_.robot->document.source);
    const bool is_simulated = own.find("GazeboSimSystem") != own.npos ||
                              own.find("IgnitionSystem") != own.npos ||
                              own.find("GazeboSystem") != own.npos;
    if (!is_simulated || !found_.plugin_files.empty()) return false;
    return std::none_of(robots().begin(), robots().end(), [&](const std::string& path) {
      const std::string text = context_.files.read(path, context_.limits.file_bytes).text;
      return text.find("ROS2Control") != text.npos ||
             text.find("ros2_control-system") != text.npos ||
             text.find("gazebo_ros2_control.so") != text.npos;
    });
  }

  bool is_only_robot() { return robots().size() <= 1; }

  /// Whether another robot of the same name, such as a variant with a gripper, has more of the
  /// names in an SRDF.
  bool has_better_robot(const Companion& companion) {
    if (companion.known_names == companion.names) return false;
    std::vector<std::size_t> names;
    const std::vector<Reference> references = names_in_companion(model_, companion);
    for (const Reference& one : references) names.push_back(hash_of(one.name));
    sort_without_repetitions(names);
    const auto score = [&](const std::vector<std::size_t>& words) {
      std::vector<std::size_t> common;
      std::set_intersection(names.begin(), names.end(), words.begin(), words.end(),
                            std::back_inserter(common));
      return common.size();
    };
    const auto own = score(words_in(context_.sources.text(model_.robot->document.source)));
    return std::any_of(variants().begin(), variants().end(),
                       [&](const auto& words) { return score(words) > own; });
  }

  static std::size_t hash_of(std::string_view text) { return std::hash<std::string_view>()(text); }

  static void sort_without_repetitions(std::vector<std::size_t>& all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }

  /// Hashes of what is between two quotes: names may be.
  static std::vector<std::size_t> words_in(std::string_view text) {
    Deadline::look(1 + text.size() / 64);
    std::vector<std::size_t> words;
    for (std::size_t begin = text.find('"'); begin != text.npos;) {
      const std::size_t end = text.find('"', ++begin);
      if (end == text.npos) break;
      words.push_back(hash_of(text.substr(begin, end - begin)));
      begin = end;
    }
    sort_without_repetitions(words);
    return words;
  }

  /// The words of the robots of the same name. Each text is read once for all SRDFs: a package may
  /// have dozens of both.
  const std::vector<std::vector<std::size_t>>& variants() {
    if (variants_) return *variants_;
    variants_.emplace();
    for (const std::string& path : robots()) {
      const FileContent content = context_.files.read(path, context_.limits.file_bytes);
      const bool is_same = robot_name_in(content.text) == model_.robot->name.value_or("");
      if (content.status != ReadStatus::ok || !is_same) continue;
      variants_->push_back(words_in(content.text));
    }
    return *variants_;
  }

  const LinkedModel& model_;
  LoadContext& context_;
  CompanionReader reader_;
  CompanionLibrary& library_;
  Companions found_;
  CompanionPlaces places_;
  std::optional<std::vector<std::string>> robots_;  ///< around it, also in xacro
  std::optional<std::set<std::string>> names_;      ///< of the robots, see may_be_for()
  std::optional<std::vector<std::vector<std::size_t>>> variants_;
  /// Ends of the paths of files that plugins of other robots name.
  std::optional<std::set<std::string, std::less<>>> of_other_plugins_;
  std::set<std::string> own_;  ///< files of the model, of others, and those looked at, by identity
};

/// The robots around an SRDF with its robot name, URDFs before xacro files; else the only URDF.
std::vector<std::string> robots_of(const Companion& companion, LoadContext& context) {
  const srdf::Text& name = companion.srdf->name;
  const std::string folder(path::parent(context.sources.path(companion.source)));
  const std::vector<std::string> folders =
      companion_places(folder, context.files, search_of(context)).folders;
  const std::vector<std::string> urdfs = candidates(folders, {&NamesInFolder::urdfs}, context);
  const std::vector<std::string> xacros = candidates(folders, {&NamesInFolder::xacros}, context);
  std::vector<std::string> found;
  for (const auto& all : {urdfs, xacros}) {
    for (const std::string& path : all) {
      if (!name || is_companion_path(path) || found.size() >= kMostRobots) continue;
      if (has_robot({path}, *name, context)) found.push_back(path);
    }
  }
  for (const std::string& path : urdfs) {
    if (!found.empty() || !name) break;
    const FileContent content = context.files.read(path, context.limits.file_bytes);
    if (is_same_word(robot_name_in(content.text), *name)) found.push_back(path);
  }
  if (found.empty() && urdfs.size() == 1) found.push_back(urdfs.front());
  if (!found.empty() || !urdfs.empty() || robot_names(xacros, context, 2).size() != 1) return found;
  for (const std::string& path : xacros) {
    if (!robot_names({path}, context, 1).empty()) found.push_back(path);
  }
  return found;
}

/// The robots to which the configuration ties a file.
std::vector<std::string> tied_robots_of(const std::string& path, const LoadContext& context) {
  std::vector<std::string> robots;
  for (const CompanionTie& tie : context.ties) {
    const bool is_here = std::any_of(tie.files.begin(), tie.files.end(), [&](const auto& file) {
      return context.files.identity(file) == context.files.identity(path);
    });
    if (is_here) robots.push_back(tie.robot);
  }
  return robots;
}

Accompanied load_companion(const std::string& path, LoadContext& context) {
  Accompanied loaded;
  loaded.model.path = path::normalize(path);
  loaded.companions.checks_first_only = true;
  auto companion = CompanionReader(context).read(path, spec_of(CompanionKind::srdf));
  if (!companion) {
    loaded.model.is_complete = false;
    return loaded;
  }
  std::vector<std::string> robots = tied_robots_of(path, context);
  const bool is_tied = !robots.empty();
  if (!is_tied) robots = robots_of(*companion, context);
  std::size_t best = 0;  // names of the best robot
  for (const std::string& robot : robots) {
    Deadline::look();
    LinkedModel found = load_model(robot, context);
    count_names(found, *companion);
    if (!found.robot || (!is_tied && !may_belong_to(found, *companion))) continue;
    if (loaded.model.robot && companion->known_names <= best) continue;
    best = companion->known_names;
    loaded.model = std::move(found);
    if (best == companion->names) break;
  }
  if (loaded.model.robot) count_names(loaded.model, *companion);
  loaded.companions.files.push_back(std::move(*companion));
  return loaded;
}

}  // namespace

bool is_companion_path(std::string_view path) {
  const std::string name = path::to_lower(path::file_name(path));
  return name.ends_with(".srdf") || name.ends_with(".srdf.xacro");
}

Companions load_companions(const LinkedModel& model, LoadContext& context) {
  return model.robot ? Finder(model, context).run() : Companions{};
}

Accompanied load_accompanied(const std::string& path, LoadContext& context) {
  if (is_companion_path(path)) return load_companion(path, context);
  Accompanied loaded{load_model(path, context), {}};
  loaded.companions = load_companions(loaded.model, context);
  return loaded;
}

}  // namespace smurf
