// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/left_names.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <string_view>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "common/files/input.hpp"
#include "plan/xacro_files.hpp"
#include "smurf/companions.hpp"
#include "smurf/confine.hpp"

namespace smurf::tools {
namespace {

constexpr std::size_t kMostEntries = 20'000;
constexpr std::uint64_t kMostBytes = 1U << 20U;  // of a file that is searched
constexpr std::size_t kMostPlaces = 20;
constexpr int kDeepest = 8;
constexpr std::string_view kBlanksAround = " \t\r\n";

/// `launch`: a launch file, or another file that no rename changes: Python, RViz, worlds.
/// `settings`: a YAML file of another program, such as the frames of MoveIt Servo or of Nav2.
enum class Kind : std::uint8_t { other, launch, robot, companion, settings };

bool ends_with_one_of(std::string_view name, std::initializer_list<std::string_view> ends) {
  return std::any_of(ends.begin(), ends.end(),
                     [&](std::string_view end) { return name.ends_with(end); });
}

Kind kind_of(std::string_view name) {
  if (ends_with_one_of(name, {".launch", ".launch.xml", ".launch.yaml", ".py", ".rviz", ".lua",
                              ".sdf", ".world"})) {
    return Kind::launch;
  }
  if (ends_with_one_of(name, {".srdf", ".srdf.xacro", ".yaml", ".yml"})) return Kind::companion;
  return ends_with_one_of(name, {".xacro", ".urdf"}) ? Kind::robot : Kind::other;
}

bool is_part_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

/// A word of an attribute of XML such as `args="0 0 1 base laser"`.
bool is_word_of_list(std::string_view text, std::size_t begin, std::size_t end) {
  const char before = begin == 0 ? '\0' : text[begin - 1];
  const char after = end == text.size() ? '\0' : text[end];
  const bool is_apart = (before == ' ' || before == '"') && (after == ' ' || after == '"');
  const std::size_t open = begin == 0 ? text.npos : text.rfind('"', begin - 1);
  return is_apart && open != text.npos && text.substr(0, open).ends_with(" args=");
}

/// A text in quotes, or the value of an argument.
bool is_quoted(std::string_view text, std::size_t begin, std::size_t end) {
  const char before = begin == 0 ? '\0' : text[begin - 1];
  const char after = end == text.size() ? '\0' : text[end];
  const bool is_argument = text.substr(0, begin).ends_with(":=");
  const bool ends = after == '"' || after == '\'' || after == ' ' || after == ',';
  return (before == '"' || before == '\'') ? after == before : is_argument && ends;
}

/// "name:=" of an argument.
bool is_set(std::string_view text, std::size_t begin, std::size_t end) {
  const char before = begin == 0 ? '\n' : text[begin - 1];
  return text.substr(end).starts_with(":=") &&
         (before == ' ' || before == '\'' || before == '"' || before == '\n');
}

/// A word of YAML outside of comments.
bool is_word(std::string_view text, std::size_t begin, std::size_t end) {
  const bool is_inside = (begin > 0 && is_part_of_name(text[begin - 1])) ||
                         (end < text.size() && is_part_of_name(text[end]));
  const std::size_t line = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;
  return !is_inside && text.substr(line, begin - line).find('#') == std::string_view::npos;
}

/// The first line of a file that contains a name; 0: none.
std::size_t line_with(std::string_view path, std::string_view text, std::string_view name) {
  const bool is_yaml = ends_with_one_of(path, {".yaml", ".yml", ".rviz"});
  const bool is_launch = ends_with_one_of(path, {".launch", ".launch.xml"});
  for (std::size_t at = text.find(name); at != std::string_view::npos;
       at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool sets_argument = !path.ends_with(".xacro") && is_set(text, at, end);
    const bool is_named = (is_yaml ? is_word(text, at, end) : is_quoted(text, at, end)) ||
                          (is_launch && is_word_of_list(text, at, end));
    if (!is_named && !sets_argument) continue;
    // The key of a table that a xacro file reads, such as `positions['elbow']`.
    if (path.ends_with(".xacro") && at > 1 && text[at - 2] == '[') continue;
    return 1 + static_cast<std::size_t>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  }
  return 0;
}

/// Whether a file defines a link or joint of this name itself: it describes another robot.
bool defines(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find(name); at != std::string_view::npos;
       at = text.find(name, at + 1)) {
    const std::size_t open = text.rfind('<', at), close = text.find('>', at);
    if (!is_quoted(text, at, at + name.size()) || open == std::string_view::npos) continue;
    const std::string_view tag = text.substr(open, close - open);
    const std::string_view before = text.substr(open, at - 1 - open);
    if (!before.ends_with(" name=")) continue;
    // A joint of an element ros2_control has no type.
    const bool is_joint = tag.starts_with("<joint ") && tag.find(" type=") != tag.npos;
    if (is_joint || tag.starts_with("<link ")) return true;
  }
  return false;
}

/// The path as a user would write it: relative to the current folder, if it is in there.
std::string shown(const std::string& path) {
  const std::string inside = places::relative(identity(path), identity("."));
  return inside.empty() || inside.starts_with("../") ? path : inside;
}

/// The name of the element `robot` in a text; "" if it has none.
std::string robot_name_in(std::string_view text) {
  const std::size_t tag = text.find("<robot");
  if (tag == std::string_view::npos) return {};
  text = text.substr(tag, text.find('>', tag) - tag);
  for (std::size_t at = text.find("name"); at != std::string_view::npos;
       at = text.find("name", at + 1)) {
    const std::size_t open = text.find_first_not_of(" =\t\r\n", at + 4);
    if (open == std::string_view::npos || (text[open] != '"' && text[open] != '\'')) continue;
    const std::size_t close = text.find(text[open], open + 1);
    if (close == std::string_view::npos) return {};
    return std::string(text.substr(open + 1, close - open - 1));
  }
  return {};
}

/// The folder of the package around a file; "" if there is none.
std::string package_around(const std::string& path, const FileReader& files) {
  std::string folder(path::parent(path));
  for (int level = 0; level < kDeepest; ++level, folder = path::join(folder, "..")) {
    if (files.is_file(path::join(folder, "package.xml"))) return folder.empty() ? "." : folder;
  }
  return {};
}

/// The project around a package, spelled like it; the package if there is no project.
std::string project_of(const std::string& package) {
  const std::string project = project_around(path::join(package, "package.xml"));
  std::string folder = package;
  for (int level = 0; level < kDeepest; ++level) {
    if (identity(folder) == project) return folder;
    folder = path::normalize(path::join(folder, ".."));
  }
  return package;
}

class Search {
 public:
  Search(std::span<const Rename> renames, std::span<const std::string> changed,
         const std::set<std::string>& loaded, const FileReader& files, const Limits& limits,
         const IncludedBy& included_by, const std::map<std::string, std::string_view>& texts)
      : renames_(renames),
        changed_(changed),
        loaded_(loaded),
        files_(files),
        limits_(limits),
        included_by_(included_by),
        texts_(texts) {}

