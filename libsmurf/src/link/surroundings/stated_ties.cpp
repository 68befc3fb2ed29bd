// SPDX-License-Identifier: BSD-3-Clause
#include "link/surroundings/stated_ties.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "link/companions/library.hpp"
#include "link/companions/setup_assistant.hpp"
#include "link/package_search.hpp"
#include "link/surroundings/launch_files.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostStatedLaunches = 100;  // of a package

bool is_robot(std::string_view path) {
  return is_one_of(path::to_lower(path::extension(path)), {".urdf", ".xacro"}) &&
         !is_companion_path(path);
}

/// Without the quotes for the shell that runs xacro: `default_value='""'` is an empty text.
std::string_view without_quotes(std::string_view value) {
  const bool is_quoted = value.size() > 1 && value.front() == value.back() &&
                         (value.front() == '"' || value.front() == '\'');
  return is_quoted ? value.substr(1, value.size() - 2) : value;
}

/// What a launch file names itself.
struct Launch {
  std::set<std::string> robots;       ///< by identity
  std::vector<std::string> files;     ///< that are no robots
  std::vector<std::string> included;  ///< launch files
  std::vector<StatedTie::Argument> arguments;
};

class TieReader {
 public:
  TieReader(const NearPackage& package, LoadContext& context)
      : package_(package), context_(context) {}

  std::vector<StatedTie> run() {
    read_setup();
    for (const FoundLaunch& one : launch_files_of(
             package_.folder, {"", "launch", "test", "tests", "test/launch"}, context_.files)) {
      if (found_.size() >= kMostStatedLaunches) break;
      StatedTie tie;
      tie.evidence = Evidence::launch;
      tie.by = path::normalize(one.path);
      std::set<std::string> robots, seen;
      gather(tie.by, 0, tie, robots, seen);
      // With several robots nobody knows which of them has what an included file names.
      const Launch& own = launch_of(tie.by);
      if (robots.size() > 1) {
        robots = own.robots;
        tie.files = own.files;
      }
      if (robots.empty()) continue;
      tie.robots.assign(robots.begin(), robots.end());
      found_.push_back(std::move(tie));
    }
    return std::move(found_);
  }

 private:
  void gather(const std::string& path, int depth, StatedTie& tie, std::set<std::string>& robots,
              std::set<std::string>& seen) {
    constexpr int kDeepest = 3;
    constexpr std::size_t kMostFiles = 50;  // a file that brings up a whole robot includes some ten
    if (depth > kDeepest || seen.size() == kMostFiles || !seen.insert(path).second) return;
    const Launch& launch = launch_of(path);
    robots.insert(launch.robots.begin(), launch.robots.end());
    tie.files.insert(tie.files.end(), launch.files.begin(), launch.files.end());
    tie.arguments.insert(tie.arguments.end(), launch.arguments.begin(), launch.arguments.end());
    for (const std::string& one : launch.included) gather(one, depth + 1, tie, robots, seen);
  }

  const Launch& launch_of(const std::string& path) {
    const auto [known, is_new] = launches_.try_emplace(path);
    if (is_new) known->second = read(path);
    return known->second;
  }

  Launch read(const std::string& path) {
    Launch launch;
    const auto form = launch_form_of(path::file_name(path));
    const FileContent content = context_.files.read(path, kMostBytesOfLaunch);
    if (!form || content.status != ReadStatus::ok) return launch;
    const FindLaunchPath find = [&](LaunchPath& one) { look_up(one, path); };
    const LaunchFile file = search_of(context_).companions->launches.read(
        path::normalize(path), content.text, *form, false, {}, context_.limits, find);
    const auto add = [&](const LaunchPath& one) {
      if (!one.exists) return;
      if (is_robot(one.path)) {
        launch.robots.insert(context_.files.identity(one.path));
      } else if (launch_form_of(path::file_name(one.path))) {
        launch.included.push_back(one.path);
      } else {
        launch.files.push_back(one.path);
      }
    };
    for (const LaunchPath& one : file.paths) add(one);
    const auto read_description = [&](const LaunchDescription& one) {
      if (!one.file || !one.file->exists) return;
      add(*one.file);
      const std::string robot = context_.files.identity(one.file->path);
      for (const LaunchDescription::Argument& argument : one.arguments) {
        const LaunchText& value = argument.value;
        if (!value.is_known || !value.package.empty()) continue;
        launch.arguments.push_back({robot, argument.name, std::string(without_quotes(value.text))});
      }
    };
    for (const LaunchDescription& one : file.descriptions) read_description(one);
    return launch;
  }

