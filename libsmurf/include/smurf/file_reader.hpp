// SPDX-License-Identifier: BSD-3-Clause
// The only door to the file system: a reader that can be replaced by files in memory.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace smurf {

class CanonicalPaths;

enum class ReadStatus : std::uint8_t { ok, not_found, not_a_file, too_large, denied };

struct FileContent {
  ReadStatus status = ReadStatus::not_found;
  std::string text;    ///< set when status is ok
  std::string reason;  ///< for a person, when status is not ok: "is a directory"
};

class FileReader {
 public:
  virtual ~FileReader() = default;

  /// Reads a whole regular file of at most `max_bytes`.
  virtual FileContent read(const std::string& path, std::uint64_t max_bytes) const = 0;
  /// True for a regular file or a link to one; never opens it.
  virtual bool is_file(const std::string& path) const = 0;
  /// Names (not paths) of the entries of a folder, sorted; empty when there is no such folder.
  virtual std::vector<std::string> list(const std::string& folder) const = 0;
};

/// Files of the machine. Device files, pipes and sockets are refused, not opened.
class DiskFiles final : public FileReader {
 public:
  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
};

/// Files of the machine that really lie in one of some folders, symbolic links followed: what a
/// model from a stranger may name. Others are denied; whether they exist is still told. Where links
/// lead is looked up once: make a new one after links have changed.
class ConfinedFiles final : public FileReader {
 public:
  ConfinedFiles();
  ~ConfinedFiles() override;
  void allow(const std::string& folder);

  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override { return disk_.is_file(path); }
  std::vector<std::string> list(const std::string& folder) const override;

 private:
  bool allows(const std::string& path) const;

  DiskFiles disk_;
  std::unique_ptr<CanonicalPaths> canonical_;
  std::vector<std::string> folders_;  ///< canonical, with a '/' at the end
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

 private:
  std::map<std::string, std::string> files_;
  const FileReader* behind_;
};

}  // namespace smurf
