// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/archive_files.hpp"

#include <algorithm>

#include "archive/zip.hpp"
#include "base/files/path.hpp"
#include "base/findings/limits.hpp"

namespace smurf {
namespace {

/// All files in a folder and the folders in it.
void collect(const std::string& folder, const FileReader& files, int depth,
             std::vector<std::string>& found) {
  constexpr int kDeepest = 64;
  if (depth > kDeepest) return;
  for (const std::string& name : files.list(folder)) {
    const std::string path = folder + "/" + name;
    if (files.is_file(path)) {
      found.push_back(path);
    } else {
      collect(path, files, depth + 1, found);
    }
  }
}

}  // namespace

bool is_archive_type(std::string_view type) {
  const std::string lower = path::to_lower(type);
  return lower == "zsmurf" || lower == "zsmurfs" || lower == "zsmurfa";
}

bool is_archive(std::string_view path) {
  const std::string_view extension = path::extension(path);
  return !extension.empty() && is_archive_type(extension.substr(1));
}

bool is_in_archive(std::string_view path) {
  for (std::string_view folder = path::parent(path); folder.size() > 1;
       folder = path::parent(folder)) {
    if (is_archive(folder)) return true;
  }
  return false;
}

struct ArchiveFiles::Opened {
  MemoryFiles files;
  std::string reason;  ///< the reason why it cannot be read; empty if it can
};

struct ArchiveFiles::Place {
  const Opened* archive = nullptr;
  std::string inside;  ///< path in the archive; empty: the archive itself
};

ArchiveFiles::ArchiveFiles(const FileReader& behind, const Limits& limits)
    : behind_(behind), budget_(std::make_unique<ArchiveBudget>(limits)) {}
ArchiveFiles::~ArchiveFiles() = default;

const ArchiveFiles::Opened* ArchiveFiles::open(const std::string& path, const FileReader& around,
                                               const std::string& name) const {
  const auto known = opened_.find(path);
  if (known != opened_.end()) return known->second.get();
  if (!around.is_file(name)) return nullptr;
  const FileContent content = around.read(name, budget_->limits().file_bytes);
  Opened& opened = *(opened_[path] = std::make_unique<Opened>());
  if (content.status != ReadStatus::ok) {
    opened.reason = content.reason;
    if (content.status == ReadStatus::too_large) opened.reason += "; " + raise_limit("file-bytes");
    return &opened;
  }
  Archive archive = read_zip(content.text, *budget_);
  opened.reason = archive.reason;
  for (ArchivedFile& file : archive.files) {
    opened.files.add(file.path, std::move(file.text));
  }
  return &opened;
}

ArchiveFiles::Place ArchiveFiles::find(const std::string& given, bool as_folder) const {
  constexpr std::size_t kLongestPath = 4096;
  if (given.size() > kLongestPath || path::to_lower(given).find(".zsmurf") == std::string::npos) {
    return {};
  }
  const std::string path = path::normalize(given);
  const std::lock_guard lock(mutex_);
  Place place{nullptr, path};
  for (std::size_t end = 0; end != std::string::npos;) {
    end = path.find('/', end + 1);
    if (end == std::string::npos && !as_folder) break;
    const std::string outer = path.substr(0, end);
    if (!is_archive(outer)) continue;
    const std::size_t begin = path.size() - place.inside.size();
    const FileReader* around = &behind_;
    if (place.archive != nullptr) around = &place.archive->files;
    const Opened* archive = open(outer, *around, outer.substr(begin));
    if (archive == nullptr) continue;
    place = {archive, end == std::string::npos ? std::string() : path.substr(end + 1)};
  }
  return place;
}

FileContent ArchiveFiles::read(const std::string& path, std::uint64_t max_bytes) const {
  const Place place = find(path, false);
  if (place.archive == nullptr) return behind_.read(path, max_bytes);
  if (!place.archive->reason.empty()) {
    return {ReadStatus::denied, {}, "the archive " + place.archive->reason};
  }
  return place.archive->files.read(place.inside, max_bytes);
}

bool ArchiveFiles::is_file(const std::string& path) const {
  const Place place = find(path, false);
  if (place.archive == nullptr) return behind_.is_file(path);
  return place.archive->files.is_file(place.inside);
}

bool ArchiveFiles::is_denied(const std::string& path) const {
  return find(path, false).archive == nullptr && behind_.is_denied(path);
}

std::string ArchiveFiles::identity(const std::string& path) const {
  const Place place = find(path, true);
  return place.archive == nullptr ? behind_.identity(path) : path::normalize(path);
}

std::vector<std::string> ArchiveFiles::list(const std::string& folder) const {
  const Place place = find(folder, true);
  return place.archive == nullptr ? behind_.list(folder) : place.archive->files.list(place.inside);
}

void ArchiveFiles::rely_on_list(const std::string& folder, const std::string& digest) const {
  if (find(folder, true).archive == nullptr) behind_.rely_on_list(folder, digest);
}

ArchivedMain main_file_of_archive(const std::string& archive, const FileReader& files) {
  const std::string wanted = "." + path::to_lower(path::extension(archive)).substr(2);
  std::vector<std::string> candidates;
  collect(archive, files, 0, candidates);
  std::erase_if(candidates,
                [&](const std::string& file) { return path::extension(file) != wanted; });
  std::sort(candidates.begin(), candidates.end());
  const auto namesake =
      std::find_if(candidates.begin(), candidates.end(), [&](const std::string& file) {
        return path::stem(file) == path::stem(archive);
      });
  if (namesake != candidates.end()) return {*namesake, {}};
  if (candidates.size() == 1) return {candidates.front(), {}};
  if (!candidates.empty())
    return {{}, "contains several " + wanted + ", none of which has the name of the archive"};
  const FileContent inside =
      files.read(archive + "/" + std::string(path::stem(archive)) + wanted, 0);
  constexpr std::string_view kArchive = "the archive ";
  if (inside.status == ReadStatus::denied && inside.reason.starts_with(kArchive)) {
    return {{}, inside.reason.substr(kArchive.size())};
  }
  return {{}, "contains no " + wanted};
}

}  // namespace smurf
