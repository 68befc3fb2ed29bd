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
#include "common/files/input.hpp"
#include "common/files/output.hpp"
#include "render/printable.hpp"
#include "smurf-lint/launch_hints.hpp"
#include "smurf/check.hpp"
#include "smurf/companions.hpp"
#include "smurf/config.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/found_inputs.hpp"
#include "smurf/readers.hpp"
#include "smurf/xacro_files.hpp"

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

/// What is in the folder.
struct Seen {
  std::map<std::string_view, std::size_t> kinds;  ///< "URDF": 3
  std::vector<std::string> xacro;                 ///< all of them
  std::size_t robots_in_xacro = 0;
  std::vector<LaunchedRobot> launched;
  std::set<std::string_view> targets;
  std::set<std::string> packages;              ///< in addresses
  std::map<std::string, std::string> folders;  ///< of packages, by name, below the folder
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

/// The folders called like a package of the robots, the first by name, without hidden ones.
void find_folders(const std::string& folder, const std::string& shown, std::size_t depth,
                  Seen& seen) {
  constexpr std::size_t kDeepest = 12;
  if (depth > kDeepest) return;
  std::vector<std::string> below;
  places::for_each_entry(folder, [&](const std::string& name, places::Entry kind) {
    if (kind == places::Entry::folder && !name.starts_with('.')) below.push_back(name);
    return true;
  });
  std::sort(below.begin(), below.end());
  for (const std::string& name : below) {
    const std::string path = path::join(folder, name);
    const std::string known = shown.empty() ? name : shown + "/" + name;
    if (seen.packages.contains(name)) seen.folders.try_emplace(name, known);
    find_folders(path, known, depth + 1, seen);
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
  if (!seen.packages.empty()) find_folders(folder, "", 0, seen);
  return seen;
}

std::string listed(const std::set<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) text.append(text.empty() ? "" : ", ").append(word);
  return text;
}

/// The setting `xacro`. Paths are relative to the folder.
std::string robots_of(const std::string& folder, const Seen& seen) {
  if (seen.launched.empty()) return {};
  std::string text = "# Arguments that launch files give; each combination is checked.\nxacro:\n";
  for (const LaunchedRobot& robot : seen.launched) {
    const std::string path = places::relative(identity(robot.file), identity(folder));
    text += "- file: " + (path.empty() ? robot.file : path) + "\n  arguments:\n";
    for (const auto& [name, values] : robot.arguments) {
      std::string list;
      for (const std::string& value : values) list += (list.empty() ? "\"" : ", \"") + value + "\"";
      text += "    " + name + ": " + (values.size() == 1 ? list : "[" + list + "]") + "\n";
    }
  }
  return text;
}

std::string configuration(const std::string& folder, const Seen& seen) {
  std::string text =
      "# Settings of smurf-lint for this folder and everything below it. `smurf-lint --show-config .`\n"
      "# shows what applies, docs/tools/smurf-lint.md of smurf-tools describes all settings.\n";
  text += seen.targets.empty() ? "# The programs that load the robots: targets: [ros, gazebo]\n"
                               : "targets: [" + listed(seen.targets) + "]\n";
  std::string lost;
  std::string known;
  for (const std::string& name : seen.packages) {
    const auto place = seen.folders.find(name);
    if (place == seen.folders.end()) {
      lost += "#  " + name + ": ../" + name + "\n";
    } else {
      known += "  " + name + ": " + place->second + "\n";
    }
  }
  if (!known.empty()) text += "packages:\n" + known;
  if (!lost.empty()) text += "# In no folder here; name it, and delete the #:\n#packages:\n" + lost;
  return text + robots_of(folder, seen);
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
         "  smurf-lint:\n    runs-on: ubuntu-24.04\n    steps:\n    - uses: actions/checkout@v4\n"
         "    - uses: smurf-tools/smurf@v" +
         std::string(kVersion) + "\n      with:\n        paths: .\n";
}

struct Offer {
  std::string path;
  std::string text;
  std::string what;
};

std::vector<Offer> offers_for(const std::string& folder, const Seen& seen) {
  std::vector<Offer> offers;
  std::string about = seen.targets.empty() ? "no target" : "targets " + listed(seen.targets);
  if (!seen.launched.empty())
    about += ", " + counted(seen.launched.size(), "robot with arguments", "robots with arguments");
  if (!seen.folders.empty()) about += ", " + counted(seen.folders.size(), "package");
  offers.push_back({std::string(kConfigName), configuration(folder, seen), about});
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

/// What the user has to add to a file that was there.
std::string about_kept(const Offer& offer) {
  std::string text = "left " + offer.path + " as it is";
  if (!offer.path.starts_with(".pre-commit")) return text + "\n";
  // Without "repos:": the entry for the list that the file has.
  return text + "; add this to its `repos`:\n" + offer.text.substr(offer.text.find('\n') + 1);
}

}  // namespace

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
  const std::vector<Offer> offers = offers_for(folder, seen);
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
      kept + about_lost(seen) +
      "next: smurf-lint checks the folder; smurf-lint --generate-baseline records what it finds "
      "today, to report only new findings\n";
  return write_output(kSmurfLint, options.output, render::escape_lines(told)) ? kDone : kFailed;
}

}  // namespace smurf::tools
