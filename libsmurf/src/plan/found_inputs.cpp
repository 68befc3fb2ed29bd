// SPDX-License-Identifier: BSD-3-Clause
// The result does not depend on the order in which a file system lists a folder.
#include "smurf/found_inputs.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <set>
#include <system_error>
#include <utility>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "base/findings/limits.hpp"
#include "base/text/words.hpp"
#include "link/companions/kinds.hpp"
#include "plan/paths.hpp"
#include "smurf/companions.hpp"
#include "smurf/confine.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/plan.hpp"
#include "smurf/render.hpp"
#include "smurf/xacro.hpp"

namespace smurf {
namespace {

bool is_sought(std::string_view path) {
  const InputKind kind = input_kind(path);
  if (xacro::is_xacro_file(path)) return false;
  if (may_be_imported(path)) return false;
  return kind == InputKind::model || kind == InputKind::scene || kind == InputKind::urdf ||
         is_companion_path(path);
}

using places::Entry;
using Entries = std::vector<std::pair<std::string, Entry>>;

/// Whether colcon fills the folder with copies of the packages.
bool is_output_of_colcon(const std::string& folder, const Entries& entries) {
  return is_one_of(path::file_name(folder), {"install", "build", "log"}) &&
         std::any_of(entries.begin(), entries.end(),
                     [](const auto& one) { return one.first == "COLCON_IGNORE"; });
}

class Search {
 public:
  Search(const Limits& limits, const LeftOut& is_left_out)
      : is_left_out_(is_left_out), most_entries_(limits.folder_entries) {}

  FoundInputs run(const std::string& folder) {
    root_ = identity(folder);
    inside_.allow(folder);
    walk(folder);
    // Links come last, so a file gets its own path if that is inside the folder.
    for (std::size_t i = 0; i < links_.size(); ++i) follow(std::string(links_[i]));
    std::sort(found_.files.begin(), found_.files.end());
    std::sort(found_.model_links.begin(), found_.model_links.end());
    std::sort(found_.xacro.begin(), found_.xacro.end());
    std::sort(found_.xml.begin(), found_.xml.end());
    std::sort(found_.yaml.begin(), found_.yaml.end());
    std::sort(found_.unreadable.begin(), found_.unreadable.end());
    return std::move(found_);
  }

 private:
  bool is_left_out(const std::string& path, bool is_folder) {
    if (!is_left_out_ || !is_left_out_(path, is_folder)) return false;
    ++found_.left_out;
    return true;
  }

  bool is_new(const sys::Status& status) {
    return seen_.insert({status.st_dev, status.st_ino}).second;
  }

  void fail(const std::string& path, int error) {
    found_.unreadable.push_back("'" + path + "': " + std::generic_category().message(error));
  }

  /// True once there were too many entries.
  bool is_full() {
    if (entries_ < most_entries_) return false;
    if (entries_++ == most_entries_) {
      found_.unreadable.push_back("'" + root_ + "': it has more than " +
                                  std::to_string(most_entries_) + " files and folders; " +
                                  raise_limit("folder-entries"));
    }
    return true;
  }

  void walk(const std::string& folder) {
    sys::Status status{};
    if (sys::stat(folder.c_str(), &status) != 0) return fail(folder, errno);
    if (!is_new(status)) return;
    Entries entries;
    bool is_cut = false;
    const std::error_code error = places::for_each_entry(folder, [&](std::string name, Entry kind) {
      is_cut = is_full();
      if (is_cut) return false;
      ++entries_;
      entries.emplace_back(std::move(name), kind);
      return true;
    });
    if (is_cut) return;
    if (error) fail(folder, error.value());
    if (is_output_of_colcon(folder, entries)) return;
    std::sort(entries.begin(), entries.end());
    for (const auto& [name, kind] : entries) {
      if (!name.starts_with('.')) visit(path::join(folder, name), kind);
    }
  }

  void visit(const std::string& path, Entry kind) {
    if (kind == Entry::link) {
      links_.push_back(path);
    } else if (kind == Entry::folder) {
      if (!is_left_out(path, true)) walk(path);
    } else if (kind == Entry::file && is_sought(path)) {
      sys::Status status{};
      if (sys::lstat(path.c_str(), &status) != 0) return fail(path, errno);
      if (is_left_out(path, false)) return;
      found_.files.push_back(path);  // each hard link: it has other neighbours
    } else if (kind == Entry::file && xacro::is_xacro_file(path) && !is_left_out(path, false)) {
      found_.xacro.push_back(path);
    } else if (kind == Entry::file && may_be_imported(path) && !is_left_out(path, false)) {
      found_.xml.push_back(path);
    } else if (kind == Entry::file && may_be_parameters(path) && !is_left_out(path, false)) {
      found_.yaml.push_back(path);
    }
  }

  /// Skips paths outside of the folder without checking whether they exist, and links that lead out
  /// and back.
  void follow(const std::string& link) {
    sys::Status status{};
    if (inside_.is_denied(link)) {
      if (!is_sought(link)) {
        if (!is_left_out(link, false)) ++found_.links_outside;
      } else if (!is_left_out(link, false)) {
        found_.model_links.push_back(link);
      }
    } else if (sys::stat(link.c_str(), &status) != 0) {
      if (is_sought(link)) fail(link, errno);
    } else if (S_ISDIR(status.st_mode)) {
      // git treats a link as a file, whatever its target.
      if (!is_left_out(link, false)) walk(link);
    } else if (S_ISREG(status.st_mode) && is_sought(link)) {
      if (is_left_out(link, false)) return;
      see_files();
      if (is_new(status)) found_.files.push_back(link);
    }
  }

  /// Makes the files known that were found so far. Only links ask for it: a data set without links
  /// has many thousands of files.
  void see_files() {
    for (; seen_files_ < found_.files.size(); ++seen_files_) {
      sys::Status status{};
      const std::string& path = found_.files[seen_files_];
      if (sys::stat(path.c_str(), &status) == 0) is_new(status);
    }
  }

  const LeftOut& is_left_out_;
  const std::uint64_t most_entries_;
  std::uint64_t entries_ = 0;
  std::string root_;  ///< with all links followed
  ConfinedFiles inside_;
  FoundInputs found_;
  std::vector<std::string> links_;
  std::set<std::pair<std::uint64_t, std::uint64_t>> seen_;
  std::size_t seen_files_ = 0;  ///< how many of the files are in it
};

}  // namespace

FoundInputs find_inputs(const std::string& folder, const Limits& limits,
                        const LeftOut& is_left_out) {
  return Search(limits, is_left_out).run(folder);
}

std::string why_nothing(const FoundInputs& found, const std::string& folder) {
  const std::string_view last = found.xacro.empty() ? ", .urdf or .xacro" : " or .urdf";
  std::string text =
      "no .smurf, .smurfs, .smurfa" + std::string(last) + " file in '" + folder + "'";
  if (found.left_out > 0) text += " (" + std::to_string(found.left_out) + " left out)";
  if (!found.xacro.empty()) {
    text += ", only xacro files: name the one of a robot, with its arguments as NAME:=VALUE";
  }
  if (found.links_outside > 0) {
    text += "; symbolic links that lead out of the folder are not followed: name what to check "
            "there";
  }
  return text;
}

}  // namespace smurf
