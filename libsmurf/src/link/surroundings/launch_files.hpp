// SPDX-License-Identifier: BSD-3-Clause
// Which files of a package are launch files, and the one way to read them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "link/surroundings/launch_reader.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/source.hpp"

namespace smurf {

inline constexpr std::uint64_t kMostBytesOfLaunch = 1U << 18U;

/// By the name of a file, which ends with `.launch.py` or `_launch.py`.
std::optional<LaunchFile::Form> launch_form_of(std::string_view name);

struct FoundLaunch {
  std::string path;
  LaunchFile::Form form{};
};

/// The launch files in these folders of a package, and in the folders in its folder `launch`.
std::vector<FoundLaunch> launch_files_of(const std::string& package,
                                         std::initializer_list<std::string_view> folders,
                                         const FileReader& files);

/// Launch files as far as they are known without the packages around them, each read once for all
/// robots of a run. Several threads may use it.
class LaunchLibrary {
 public:
  /// Reads `text`, the content of `path`, as the form says; `fault` says what makes it unreadable.
  /// The copy has its places in `source`, and `find` has looked at each of its paths.
  LaunchFile read(const std::string& path, const std::string& text, LaunchFile::Form form,
                  bool is_ros1, SourceId source, const Limits& limits, const FindLaunchPath& find);

 private:
  std::mutex mutex_;
  std::map<std::pair<std::string, bool>, std::unique_ptr<const LaunchFile>> files_;
};

}  // namespace smurf
