// SPDX-License-Identifier: BSD-3-Clause
// Files with versions, as one check sees them, and a record of the questions about them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "smurf/check.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// Keeps the texts of files, so a later check reads only changed files. Several threads may use
/// it.
class Snapshot final : public FileReader {
 public:
  Snapshot(const FileReader& files, StampOf stamp_of)
      : files_(files), stamp_of_(std::move(stamp_of)) {}

  /// The next query about each file is answered from disk again.
  void begin() { ++round_; }

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override { return files_.is_file(path); }
  std::vector<std::string> list(const std::string& folder) const override {
    return files_.list(folder);
  }
  bool is_denied(const std::string& path) const override { return files_.is_denied(path); }
  std::string identity(const std::string& path) const override { return files_.identity(path); }
  /// Changes whenever the content may have changed.
  std::uint64_t version(const std::string& path) const;
  /// Changes whenever the names in a folder may have changed.
  std::uint64_t list_version(const std::string& folder) const;

 private:
  /// The names in a folder, as one text.
  struct KnownList {
    std::string text;
    std::uint64_t version = 0;
    std::uint64_t round = 0;  ///< the check in which it was last queried
  };
  struct Known {
    FileStamp stamp;
    std::uint64_t version = 0;
    std::uint64_t round = 0;             ///< the check in which it was last queried
    std::optional<FileContent> content;  ///< none if the text is too large to keep
  };
  Known& know(const std::string& path) const;
  /// The version changes only when the content changes.
  void compare(const std::string& path, Known& known) const;
  void keep(FileContent content, Known& known) const;

  const FileReader& files_;
  StampOf stamp_of_;
  std::uint64_t round_ = 0;
  mutable std::mutex mutex_;
  mutable std::map<std::string, Known> known_;
  mutable std::map<std::string, KnownList> known_lists_;
  mutable std::uint64_t kept_bytes_ = 0;
  mutable std::uint64_t last_version_ = 0;
};

/// Records queries about files and their answers. Results that depend on them stay valid as long as
/// the answers stay the same. Use it in one thread.
class Recorder final : public FileReader {
 public:
  enum class Kind : std::uint8_t { content, is_file, list, is_denied, identity };
  struct Question {
    Kind kind;
    std::string path;
    friend bool operator<(const Question& a, const Question& b) {
      return std::tie(a.kind, a.path) < std::tie(b.kind, b.path);
    }
  };
  struct Answer {
    std::string text;
    std::size_t count = 0;  ///< the number of queries
  };
  using Answers = std::map<Question, Answer>;

  explicit Recorder(const Snapshot& files) : files_(files) {}

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  bool is_denied(const std::string& path) const override;
  std::string identity(const std::string& path) const override;

  Answers take() { return std::move(answers_); }

 private:
  void note(Kind kind, const std::string& path, std::string text) const;

  const Snapshot& files_;
  mutable Answers answers_;
};

/// Whether these queries have the same answers now.
bool is_unchanged(const Recorder::Answers& answers, const Snapshot& files);

/// Whether a query was only about a text that is a source. A new answer then leaves meshes
/// unchanged.
bool is_of_source(const Recorder::Question& question, const Recorder::Answer& answer,
                  const SourceMap& sources);

}  // namespace smurf