  void look_up(LaunchPath& one, const std::string& launch) {
    std::string_view rest = one.text.text;
    while (rest.starts_with('/')) rest.remove_prefix(1);
    if (!one.text.is_known || one.text.package.empty() || rest.empty()) return;
    const auto folder = one.text.package == package_.name
                            ? package_.folder
                            : find_package(one.text.package, launch, context_);
    if (!folder) return;
    one.path = path::normalize(path::join(*folder, rest));
    one.exists = context_.files.is_file(one.path);
  }

  void read_setup() {
    const std::string path = path::join(package_.folder, ".setup_assistant");
    constexpr std::uint64_t kMostBytesOfSetup = 1U << 16U;
    const FileContent content = context_.files.read(path, kMostBytesOfSetup);
    if (content.status != ReadStatus::ok) return;
    SourceMap sources;
    DiagnosticSink ignored(context_.limits);
    const SourceId source = sources.add(path, content.text);
    const auto document = parse_yaml(sources, source, context_.limits, ignored);
    if (!document) return;
    const auto urdf = setup_file(*document, "URDF", path, context_);
    if (!urdf || !context_.files.is_file(urdf->path)) return;
    StatedTie tie;
    tie.evidence = Evidence::setup_assistant;
    tie.by = path::normalize(path);
    tie.robots.push_back(context_.files.identity(urdf->path));
    const auto srdf = setup_file(*document, "SRDF", path, context_);
    if (srdf) tie.files.push_back(srdf->path);
    const std::string config = path::join(package_.folder, "config");
    for (const std::string& name : context_.files.list(config)) {
      tie.files.push_back(path::join(config, name));
    }
    std::string_view words = urdf->xacro_args;
    for (std::size_t at = 0; at < words.size();) {
      const std::string_view word = next_word(words, at);
      const std::size_t sign = word.find(":=");
      if (word.empty()) break;
      if (sign == std::string_view::npos) continue;
      tie.arguments.push_back({tie.robots.front(), std::string(word.substr(0, sign)),
                               std::string(word.substr(sign + 2))});
    }
    found_.push_back(std::move(tie));
  }

  const NearPackage& package_;
  LoadContext& context_;
  std::vector<StatedTie> found_;
  std::map<std::string, Launch> launches_;  ///< by path
};

}  // namespace

const std::vector<StatedTie>& StatedTies::in_package(const NearPackage& package,
                                                     LoadContext& context) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = packages_.find(package.folder);
    if (known != packages_.end()) return *known->second;
  }
  auto ties = std::make_unique<const std::vector<StatedTie>>(TieReader(package, context).run());
  const std::lock_guard lock(mutex_);
  return *packages_.emplace(package.folder, std::move(ties)).first->second;
}

GivenFiles::GivenFiles(const LinkedModel& robot, const std::vector<NearPackage>& packages,
                       LoadContext& context) {
  const std::string id = context.files.identity(robot.urdf_path);
  const std::string main = context.files.identity(robot.path);
  for (const CompanionTie& tie : context.ties) {
    const std::string other = context.files.identity(tie.robot);
    auto& files = other == id || other == main ? configured_.own : configured_.others;
    for (const std::string& one : tie.files) files.insert(path::normalize(one));
  }
  for (const NearPackage& package : packages) {
    for (const StatedTie& tie :
         search_of(context).companions->stated->in_package(package, context)) {
      const bool is_own = std::find(tie.robots.begin(), tie.robots.end(), id) != tie.robots.end();
      auto& files = is_own ? stated_.own : stated_.others;
      files.insert(path::normalize(tie.by));
      for (const std::string& one : tie.files) files.insert(path::normalize(one));
    }
  }
}

Whose GivenFiles::whose(const std::string& path) const {
  for (const Files* one : {&configured_, &stated_}) {
    if (one->own.contains(path)) return Whose::own;
    if (one->others.contains(path)) return Whose::others;
  }
  return Whose::any;
}

std::vector<xacro::SeenArgument> stated_arguments(const std::string& robot, LoadContext& context) {
  std::vector<xacro::SeenArgument> found;
  const std::string id = context.files.identity(robot);
  PackageSearch& search = search_of(context);
  const CompanionPlaces places =
      companion_places(std::string(path::parent(robot)), context.files, search);
  for (const NearPackage& package : places.packages) {
    for (const StatedTie& tie : search.companions->stated->in_package(package, context)) {
      for (const StatedTie::Argument& one : tie.arguments) {
        const bool is_known = std::any_of(found.begin(), found.end(), [&](const auto& other) {
          return other.name == one.name && other.file == tie.by;
        });
        if (one.robot == id && !is_known) found.push_back({one.name, one.value, tie.by});
      }
    }
  }
  return found;
}

}  // namespace smurf
