// SPDX-License-Identifier: BSD-3-Clause
// Zip archives, in memory. This is the only place that uses minizip.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/limits.hpp"

namespace smurf {

struct ArchivedFile {
  std::string path;  ///< relative, without ".."
  std::string text;
};

struct Archive {
  std::vector<ArchivedFile> files;  ///< sorted by path
  std::string reason;  ///< the reason why it cannot be read, for people; empty if it can
};

/// The budget for unpacking all archives of a run.
class ArchiveBudget {
 public:
  explicit ArchiveBudget(const Limits& limits) : limits_(limits) {}

  const Limits& limits() const { return limits_; }
  /// Call it before unpacking an archive of this size.
  void add_packed(std::uint64_t bytes) {
    packed_ += bytes;
    ++archives_;
  }
  /// Reserves `bytes`. Returns false and reserves nothing when they exceed the budget.
  bool take(std::uint64_t bytes);
  /// The reason of a failure: "unpacks to more than 100 bytes; raise the limit ...".
  std::string excess() const;

 private:
  std::uint64_t most() const;
  std::uint64_t most_by_growth() const;

  Limits limits_;
  std::uint64_t archives_ = 0;
  std::uint64_t packed_ = 0;
  std::uint64_t unpacked_ = 0;
};

/// Unpacks an archive within the budget. An entry that is encrypted, broken or outside of the
/// archive makes all of it unreadable.
Archive read_zip(std::string_view bytes, ArchiveBudget& budget);
/// Unpacks a single archive in the same way.
inline Archive read_zip(std::string_view bytes, const Limits& limits) {
  ArchiveBudget budget(limits);
  return read_zip(bytes, budget);
}

}  // namespace smurf
