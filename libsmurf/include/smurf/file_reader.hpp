// SPDX-License-Identifier: BSD-3-Clause
// The only access to the file system: a reader that can be replaced by files in memory.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace smurf {

class CanonicalPaths;

enum class ReadStatus : std::uint8_t { ok, not_found, not_a_file, too_large, denied };

/// A file that was read, or why it was not.
struct FileContent {
  ReadStatus status = ReadStatus::not_found;
  std::string text;    ///< set when status is ok
  std::string reason;  ///< for a person, when status is not ok: "is a directory"
};

/// Reads the files that models and scenes name.
class FileReader {
 public:
  virtual ~FileReader() = default;

  /// Reads a whole regular file of at most `max_bytes`.
  virtual FileContent read(const std::string& path, std::uint64_t max_bytes) const = 0;
  /// True for a regular file or a link to one; never opens it.
  virtual bool is_file(const std::string& path) const = 0;
  /// Names (not paths) of the entries of a folder, sorted; empty when there is no such folder.
  virtual std::vector<std::string> list(const std::string& folder) const = 0;
  /// True when a path must stay unknown, even whether something is there: `is_file` is false then,
  /// and `read` gives the reason.
  virtual bool is_denied(const std::string&) const { return false; }
  /// Equal for all names of one file or folder, whatever links they go through. The normalised path
  /// when nothing else is known.
  virtual std::string identity(const std::string& path) const;
};

/// Files of the machine. Device files, pipes and sockets are refused, not opened.
class DiskFiles final : public FileReader {
 public:
  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::string identity(const std::string& path) const override;
};

/// Files of the machine inside of the allowed folders, after following symbolic links: what a model
/// from a stranger may name. All others are denied, whether they exist or not. The opened file is
/// judged, not its path, so that a link that changes meanwhile leads nowhere else. Links and
/// folders are looked up once: make a new reader after they have changed. Several threads may use
/// it once everything is allowed.
class ConfinedFiles final : public FileReader {
 public:
  ConfinedFiles();
  ~ConfinedFiles() override;
  /// A folder with all that is in it, or one file.
  void allow(const std::string& path);
  /// The files in a folder that are not hidden, without the folders in it.
  void allow_files_in(const std::string& folder);
  /// The files of this name in a folder and in all folders in it.
  void allow_named(const std::string& name, const std::string& folder);
  /// Denies everything of this name, in any case, with its contents, wherever it is in an allowed
  /// folder. `but` is a path in it that stays allowed; "": none.
  void deny_named(const std::string& name, const std::string& but = {});

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  bool is_denied(const std::string& path) const override;
  std::string identity(const std::string& path) const override;

 private:
  struct Allowed;
  std::optional<std::string> place_of(const std::string& path, const CanonicalPaths& paths) const;
  void judge_ways_anew();

  DiskFiles disk_;
  std::unique_ptr<CanonicalPaths> canonical_;
  std::unique_ptr<CanonicalPaths> ways_;  ///< no further than links may go
  std::unique_ptr<Allowed> allowed_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::vector<std::string>> lists_;
};

/// Files in memory, in front of another reader when one is given (standard input, unsaved buffers).
class MemoryFiles final : public FileReader {
 public:
  explicit MemoryFiles(const FileReader* behind = nullptr) : behind_(behind) {}

  /// `path` is compared after lexical normalisation.
  void add(const std::string& path, std::string text);

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  bool is_denied(const std::string& path) const override;
  std::string identity(const std::string& path) const override;

 private:
  std::map<std::string, std::string> files_;
  const FileReader* behind_;
};

}  // namespace smurf
