// SPDX-License-Identifier: BSD-3-Clause
// A file of answers, each in a line with its key and a digest. Lines are only added, each with one
// call: several processes may do so, and one that is killed leaves at most a line that is not
// complete. A line that is damaged is not found.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/found_file.hpp"
#include "base/numbers/digest.hpp"

namespace smurf {

/// Several threads may use it.
class CacheFile {
 public:
  /// Makes the folder and the file, as far as they are absent. The name says which program made the
  /// answers.
  CacheFile(const std::string& folder, const std::string& name);

  /// The last text that was added with this key before this was made.
  std::optional<std::string> find(const Digest& key) const;
  /// `text` has no line end.
  void add(const Digest& key, std::string_view text);
  /// Why it is not read, or not written to; "" if it is.
  std::string problem() const;

 private:
  using ShortKey = std::array<std::uint8_t, 16>;
  struct Line {
    ShortKey key{};
    std::uint64_t begin = 0;
    std::uint32_t size = 0;  ///< without its line end
  };

  void open();
  /// Reads where the lines are; false if the file has something else.
  bool read_lines();
  void keep_last_lines();
  void compact();
  std::string text_of(const Line& line) const;
  void fail(int error);

  std::string path_;
  std::optional<Descriptor> read_, write_;
  std::vector<Line> lines_;       ///< sorted by key
  std::uint64_t bytes_ = 0;       ///< of the file
  std::uint64_t line_bytes_ = 0;  ///< of the lines that can be found
  bool is_cut_ = false;           ///< the last line has no end
  mutable std::mutex mutex_;
  std::string problem_;
};

}  // namespace smurf
