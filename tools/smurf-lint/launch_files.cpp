// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/launch_files.hpp"

#include <algorithm>
#include <set>

#include "base/path.hpp"

namespace smurf::tools {
namespace {

constexpr std::size_t kMostEntries = 20'000;
constexpr std::uint64_t kMostBytes = 1U << 20U;  // of a launch file
constexpr std::size_t kMostPlaces = 20;

/// Xacro files may belong to robots that were not loaded, or make the name in an expression.
bool may_name_parts(std::string_view name) {
  for (const std::string_view end :
       {".launch", ".launch.py", ".launch.xml", ".launch.yaml", ".xacro"}) {
    if (name.ends_with(end)) return true;
  }
  return false;
}

/// The folder of the package around a file; "" if there is none.
std::string package_around(const std::string& path, const FileReader& files) {
  constexpr int kMostLevels = 8;
  std::string folder(path::parent(path));
  for (int level = 0; level < kMostLevels; ++level, folder = path::join(folder, "..")) {
    if (files.is_file(path::join(folder, "package.xml"))) return folder.empty() ? "." : folder;
  }
  return {};
}

class Search {
 public:
  Search(std::span<const Rename> renames, const FileReader& files)
      : renames_(renames), files_(files) {}

  void look_in(const std::string& folder, int depth = 0) {
    constexpr int kDeepest = 6;
    for (const std::string& name : files_.list(folder)) {
      if (++entries_ > kMostEntries || name.starts_with('.')) continue;
      const std::string path = path::join(folder, name);
      if (may_name_parts(name)) {
        read(path);
      } else if (depth < kDeepest && name.find('.') == std::string::npos) {
        look_in(path, depth + 1);
      }
    }
  }

  std::vector<std::string> take() { return std::move(found_); }

 private:
  void read(const std::string& path) {
    const FileContent content = files_.read(path, kMostBytes);
    if (content.status != ReadStatus::ok) return;
    for (const Rename& rename : renames_) {
      for (std::size_t at = content.text.find(rename.from); at != std::string::npos;
           at = content.text.find(rename.from, at + 1)) {
        if (!is_whole(content.text, at, at + rename.from.size())) continue;
        // The key of a table that a xacro file reads, such as `positions['elbow']`.
        if (path.ends_with(".xacro") && at > 1 && content.text[at - 2] == '[') continue;
        const auto line =
            1 + std::count(content.text.begin(),
                           content.text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        if (found_.size() >= kMostPlaces) return;
        found_.push_back("'" + path + "' still names `" + rename.from + "` in line " +
                         std::to_string(line) + "; change it there");
      }
    }
  }

  /// A text in quotes, or the value of an argument.
  static bool is_whole(std::string_view text, std::size_t begin, std::size_t end) {
    const char before = begin == 0 ? '\0' : text[begin - 1];
    const char after = end == text.size() ? '\0' : text[end];
    const bool is_argument = text.substr(0, begin).ends_with(":=");
    const bool ends = after == '"' || after == '\'' || after == ' ' || after == ',';
    return (before == '"' || before == '\'') ? after == before : is_argument && ends;
  }

  std::span<const Rename> renames_;
  const FileReader& files_;
  std::size_t entries_ = 0;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> launch_files_with(std::span<const Rename> renames,
                                           std::span<const std::string> changed,
                                           const FileReader& files) {
  std::set<std::string> packages;
  for (const std::string& path : changed) packages.insert(package_around(path, files));
  packages.erase("");
  Search search(renames, files);
  for (const std::string& package : packages) search.look_in(package);
  return search.take();
}

}  // namespace smurf::tools