  LeftNames run() {
    std::set<std::string> projects;
    for (const std::string& path : changed_) {
      const std::string package = package_around(path, files_);
      if (package.empty()) continue;
      packages_.insert(identity(package));
      names_.insert(name_of(package));
      projects.insert(project_of(package));
    }
    names_.erase("");
    for (const std::string& project : projects) find_packages(project, 0);
    const bool matters = std::any_of(found_.begin(), found_.end(), [&](const Found& one) {
      const bool is_own = loaded_.contains(identity(one.path)) || is_changed(one.path);
      return one.kind == Kind::companion || one.kind == Kind::settings ||
             (one.kind == Kind::robot && !is_own);
    });
    if (matters) {
      find_users();
      find_robots();
    }
    for (const Found& one : found_) judge(one);
    for (const auto& [name, places] : mentions_)
      left_.mentions.push_back(sentence_of(name, places));
    return std::move(left_);
  }

 private:
  /// A file that contains an old name.
  struct Found {
    std::string path;
    Kind kind{};
    std::string name;
    std::size_t line = 0;
    bool is_defined = false;  ///< there as well
  };

  std::string manifest_of(const std::string& package) const {
    return files_.read(path::join(package, "package.xml"), kMostBytes).text;
  }

  std::string name_of(const std::string& package) const {
    const std::string manifest = manifest_of(package);
    const std::size_t begin = manifest.find("<name>"), end = manifest.find("</name>");
    if (begin == std::string::npos || end == std::string::npos || end < begin) return {};
    const std::string name = manifest.substr(begin + 6, end - begin - 6);
    const std::size_t first = name.find_first_not_of(kBlanksAround);
    if (first == std::string::npos) return {};
    return name.substr(first, name.find_last_not_of(kBlanksAround) - first + 1);
  }

