// SPDX-License-Identifier: BSD-3-Clause
// The input of the fuzz targets that need several files: texts between lines `%%% NAME`.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "support/exercise.hpp"

namespace smurf::test {

inline constexpr std::string_view kBundleMark = "%%% ";

/// Without a marker, the text is a file `first`.
inline MemoryFiles unbundle(std::string_view bytes, const std::string& first) {
  MemoryFiles files;
  std::string name = first;
  std::string text;
  while (!bytes.empty()) {
    const std::size_t size = std::min(bytes.find('\n'), bytes.size() - 1) + 1;
    const std::string_view line = bytes.substr(0, size);
    bytes.remove_prefix(size);
    if (!line.starts_with(kBundleMark)) {
      text += line;
      continue;
    }
    if (!text.empty()) files.add(name, std::move(text));
    text.clear();
    name = line.substr(kBundleMark.size(), line.find_last_not_of('\n') + 1 - kBundleMark.size());
  }
  if (!text.empty()) files.add(name, std::move(text));
  return files;
}

/// Ends the process at the first violated promise, so that libFuzzer records a crash.
inline void require_kept(const Exercise& result) {
  if (result.broken.empty()) return;
  std::fprintf(stderr, "broken promise: %s\n", result.broken.front().c_str());
  std::abort();
}

}  // namespace smurf::test
