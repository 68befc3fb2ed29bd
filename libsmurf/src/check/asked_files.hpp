// SPDX-License-Identifier: BSD-3-Clause
// Questions about files with their answers, which a later run asks again: a result that depends on
// nothing else is valid as long as all answers are the same. Snapshot and Recorder do the same
// within one run.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/numbers/digest.hpp"
#include "check/place_stamps.hpp"
#include "smurf/file_reader.hpp"

namespace smurf {

enum class AskedKind : char {
  content = 'c',
  is_file = 'f',
  list = 'l',
  is_denied = 'd',
  identity = 'i'
};

struct AskedQuestion {
  AskedKind kind{};
  std::uint64_t max_bytes = 0;  ///< of a content
  std::string answer;           ///< short; of a content or a list, its digest
};

/// A path about which a check has asked.
struct AskedPath {
  std::string path;
  PlaceStamp stamp;  ///< before the first question
  std::vector<AskedQuestion> questions;
};

/// The digests of the names in folders: the answers of thousands of files may depend on one folder.
/// Several threads may use it, as long as nobody expects that a folder changes.
class ListDigests {
 public:
  /// `scope`: that of ConfinedFiles, which may hide names.
  std::string of(const std::string& folder, const std::string& scope, const FileReader& files);

 private:
  std::mutex mutex_;
  std::map<std::pair<std::string, std::string>, std::string> known_;
};

/// Passes questions on to another reader, and notes them. Use it in one thread.
class AskedFiles final : public FileReader {
 public:
  /// `own`: the file whose digest is noted; `notes_all`: whether everything else is noted, too.
  AskedFiles(const FileReader& files, std::string own, bool notes_all)
      : files_(files), own_(std::move(own)), notes_all_(notes_all), stamps_(files) {}

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  void rely_on_list(const std::string& folder, const std::string& digest) const override;
  bool is_denied(const std::string& path) const override;
  std::string identity(const std::string& path) const override;

  /// Of the own file, if it was read.
  const std::optional<Digest>& own_digest() const { return own_digest_; }
  /// All questions, sorted by path; none if there are too many, or if one question had two answers,
  /// because a file has changed meanwhile.
  std::optional<std::vector<AskedPath>> asked() const;

 private:
  void begin(const std::string& path) const;
  void note(AskedKind kind, const std::string& path, std::uint64_t max_bytes,
            std::string answer) const;

  const FileReader& files_;
  std::string own_;
  mutable bool notes_all_;
  mutable PlaceStamps stamps_;
  mutable std::optional<Digest> own_digest_;
  mutable std::map<std::string, AskedPath> asked_;
  mutable bool is_complete_ = true;  ///< else asked() has none
};

enum class AskedAgain : std::uint8_t {
  other,                 ///< an answer is another one
  same,                  ///< all answers are the same
  same_with_new_stamps,  ///< the same, and stamps were replaced
};

/// Asks again, where a file may have changed. `asked` is sorted by path.
AskedAgain ask_again(std::vector<AskedPath>& asked, const FileReader& files, ListDigests& lists,
                     const std::string& scope);

}  // namespace smurf