  /// Whether a package is one of those with changed files, or depends on one.
  bool is_related(const std::string& package) const {
    if (packages_.contains(identity(package))) return true;
    const std::string manifest = manifest_of(package);
    return std::any_of(names_.begin(), names_.end(), [&](const std::string& name) {
      return manifest.find(">" + name + "<") != std::string::npos;
    });
  }

  void find_packages(const std::string& folder, int depth) {
    if (files_.is_file(path::join(folder, "package.xml"))) {
      if (is_related(folder)) look_in(folder, 0);
      return;
    }
    for_each_folder(folder, depth, [&](const std::string& one) { find_packages(one, depth + 1); });
  }

  template <class Visit>
  void for_each_folder(const std::string& folder, int depth, Visit visit) {
    if (depth >= kDeepest) return;
    for (const std::string& name : files_.list(folder)) {
      if (++entries_ > kMostEntries) return;
      if (name.find('.') == std::string::npos) visit(path::join(folder, name));
    }
  }

  void look_in(const std::string& folder, int depth) {
    for (const std::string& name : files_.list(folder)) {
      if (name.starts_with('.')) continue;
      const Kind kind = kind_of(name);
      if (kind != Kind::other) read(path::join(folder, name), kind);
    }
    for_each_folder(folder, depth, [&](const std::string& one) { look_in(one, depth + 1); });
  }

  void read(const std::string& path, Kind kind) {
    if (loaded_.contains(identity(path)) && kind != Kind::robot) return;
    FileContent content = files_.read(path, kMostBytes);
    if (content.status != ReadStatus::ok) return;
    if (const auto changed = texts_.find(identity(path)); changed != texts_.end()) {
      content.text = changed->second;
    }
    // Any YAML file may contain a word; only companions are compared with robots.
    if (kind == Kind::companion && find_companion_kind(path, content.text) == nullptr) {
      kind = Kind::settings;
    }
    for (const Rename& rename : renames_) {
      const std::size_t line = line_with(path, content.text, rename.from);
      if (line == 0) continue;
      const bool is_own = kind == Kind::robot && defines(content.text, rename.from);
      found_.push_back({path, kind, rename.from, line, is_own});
    }
  }

  /// The robots that were not loaded and include a changed file.
  void find_users() {
    std::vector<std::string> robots;
    for (const std::string& path : changed_) {
      if (ends_with_one_of(path, {".xacro", ".urdf"})) robots.push_back(path);
    }
    if (robots.empty()) return;
    std::vector<std::string> all = xacro_files_around(robots.front(), files_, limits_).files();
    for (const std::string& path : robots) {
      const bool is_known = std::any_of(all.begin(), all.end(), [&](const std::string& one) {
        return identity(one) == identity(path);
      });
      if (!is_known) all.push_back(path);  // xacro files include URDFs, too
    }
    const XacroFiles around(all, files_, limits_);
    for (const std::string& path : changed_) {
      for (const std::string& root : around.roots_of(path)) {
        const bool is_known = std::find(users_.begin(), users_.end(), root) != users_.end();
        if (is_known || loaded_.contains(identity(root)) || !includes(root, path)) continue;
        users_.push_back(root);
        for (const std::string& one : around.included_by(root)) users_files_.insert(identity(one));
      }
    }
  }

  /// Asks the expansion, because the path of an include may be an expression.
  bool includes(const std::string& root, const std::string& path) {
    constexpr std::size_t kMostExpanded = 30;
    const auto [known, is_new] = expanded_.try_emplace(root);
    if (is_new && expanded_.size() <= kMostExpanded) known->second = included_by_(root);
    return !known->second || known->second->contains(identity(path));
  }

  /// Whether an SRDF, or the SRDFs beside another file, are for other robots.
  bool is_of_other_robot(const Found& one) const {
    if (ends_with_one_of(one.path, {".srdf", ".srdf.xacro"})) return !is_own_srdf(one.path);
    bool has_other = false;
    const std::string folder(path::parent(one.path));
    for (const std::string& name : files_.list(folder)) {
      if (!ends_with_one_of(name, {".srdf", ".srdf.xacro"})) continue;
      if (is_own_srdf(path::join(folder, name))) return false;
      has_other = true;
    }
    return has_other;
  }

