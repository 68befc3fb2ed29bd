// SPDX-License-Identifier: BSD-3-Clause
// Archives (.zsmurf, .zsmurfs, .zsmurfa) as folders: "scenes/cell.zsmurf/box.smurf" is a file in
// one.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"

namespace smurf {

class ArchiveBudget;

/// zsmurf, zsmurfs and zsmurfa, any case: what entities call a model or scene in an archive.
bool is_archive_type(std::string_view type);
/// By the extension.
bool is_archive(std::string_view path);
/// Whether a path leads through an archive, judged by the names of its folders.
bool is_in_archive(std::string_view path);

/// Reads files in archives, nested ones included, in memory; all other files come from the reader
/// behind it. An archive is unpacked once, at the first access to a file in it. Several threads may
/// use it.
class ArchiveFiles final : public FileReader {
 public:
  /// `behind` must outlive this. All archives together unpack to at most `archive_bytes`, and to at
  /// most `archive_growth` times their own size.
  ArchiveFiles(const FileReader& behind, const Limits& limits);
  ~ArchiveFiles() override;

  /// Denies access to everything in a broken archive, and gives the reason.
  FileContent read(const std::string& path, std::uint64_t max_bytes) const override;
  bool is_file(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  void rely_on_list(const std::string& folder, const std::string& digest) const override;
  bool is_denied(const std::string& path) const override;
  std::string identity(const std::string& path) const override;

 private:
  struct Opened;
  struct Place;

  /// The innermost archive on the way to a path, which may be the path itself if it is a folder.
  Place find(const std::string& path, bool as_folder) const;
  /// The archive at `path`, which `around` calls `name`; null if there is no such file.
  const Opened* open(const std::string& path, const FileReader& around,
                     const std::string& name) const;

  const FileReader& behind_;
  mutable std::mutex mutex_;
  std::unique_ptr<ArchiveBudget> budget_;
  mutable std::map<std::string, std::unique_ptr<Opened>, std::less<>> opened_;
};

/// The main file of an archive: its only .smurf (.smurfs, .smurfa), or the one with the name of the
/// archive.
struct ArchivedMain {
  std::string path;    ///< "cell.zsmurfs/cell.smurfs"; empty if there is none
  std::string reason;  ///< the reason, for people: "holds no .smurfs"
};
/// Whether `files` is an ArchiveFiles or contains one.
ArchivedMain main_file_of_archive(const std::string& archive, const FileReader& files);

}  // namespace smurf
