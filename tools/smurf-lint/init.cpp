// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/init.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "base/text/words.hpp"
#include "common/files/input.hpp"
#include "common/files/output.hpp"
#include "link/package_manifest.hpp"
#include "plan/xacro_files.hpp"
#include "render/printable.hpp"
#include "smurf-lint/init_trial.hpp"
#include "smurf-lint/launch_hints.hpp"
#include "smurf/check.hpp"
#include "smurf/companions.hpp"
#include "smurf/config.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/found_inputs.hpp"
#include "smurf/readers.hpp"
#include "smurf/yaml.hpp"

namespace smurf::tools {
namespace {

/// A text in a robot that only one reader, or one family of programs, understands.
struct Sign {
  std::string_view text;
  std::string_view target;
};
constexpr Sign kSigns[] = {
    {"package://", "ros"},    {"<ros2_control", "ros"}, {"<ros2_control", "ros2_control"},
    {"<transmission", "ros"}, {"<gazebo", "gazebo"},    {"<mujoco", "mujoco"},
    {"<drake:", "drake"}};

/// A word of a Python program, a list of requirements or a launch file that names a target.
constexpr Sign kUses[] = {{"pybullet", "pybullet"},   {"mujoco", "mujoco"},
                          {"pinocchio", "pinocchio"}, {"pydrake", "drake"},
                          {"dartpy", "dart"},         {"isaacgym", "isaac"},
                          {"isaacsim", "isaac"},      {"isaaclab", "isaac"},
                          {"omni.isaac", "isaac"},    {"newton", "newton"}};
/// What launch files start for a robot in Gazebo.
constexpr std::string_view kGazebo[] = {"ros_gz_sim", "gazebo_ros", "gz_sim", "ros_ign_gazebo",
                                        "gazebo.launch"};

/// What launch files of ROS 2 start, which the robot itself need not name.
constexpr Sign kStarted[] = {{"robot_state_publisher", "ros"},
                             {"ros2_control_node", "ros2_control"},
                             {"MoveItConfigsBuilder", "moveit"},
                             {"moveit_ros_move_group", "moveit"}};

/// What is in the folder.
struct Seen {
  std::map<std::string_view, std::size_t> kinds;  ///< "URDF": 3
  std::vector<std::string> xacro;                 ///< all of them
  std::size_t robots_in_xacro = 0;
  std::vector<LaunchedRobot> launched;
  std::set<std::string_view> targets;
  std::set<std::string> packages;              ///< in addresses
  std::map<std::string, std::string> folders;  ///< of packages, by name, below the folder
  std::set<std::string> copied;                ///< packages that are in several folders
  bool has_package = false;                    ///< of ROS
  bool has_launch = false, launches_gazebo = false;
};

/// NAME of each package://NAME/ in a text.
void add_packages(std::string_view text, std::set<std::string>& packages) {
  constexpr std::string_view kScheme = "package://";
  for (std::size_t at = text.find(kScheme); at != std::string_view::npos;
       at = text.find(kScheme, at)) {
    at += kScheme.size();
    const std::string_view rest = text.substr(at, 256);
    const std::size_t end = rest.find_first_of("/\"'<> \n${");
    if (end == std::string_view::npos || end == 0 || rest[end] != '/') continue;
    packages.emplace(rest.substr(0, end));
  }
}

/// Whether a program imports a module, or a list of requirements has it.
bool uses(std::string_view text, std::string_view module, bool is_python) {
  const auto is_inner = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (is_python && !line.starts_with("import ") && !line.starts_with("from ")) continue;
    if (line.starts_with('#')) continue;
    const std::size_t at = line.find(module);
    if (at == std::string_view::npos || (at > 0 && is_inner(line[at - 1]))) continue;
    const std::size_t after = at + module.size();
    if (after >= line.size() || !is_inner(line[after])) return true;
  }
  return false;
}

/// What a file of the project tells about its programs.
void read_program(const std::string& path, const std::string& name, Seen& seen) {
  constexpr std::uint64_t kMostBytes = 1U << 18U;
  const std::string_view extension = path::extension(name);
  const bool is_python = extension == ".py";
  const bool is_list = name.starts_with("requirements") || name == "pyproject.toml" ||
                       name == "environment.yml" || name == "setup.cfg";
  const bool is_launch = name.find(".launch") != std::string::npos;
  const bool may_be_mjcf = extension == ".xml" && !is_launch;
  if (!is_python && !is_list && !is_launch && !may_be_mjcf) return;
  const std::string text = DiskFiles().read(path, kMostBytes).text;
  if (may_be_mjcf) {
    const std::size_t root = text.find("<mujoco");
    if (root != std::string::npos && root < text.find("<body")) seen.targets.insert("mujoco");
    return;
  }
  seen.has_launch = seen.has_launch || is_launch;
  for (const std::string_view word : kGazebo) {
    seen.launches_gazebo =
        seen.launches_gazebo || (is_launch && text.find(word) != std::string::npos);
  }
  for (const Sign& sign : kStarted) {
    if (is_launch && text.find(sign.text) != std::string::npos) seen.targets.insert(sign.target);
  }
  for (const Sign& sign : kUses) {
    if ((is_python || is_list) && uses(text, sign.text, is_python)) {
      seen.targets.insert(sign.target);
    }
  }
}

/// The packages of the robots below the folder, without hidden ones: by the name in package.xml,
/// else by that of the folder, the first of each. Reads the programs of the project, too.
void find_folders(const std::string& folder, const std::string& shown, std::size_t depth,
                  std::map<std::string, std::string>& by_name, Seen& seen) {
  constexpr std::size_t kDeepest = 12;
  if (depth > kDeepest) return;
  std::vector<std::string> below, files;
  places::for_each_entry(folder, [&](const std::string& name, places::Entry kind) {
    if (name.starts_with('.')) return true;
    if (kind == places::Entry::folder) below.push_back(name);
    if (kind == places::Entry::file) files.push_back(name);
    return true;
  });
  std::sort(below.begin(), below.end());
  for (const std::string& name : files) read_program(path::join(folder, name), name, seen);
  const PackageManifest manifest = manifest_in(folder, DiskFiles());
  seen.has_package = seen.has_package || manifest.exists;
  if (seen.packages.contains(manifest.name)) {
    const auto [known, is_new] =
        seen.folders.try_emplace(manifest.name, shown.empty() ? "." : shown);
    if (!is_new) seen.copied.insert(manifest.name);
  }
  for (const std::string& name : below) {
    const std::string path = path::join(folder, name);
    const std::string known = shown.empty() ? name : shown + "/" + name;
    if (seen.packages.contains(name)) by_name.try_emplace(name, known);
    find_folders(path, known, depth + 1, by_name, seen);
  }
}

Seen look_at(const std::string& folder, const FoundInputs& found, const Limits& limits) {
  Seen seen;
  const DiskFiles disk;
  seen.xacro = found.xacro;
  const std::vector<std::string> robots = XacroFiles(found.xacro, disk, limits).roots();
  seen.robots_in_xacro = robots.size();
  seen.launched = launched_robots(folder, robots, limits);
  std::vector<std::string> texts = found.files;
  texts.insert(texts.end(), found.xacro.begin(), found.xacro.end());
  for (const std::string& file : texts) {
    const InputKind kind = input_kind(file);
    const bool is_xacro = path::extension(file) == ".xacro";
    if (is_companion_path(file)) seen.targets.insert("moveit");
    if (kind == InputKind::urdf && !is_xacro) ++seen.kinds["URDF"];
    if (kind == InputKind::model) ++seen.kinds["SMURF model"];
    if (kind == InputKind::scene || kind == InputKind::drawing) ++seen.kinds["scene"];
    if (kind == InputKind::model || kind == InputKind::scene) seen.targets.insert("mars");
    const std::string text = disk.read(file, limits.file_bytes).text;
    for (const Sign& sign : kSigns) {
      if (text.find(sign.text) != std::string::npos) seen.targets.insert(sign.target);
    }
    add_packages(text, seen.packages);
  }
  std::map<std::string, std::string> by_name;
  find_folders(folder, "", 0, by_name, seen);
  seen.folders.merge(by_name);
  // Addresses of packages are used by other programs as well.
  const bool is_of_others = seen.targets.contains("pybullet") || seen.targets.contains("mujoco") ||
                            seen.targets.contains("isaac");
  if (is_of_others && !seen.has_package) seen.targets.erase("ros");
  if (seen.has_launch && !seen.launches_gazebo) seen.targets.erase("gazebo");
  return seen;
}

/// A text in YAML that means these bytes, whatever is in them.
std::string in_yaml(std::string_view text, bool is_always_quoted = false) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  const bool is_plain = !text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos &&
                        yaml::classify(text, yaml::Style::plain) == yaml::ScalarType::text &&
                        text.front() != '-';
  if (is_plain && !is_always_quoted) return std::string(text);
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      quoted.append("\\x").append(1, kDigits[byte >> 4U]).append(1, kDigits[byte & 15U]);
    } else {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
  }
  return quoted + "\"";
}

