// SPDX-License-Identifier: BSD-3-Clause
// Writes several files in one step. All are written to temporary files first, where a full disk or
// a missing permission shows. Then they get their names, and replaced files can be restored.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/files/system.hpp"
#include "common/files/new_file.hpp"
#include "common/files/output.hpp"

namespace smurf::tools {

/// The reason to refuse a link that link_out_of_repository() has found.
std::string reason_of_link(const std::string& link);

class FileSet {
 public:
  struct Problem {
    std::string path;
    std::string reason;
    bool exists = false;  ///< there is a file that must not be replaced
  };

  enum class MissingFolders { make, refuse };

  /// `files` must outlive it.
  FileSet(const std::vector<OutputFile>& files, MissingFolders missing)
      : files_(files), missing_(missing) {}
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;
  /// Undoes all steps unless finish() was called.
  ~FileSet();

  /// Moves all files to their final names, or none.
  std::optional<Problem> write(bool overwrite);
  /// Like finish(), but the destructor undoes it unless keep() was called.
  std::optional<Problem> write_for_now(bool overwrite);
  void keep() { is_done_ = true; }

 private:
  struct Written {
    Written(int folder, std::string name) : file(folder, std::move(name)) {}
    NewFile file;
    std::string shown;
    std::optional<std::string_view> old_text;  ///< that the replaced file must still have
    bool replaces = false;
    std::string backup;  ///< a hard link to the replaced file
    bool is_placed = false;
  };

  std::optional<Problem> prepare(const OutputFile& file, bool overwrite);
  std::optional<Problem> prepare_all(bool overwrite);
  std::optional<Problem> place_all(bool is_final);
  std::optional<Problem> place(Written& written, bool is_last);
  int take_place(Written& written, bool is_last);
  static int link_backup(Written& written);
  /// `judged` is the expected path of the folder, without links.
  std::optional<Problem> open_folder(const OutputFile& file, const std::string& judged,
                                     int& folder);
  int open_below(int above, const std::string& name, int& folder);
  int make_all(const std::string& folder);

  const sys::HeldSignals signals_;  ///< until all steps are done or undone
  const std::vector<OutputFile>& files_;
  MissingFolders missing_;
  bool overwrites_ = false;
  std::set<std::pair<int, std::string>> names_;            ///< folder and name in lower case
  std::map<std::string, Descriptor> folders_;              ///< open, by path
  std::deque<Written> written_;                            ///< in the order of the files
  std::vector<std::pair<int, std::string>> made_folders_;  ///< with the parent folder of each
  bool is_done_ = false;
};

}  // namespace smurf::tools
