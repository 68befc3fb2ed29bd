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

/// The content of a file, or the reason why it was not read.
struct FileContent {
  ReadStatus status = ReadStatus::not_found;
  std::string text;    ///< set when status is ok
  std::string reason;  ///< message for people, if status is not ok: "is a directory"
};

/// Reads the files that models and scenes name.
class FileReader {
 public:
  virtual ~FileReader() = default;

  /// Reads a whole regular file of at most `max_bytes`.
  virtual FileContent read(const std::string& path, std::uint64_t max_bytes) const = 0;
  /// True for a regular file or a link to one; never opens it.
  virtual bool is_file(const std::string& path) const = 0;
  /// Names (not paths) of the entries of a folder, sorted; empty if there is no such folder.
  virtual std::vector<std::string> list(const std::string& folder) const = 0;
  /// Tells readers that note what a result depends on: it depends on a list that somebody else has
  /// asked for. `digest`: its digest_of_names().
  virtual void rely_on_list(const std::string& /*folder*/, const std::string& /*digest*/) const {}
  /// True if nothing may be revealed about a path, not even whether a file exists there: `is_file`
  /// is then false, and `read` gives the reason.
  virtual bool is_denied(const std::string&) const { return false; }
  /// Equal for all paths to one file or folder, including paths through links. If nothing else is
  /// known, the normalised path.
  virtual std::string identity(const std::string& path) const;
};

/// Files on disk. Device files, pipes and sockets are refused without opening them.
class DiskFiles final : public FileReader {
 public:
  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::string identity(const std::string& path) const override;
};

/// Files on disk inside the allowed folders, after following symbolic links: the files that a model
/// from a stranger may name. All others are denied, whether they exist or not. The opened file is
/// judged, not its path, so a link that is changed meanwhile does not lead elsewhere. Links and
/// folders are looked up once: make a new reader after they have changed. Several threads may use
/// it once all files are allowed.
class ConfinedFiles final : public FileReader {
 public:
  ConfinedFiles();
  ~ConfinedFiles() override;
  /// A folder with all its contents, or one file.
  void allow(const std::string& path);
  /// The files in a folder that are not hidden, without its subfolders.
  void allow_files_in(const std::string& folder);
  /// The files of this name in a folder and in all its subfolders.
  void allow_named(const std::string& name, const std::string& folder);
  /// Denies files and folders of this name, in any case, with their contents, anywhere in an
  /// allowed folder. `but` is a path inside that stays allowed; "": none.
  void deny_named(const std::string& name, const std::string& but = {});
  /// Equal for readers that allow and deny the same.
  std::string scope() const;

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  bool is_denied(const std::string& path) const override;
  std::string identity(const std::string& path) const override;

 private:
  struct Allowed;
  std::optional<std::string> place_of(const std::string& path, const CanonicalPaths& paths) const;
  void reset_ways();

  DiskFiles disk_;
  std::unique_ptr<CanonicalPaths> canonical_;
  std::unique_ptr<CanonicalPaths> ways_;  ///< the limit for the length of chains of links
  std::unique_ptr<Allowed> allowed_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::vector<std::string>> lists_;
};

/// Files in memory, which override those of another reader (standard input, unsaved buffers).
class MemoryFiles final : public FileReader {
 public:
  explicit MemoryFiles(const FileReader* behind = nullptr) : behind_(behind) {}

  /// `path` is compared after lexical normalisation.
  void add(const std::string& path, std::string text);

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  void rely_on_list(const std::string& folder, const std::string& digest) const override;
  bool is_denied(const std::string& path) const override;
  std::string identity(const std::string& path) const override;

 private:
  std::map<std::string, std::string> files_;
  const FileReader* behind_;
};

}  // namespace smurf