/// The setting `xacro`. Paths are relative to the folder.
std::string robots_of(const std::string& folder, const Seen& seen) {
  if (seen.launched.empty()) return {};
  std::string text = "# Arguments that launch files give; each combination is checked.\nxacro:\n";
  for (const LaunchedRobot& robot : seen.launched) {
    const std::string path = places::relative(identity(robot.file), identity(folder));
    text += "- file: " + in_yaml(path.empty() ? robot.file : path) + "\n  arguments:\n";
    for (const auto& [name, values] : robot.arguments) {
      std::string list;
      for (const std::string& value : values) {
        list += (list.empty() ? "" : ", ") + in_yaml(value, true);
      }
      text += "    " + in_yaml(name) + ": " + (values.size() == 1 ? list : "[" + list + "]") + "\n";
    }
  }
  return text;
}

/// A pattern of `paths` that matches this file only; "" if its name has signs of patterns.
std::string pattern_of(const std::string& path) {
  return path.find_first_of("*?[]!\\#") == std::string::npos ? "/" + path : "";
}

/// The setting `paths`: what the targets would make errors.
std::string kept_of(const InitTargets& targets) {
  std::map<std::string, std::string> files;
  for (const RaisedFinding& one : targets.raised) {
    const std::string pattern = pattern_of(one.path);
    if (pattern.empty()) continue;
    std::string& rules = files[pattern];
    rules += (rules.empty() ? "" : ", ") + one.rule + ": " + one.severity;
  }
  if (files.empty()) return {};
  std::string text =
      "# Errors for the targets that were here when this file was made. Fix them, and delete their "
      "lines.\npaths:\n";
  for (const auto& [pattern, rules] : files) {
    text += "  " + in_yaml(pattern, true) + ": {severity: {" + rules + "}}\n";
  }
  return text;
}

