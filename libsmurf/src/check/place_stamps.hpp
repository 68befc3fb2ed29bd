// SPDX-License-Identifier: BSD-3-Clause
// Says whether the file at a path can have changed, without reading it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/files/canonical_paths.hpp"
#include "base/files/found_file.hpp"
#include "smurf/file_reader.hpp"

namespace smurf {

/// Where a path leads and, if that is a file, when it was changed.
struct PlaceStamp {
  std::string place;  ///< a digest of its canonical path; "-": no name of the path is a link
  /// Equal as long as the file is not changed; "": it may change without a new stamp.
  std::string text;

  bool is_missing() const { return text.starts_with("missing"); }
};

/// Makes stamps. It is fastest if files of one folder come one after the other, because the folder
/// stays open. Links are followed once. Use it in one thread.
class PlaceStamps {
 public:
  explicit PlaceStamps(const FileReader& files) : files_(files) {}
  PlaceStamp of(const std::string& path);

 private:
  enum class Way : std::uint8_t { unlinked, missing, linked };
  void enter(const std::string& folder);
  PlaceStamp linked(const std::string& path) const;

  const FileReader& files_;
  CanonicalPaths canonical_;
  std::string folder_;
  std::optional<Descriptor> opened_;
  Way way_ = Way::linked;
};

}  // namespace smurf
