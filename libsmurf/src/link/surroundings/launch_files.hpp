// SPDX-License-Identifier: BSD-3-Clause
// Which files of a package are launch files, and the one way to read them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
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

/// Reads a source as the form of `file` says; `fault` says what makes it unreadable.
void read_launch(const SourceMap& sources, SourceId source, const Limits& limits,
                 const FindLaunchPath& find, LaunchFile& file);

}  // namespace smurf