std::string configuration(const std::string& folder, const Seen& seen, const InitTargets& targets) {
  std::string text =
      "# Settings of smurf-lint for this folder and everything below it. `smurf-lint --show-config .`\n"
      "# shows what applies, docs/tools/smurf-lint.md of smurf-tools describes all settings.\n";
  text += targets.names.empty() ? "# The programs that load the robots: targets: [ros, gazebo]\n"
                                : "targets: [" + listed(targets.names) + "]\n";
  std::string lost;
  std::string known;
  for (const std::string& name : seen.packages) {
    const auto place = seen.folders.find(name);
    if (place == seen.folders.end()) {
      lost += "#  " + in_yaml(name) + ": " + in_yaml("../" + name) + "\n";
    } else if (!seen.copied.contains(name)) {  // else each robot finds the nearest one
      known += "  " + in_yaml(name) + ": " + in_yaml(place->second) + "\n";
    }
  }
  if (!known.empty()) text += "packages:\n" + known;
  if (!lost.empty()) text += "# In no folder here; name it, and delete the #:\n#packages:\n" + lost;
  return text + robots_of(folder, seen) + kept_of(targets);
}

std::string hooks(const Seen& seen) {
  std::string text = "repos:\n- repo: https://github.com/smurf-tools/smurf\n  rev: v" +
                     std::string(kVersion) + "\n  hooks:\n  - id: smurf-lint\n";
  if (seen.kinds.contains("SMURF model")) text += "  - id: smurf2urdf-check\n";
  if (seen.kinds.contains("scene")) text += "  - id: smurf-flatten-check\n";
  return text;
}

std::string workflow() {
  return "name: smurf-lint\non: [push, pull_request]\npermissions:\n  contents: read\njobs:\n"
         "  smurf-lint:\n    runs-on: ubuntu-24.04\n    steps:\n    - uses: actions/checkout@11bd71901bbe5b1630ceea73d27597364c9af683  # v4.2.2\n"
         "    - uses: smurf-tools/smurf@v" +
         std::string(kVersion) + "\n      with:\n        paths: .\n";
}

struct Offer {
  std::string path;
  std::string text;
  std::string what;
};

std::vector<Offer> offers_for(const std::string& folder, const Seen& seen,
                              const InitTargets& targets) {
  std::vector<Offer> offers;
  std::string about = targets.names.empty() ? "no target" : "targets " + listed(targets.names);
  if (!seen.launched.empty())
    about += ", " + counted(seen.launched.size(), "robot with arguments", "robots with arguments");
  if (!seen.folders.empty()) about += ", " + counted(seen.folders.size(), "package");
  offers.push_back({std::string(kConfigName), configuration(folder, seen, targets), about});
  if (!places::exists(path::join(folder, ".git"))) return offers;
  offers.push_back({".pre-commit-config.yaml", hooks(seen), "checks before each commit"});
  if (!places::exists(path::join(folder, ".gitlab-ci.yml"))) {
    offers.push_back({".github/workflows/smurf-lint.yml", workflow(), "checks each push"});
  }
  return offers;
}