  bool is_own_srdf(const std::string& path) const {
    const std::string name = robot_name_in(files_.read(path, kMostBytes).text);
    return name.empty() || name.find('$') != std::string::npos || robots_.contains(name);
  }

  /// The names of the robots that were loaded.
  void find_robots() {
    for (const std::string& path : loaded_) {
      if (!ends_with_one_of(path, {".urdf", ".xacro"})) continue;
      robots_.insert(robot_name_in(files_.read(path, kMostBytes).text));
    }
  }

  bool is_changed(const std::string& path) const {
    return std::any_of(changed_.begin(), changed_.end(),
                       [&](const std::string& one) { return identity(one) == identity(path); });
  }

  void judge(const Found& one) {
    const std::string sentence = "'" + shown(one.path) + "' still names `" + one.name +
                                 "` in line " + std::to_string(one.line);
    if (one.kind == Kind::launch) return mention(one);
    if (one.kind == Kind::robot) {
      if (loaded_.contains(identity(one.path)) || is_changed(one.path)) return;
      if (!users_files_.contains(identity(one.path))) {
        if (one.path.ends_with(".xacro") && !one.is_defined) {
          mention(one);
        }
        return;
      }
      return add(left_.misfits, sentence + name_users());
    }
    const bool has_other_robot = std::any_of(found_.begin(), found_.end(), [&](const Found& other) {
      return other.kind == Kind::robot && other.name == one.name &&
             !loaded_.contains(identity(other.path));
    });
    if (one.kind == Kind::settings) {
      if (!is_of_other_robot(one)) mention(one);
    } else if (!users_.empty()) {
      add(left_.misfits, sentence + name_users());
    } else if (!has_other_robot && !is_of_other_robot(one)) {
      add(left_.misfits, sentence + ", but it was not recognized as a file of the robot");
    }
  }

  /// All robots that were not loaded, so that one more run is enough.
  std::string name_users() const {
    std::string names;
    for (std::size_t i = 0; i < users_.size(); ++i) {
      names += (i == 0 ? "'" : i + 1 == users_.size() ? " and '" : ", '") + shown(users_[i]) + "'";
    }
    return ", and " + names +
           (users_.size() == 1 ? " includes a changed file; name it, too"
                               : " include changed files; name them, too");
  }

  void mention(const Found& one) {
    mentions_[one.name].push_back("'" + shown(one.path) + "' (line " + std::to_string(one.line) +
                                  ")");
  }

  /// One for all files that nobody renames.
  static std::string sentence_of(const std::string& name, const std::vector<std::string>& places) {
    return quoted(name) + " is still named in " +
           enumerated_to(kMostPlaces, places, "more file", "more files") + "; change it there";
  }

  static void add(std::vector<std::string>& to, std::string sentence) {
    if (to.size() < kMostPlaces) to.push_back(std::move(sentence));
  }

  std::span<const Rename> renames_;
  std::span<const std::string> changed_;
  const std::set<std::string>& loaded_;
  const FileReader& files_;
  const Limits& limits_;
  const IncludedBy& included_by_;
  const std::map<std::string, std::string_view>& texts_;
  std::map<std::string, std::optional<std::set<std::string>>> expanded_;
  std::set<std::string> robots_;
  std::set<std::string> packages_;  ///< with changed files, by identity
  std::set<std::string> names_;     ///< of these packages
  std::size_t entries_ = 0;
  std::vector<Found> found_;
  std::vector<std::string> users_;                            ///< robots that were not loaded
  std::set<std::string> users_files_;                         ///< and their files, by identity
  std::map<std::string, std::vector<std::string>> mentions_;  ///< by name, the places
  LeftNames left_;
};

}  // namespace

LeftNames names_left(std::span<const Rename> renames, std::span<const std::string> changed,
                     const std::set<std::string>& loaded, const FileReader& files,
                     const Limits& limits, const IncludedBy& included_by,
                     const std::map<std::string, std::string_view>& texts) {
  return Search(renames, changed, loaded, files, limits, included_by, texts).run();
}

}  // namespace smurf::tools
