// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ast/companions/srdf_reader.hpp"
#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "link/companions/companion_names.hpp"
#include "link/companions/exported_classes.hpp"
#include "link/companions/places.hpp"
#include "link/companions/plugin_files.hpp"
#include "link/companions/setup_assistant.hpp"
#include "link/package_search.hpp"
#include "link/read_file.hpp"
#include "link/xacro_model.hpp"
#include "smurf/companions.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostCandidates = 400;  // files that may be companions
constexpr std::size_t kMostRobots = 6;        // that are tried for an SRDF
/// Companions of other robots, and lists of parameters of other programs, are larger.
constexpr std::uint64_t kMostBytesOfYaml = 1U << 20U;

/// Whether a path ends with this, in any case. Searches ask it of every file, so it makes no copy.
bool has_ending(std::string_view path, std::string_view lower) {
  if (path.size() < lower.size()) return false;
  const std::string_view end = path.substr(path.size() - lower.size());
  return std::equal(end.begin(), end.end(), lower.begin(), [](char c, char wanted) {
    return (c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) == wanted;
  });
}

using NameLists = std::initializer_list<std::vector<std::string> NamesInFolder::*>;

/// Files of these kinds in these folders, each once.
std::vector<std::string> candidates(const std::vector<std::string>& folders, NameLists wanted,
                                    LoadContext& context) {
  PackageSearch& search = search_of(context);
  std::vector<std::string> found;
  std::set<std::string> seen;
  for (const std::string& place : folders) {
    const NamesInFolder& inside = search.names_in(place);
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

/// Whether the package around a folder is built with ament, as those of ROS 2 are.
bool is_in_ros2_package(std::string folder, const FileReader& files) {
  for (int level = 0; level < 4; ++level, folder = path::join(folder, "..")) {
    const FileContent manifest = files.read(path::join(folder, "package.xml"), kMostBytesOfYaml);
    if (manifest.status == ReadStatus::ok) return manifest.text.find("ament") != std::string::npos;
  }
  return false;
}

class Loader {
 public:
  explicit Loader(LoadContext& context) : context_(context) {}

  /// Reads a file as a companion of this kind; none if it cannot be parsed. A xacro file that was
  /// found for a robot may need arguments or packages that are not known here, which is no finding.
  std::optional<Companion> read(const std::string& path, const CompanionSpec& spec,
                                const LinkedModel* robot = nullptr) {
    const auto source = read_source(path, {}, rules::sml0001_unreadable_file, context_);
    if (!source) return std::nullopt;
    Companion companion;
    companion.kind = spec.kind;
    companion.source = *source;
    companion.folder = path::parent(path::normalize(path));
    // These exist in ROS 2 only.
    companion.is_ros2 = spec.kind == CompanionKind::controllers ||
                        spec.kind == CompanionKind::moveit_controllers ||
                        is_in_ros2(companion.folder);
    if (spec.is_xml) {
      const auto text = xacro::is_xacro_file(path) ? expanded(*source, robot) : source;
      if (!text) return std::nullopt;
      auto document = parse_xml(context_.sources, *text, context_.limits, context_.sink);
      if (!document) return std::nullopt;
      companion.srdf = srdf::read(std::move(*document));
      if (text != source && !companion.srdf->name) return std::nullopt;  // a part of others
    } else {
      // It may be a template, which a launch file fills in.
      DiagnosticSink ignored(context_.limits);
      companion.document = parse_yaml(context_.sources, *source, context_.limits, ignored);
      if (!companion.document || ignored.has_errors()) return std::nullopt;
      if (spec.kind == CompanionKind::setup_assistant) find_missing_files(companion, context_);
    }
    return companion;
  }

 private:
  std::optional<SourceId> expanded(SourceId root, const LinkedModel* robot) {
    DiagnosticSink ignored(context_.limits);
    LoadContext quiet{context_.sources, context_.files,    ignored,
                      context_.limits,  context_.packages, context_.package_folders,
                      context_.meshes,  context_.schemas,  context_.read,
                      context_.parsed,  context_.xacro,    context_.expansions};
    // Launch files often pass the name of the robot.
    if (robot != nullptr) quiet.xacro.arguments.emplace("name", robot->robot->name.value_or(""));
    xacro::Expansion expansion = expand_xacro(root, robot != nullptr ? quiet : context_);
    if (!expansion.is_complete) return std::nullopt;
    const SourceId source = expansion.source;
    context_.expansions->emplace(source, std::move(expansion));
    return source;
  }

  bool is_in_ros2(const std::string& folder) {
    const auto [known, is_new] = ros2_.try_emplace(folder);
    if (is_new) known->second = is_in_ros2_package(folder, context_.files);
    return known->second;
  }

  LoadContext& context_;
  std::map<std::string, bool> ros2_;  ///< by folder
};

/// A robot belongs to an SRDF if it has two thirds of the names in it, and a robot of another name
/// if it has nearly all: thousands of robots are called "robot".
bool belongs_to(const LinkedModel& robot, const Companion& companion) {
  const srdf::Text& name = companion.srdf->name;
  if (robot.robot && robot.robot->name && name && *robot.robot->name == *name) {
    return companion.known_names * 3 >= companion.names * 2;
  }
  constexpr std::size_t kFewest = 4;  // fewer may be the same by chance
  return companion.names >= kFewest && companion.known_names * 10 >= companion.names * 9;
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

class Finder {
 public:
  Finder(const LinkedModel& model, LoadContext& context)
      : model_(model), context_(context), loader_(context) {}

  Companions run() {
    for (const ModelFile& file : model_.files) {
      own_.insert(context_.files.identity(context_.sources.path(file.source)));
    }
    read_ties();
    places_ = companion_places(std::string(path::parent(model_.urdf_path)), context_.files);
    for (const std::string& path :
         candidates(places_.folders, {&NamesInFolder::companions}, context_)) {
      if (!own_.contains(context_.files.identity(path))) look_at(path);
    }
    found_.plugin_files = plugin_files_of(model_, context_.files);
    for (const PluginFile& one : found_.plugin_files) {
      if (one.state != PluginFile::State::controllers) continue;
      if (!has(one.path)) look_at(one.path);
      tied_.insert(context_.files.identity(one.path));
    }
    for (Companion& one : found_.files) count_names(model_, one);
    std::erase_if(found_.files, [&](const Companion& one) {
      if (is_tied(one)) return false;
      return one.srdf ? !belongs_to(model_, one) || has_better_robot(one)
                      : one.known_names * 2 < one.names;
    });
    std::set<std::string> folders;  // of the SRDFs of the robot
    for (const Companion& one : found_.files) {
      if (!one.srdf) continue;
      folders.insert(one.folder);
      if (path::file_name(one.folder) == "srdf") {
        folders.insert(path::normalize(path::join(one.folder, "../config")));
      }
      folders.insert(path::normalize(path::join(one.folder, "..")));  // of .setup_assistant
    }
    // Robots of one family have the same names, so an SRDF decides which of them is meant.
    std::erase_if(found_.files, [&](const Companion& one) {
      const bool is_free = one.srdf || one.kind == CompanionKind::controllers || is_tied(one);
      return !is_free && !folders.contains(one.folder) && !is_only_robot();
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
    std::set<std::string> of_others;
    for (const CompanionTie& tie : context_.ties) {
      const std::string id = context_.files.identity(tie.robot);
      const bool is_own = id == robot || id == main;
      for (const std::string& path : tie.files) {
        (is_own ? tied_ : of_others).insert(context_.files.identity(path));
        if (is_own) look_at(path, true);
      }
    }
    for (const std::string& one : of_others) own_.insert(one);
    for (const std::string& one : tied_) own_.insert(one);
  }

  bool is_tied(const Companion& one) const {
    return !tied_.empty() &&
           tied_.contains(context_.files.identity(context_.sources.path(one.source)));
  }

  bool has(const std::string& path) const {
    const std::string wanted = context_.files.identity(path);
    return std::any_of(found_.files.begin(), found_.files.end(), [&](const Companion& one) {
      return context_.files.identity(context_.sources.path(one.source)) == wanted;
    });
  }

  void look_at(const std::string& path, bool is_tied = false) {
    const bool is_srdf = is_companion_path(path);
    const FileContent content =
        context_.files.read(path, is_srdf ? context_.limits.srdf_bytes : kMostBytesOfYaml);
    if (content.status != ReadStatus::ok) return;
    const CompanionSpec* spec = find_companion_kind(path, content.text);
    if (spec == nullptr) return;
    const bool is_xacro = xacro::is_xacro_file(path);
    const std::string_view name = is_srdf ? robot_name_in(content.text) : std::string_view();
    // A xacro file without a name is a part of others, and an expression may be any name.
    if (is_xacro && name.empty()) return;
    const bool is_computed = is_xacro && name.find('$') != std::string_view::npos;
    if (is_srdf && !is_computed && !is_tied && !may_be_for(name)) return;
    if (auto companion = loader_.read(path, *spec, is_xacro ? &model_ : nullptr)) {
      found_.files.push_back(std::move(*companion));
    }
  }

  /// Whether an SRDF with this robot name may be one of the robot. Other names are mistakes if the
  /// robot is the only one around.
  bool may_be_for(std::string_view name) {
    if (model_.robot->name && is_same_word(name, *model_.robot->name)) return true;
    const auto is_urdf = [](const std::string& path) { return has_ending(path, ".urdf"); };
    const std::vector<std::string>& all = robots();
    return std::count_if(all.begin(), all.end(), is_urdf) == 1 && !has_robot(all, name, context_);
  }

  const std::vector<std::string>& robots() {
    if (!robots_) {
      robots_ =
          candidates(places_.folders, {&NamesInFolder::urdfs, &NamesInFolder::xacros}, context_);
    }
    return *robots_;
  }

  bool is_only_robot() { return robots().size() <= 1; }

  /// Whether another robot of the same name, such as a variant with a gripper, has more of the
  /// names in an SRDF.
  bool has_better_robot(const Companion& companion) {
    if (companion.known_names == companion.names) return false;
    std::set<std::string> names;
    for (const Reference& one : names_in_companion(model_, companion)) {
      names.insert("\"" + std::string(one.name) + "\"");
    }
    const auto score = [&](std::string_view text) {
      return std::count_if(names.begin(), names.end(), [&](const std::string& name) {
        return text.find(name) != std::string_view::npos;
      });
    };
    const auto own = score(context_.sources.text(model_.robot->document.source));
    return std::any_of(robots().begin(), robots().end(), [&](const std::string& path) {
      const FileContent content = context_.files.read(path, context_.limits.file_bytes);
      const bool is_same = robot_name_in(content.text) == model_.robot->name.value_or("");
      return content.status == ReadStatus::ok && is_same && score(content.text) > own;
    });
  }

  const LinkedModel& model_;
  LoadContext& context_;
  Loader loader_;
  Companions found_;
  CompanionPlaces places_;
  std::optional<std::vector<std::string>> robots_;  ///< around it, also in xacro
  std::set<std::string> own_;   ///< files of the model and of others, by identity
  std::set<std::string> tied_;  ///< files that the configuration names, by identity
};

/// The robots around an SRDF with its robot name, URDFs before xacro files; else the only URDF.
std::vector<std::string> robots_of(const Companion& companion, LoadContext& context) {
  const srdf::Text& name = companion.srdf->name;
  const std::string folder(path::parent(context.sources.path(companion.source)));
  const std::vector<std::string> folders = companion_places(folder, context.files).folders;
  const std::vector<std::string> urdfs = candidates(folders, {&NamesInFolder::urdfs}, context);
  std::vector<std::string> found;
  for (const auto& all : {urdfs, candidates(folders, {&NamesInFolder::xacros}, context)}) {
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
  loaded.companions.is_alone = true;
  auto companion = Loader(context).read(path, spec_of(CompanionKind::srdf));
  if (!companion) {
    loaded.model.is_complete = false;
    return loaded;
  }
  std::vector<std::string> robots = tied_robots_of(path, context);
  const bool is_tied = !robots.empty();
  if (!is_tied) robots = robots_of(*companion, context);
  std::size_t best = 0;  // names of the best robot
  for (const std::string& robot : robots) {
    LinkedModel found = load_model(robot, context);
    count_names(found, *companion);
    if (!found.robot || (!is_tied && !belongs_to(found, *companion))) continue;
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
  return has_ending(path, ".srdf") || has_ending(path, ".srdf.xacro");
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