std::string about(const Seen& seen) {
  std::string text;
  for (const auto& [kind, count] : seen.kinds) {
    text += (text.empty() ? "" : ", ") + counted(count, kind);
  }
  if (!seen.xacro.empty()) {
    text += (text.empty() ? "" : ", ") + counted(seen.xacro.size(), "xacro file") + " with " +
            counted(seen.robots_in_xacro, "robot");
  }
  return "found " + text + "\n";
}

std::string about_lost(const Seen& seen) {
  std::string text;
  for (const std::string& name : seen.packages) {
    if (seen.folders.contains(name)) continue;
    text += "the folder of the package " + name + " is not here: write it below `packages` in " +
            std::string(kConfigName) + "\n";
  }
  return text;
}

std::string about_raised(const InitTargets& targets) {
  if (targets.raised.empty()) return {};
  return counted(targets.raised.size(), "error") + " for the targets " +
         (targets.raised.size() == 1 ? "keeps its" : "keep their") + " severity by `paths` in " +
         std::string(kConfigName) + ": delete the lines when you have fixed them\n";
}

/// What the user has to add to a file that was there.
std::string about_kept(const Offer& offer) {
  std::string text = "left " + offer.path + " as it is";
  if (!offer.path.starts_with(".pre-commit")) return text + "\n";
  // Without "repos:": the entry for the list that the file has.
  return text + "; add this to its `repos`:\n" + offer.text.substr(offer.text.find('\n') + 1);
}

}  // namespace

/// Whether smurf-lint reads the configuration as it was meant: names of a stranger's robot must not
/// become settings.
bool is_as_meant(const std::string& folder, const std::string& text, const InitTargets& targets) {
  const std::string path = path::normalize(path::join(folder, kConfigName));
  const DiskFiles disk;
  MemoryFiles files(&disk);
  files.add(path, text);
  SourceMap sources;
  DiagnosticSink found;
  const Config config = read_config(path, sources, files, found);
  return !found.has_errors() && config.ignore.empty() && !config.fail_on &&
         config.exclude.empty() && config.severities.empty() &&
         config.paths.size() <= targets.raised.size();
}

ExitCode init(const LintOptions& options) {
  const std::string folder = options.paths.empty() ? "." : options.paths.front();
  if (!places::is_folder(folder)) {
    complain(kSmurfLint, "'" + folder + "' is not a folder; --init sets up a folder");
    return kFailed;
  }
  const FoundInputs found = find_inputs(folder, options.limits);
  if (found.files.empty() && found.xacro.empty()) {
    complain(kSmurfLint, why_nothing(found, folder) + "; nothing was written");
    return kFailed;
  }
  const Seen seen = look_at(folder, found, options.limits);
  InitTargets targets;
  if (!places::has_entry(path::join(folder, kConfigName))) {
    targets = try_targets(
        folder, {seen.targets.begin(), seen.targets.end()},
        [&](const InitTargets& tried) { return configuration(folder, seen, tried); }, options);
  }
  const std::vector<Offer> offers = offers_for(folder, seen, targets);
  if (!is_as_meant(folder, offers.front().text, targets)) {
    complain(kSmurfLint, "names of packages, files or arguments here cannot be written to " +
                             std::string(kConfigName) + "; nothing was written");
    return kFailed;
  }
  std::vector<OutputFile> files;
  std::string told = about(seen);
  std::string kept;
  for (const Offer& offer : offers) {
    if (places::has_entry(path::join(folder, offer.path))) {
      kept += about_kept(offer);
      continue;
    }
    files.push_back({folder, offer.path, offer.text});
    told += "wrote " + offer.path + ": " + offer.what + "\n";
  }
  if (!files.empty() && !write_files(kSmurfLint, files, false)) return kFailed;
  if (offers.size() == 1) told += "no git repository: no hook and no workflow\n";
  told +=
      kept + about_raised(targets) + about_lost(seen) +
      "next: smurf-lint checks the folder; smurf-lint --generate-baseline records what it finds "
      "today, to report only new findings\n";
  return write_output(kSmurfLint, options.output, render::escape_lines(told)) ? kDone : kFailed;
}

}  // namespace smurf::tools
