// SPDX-License-Identifier: BSD-3-Clause
// read(2) into a buffer of the file's size: faster than streams.
#include "smurf/file_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "base/files/canonical_paths.hpp"
#include "base/files/found_file.hpp"
#include "base/files/path.hpp"
#include "base/files/system.hpp"

namespace smurf {
namespace {

FileContent failure(int error) {
  const bool is_missing = error == ENOENT || error == ENOTDIR;
  return {is_missing ? ReadStatus::not_found : ReadStatus::denied, {}, sys::error_text(error)};
}

FileContent outside() {
  return {ReadStatus::denied, {}, "it lies outside of the project; --allow-outside reads it"};
}

/// The system would end the path at a zero byte.
bool has_zero(const std::string& path) { return path.find('\0') != std::string::npos; }

FileContent read_all(const FoundFile& found, std::uint64_t max_bytes) {
  if (S_ISDIR(found.status().st_mode)) return {ReadStatus::not_a_file, {}, "is a folder"};
  if (!S_ISREG(found.status().st_mode)) {
    return {ReadStatus::not_a_file, {}, "is not a regular file"};
  }
  const Descriptor file(found.open());
  if (file.number() < 0) return failure(errno);
  const auto size = static_cast<std::uint64_t>(found.status().st_size);
  FileContent content{ReadStatus::ok, {}, {}};
  if (size > max_bytes || size > content.text.max_size())
    return {ReadStatus::too_large, {}, "has " + std::to_string(size) + " bytes"};

  content.text.resize(static_cast<std::size_t>(size));
  std::size_t filled = 0;
  while (filled < content.text.size()) {
    const ssize_t count =
        sys::read(file.number(), content.text.data() + filled, content.text.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failure(errno);
    if (count == 0) break;  // the file shrank meanwhile
    filled += static_cast<std::size_t>(count);
  }
  content.text.resize(filled);
  return content;
}

std::vector<std::string> names_in(const FoundFile& found) {
  std::vector<std::string> names;
  if (found.error() != 0 || !S_ISDIR(found.status().st_mode)) return names;
  names = sys::names_in(found.open());
  std::sort(names.begin(), names.end());
  return names;
}

std::string in_folder(const std::string& folder) { return folder.empty() ? "." : folder; }

}  // namespace

std::string FileReader::identity(const std::string& path) const { return path::normalize(path); }

FileContent DiskFiles::read(const std::string& path, std::uint64_t max_bytes) const {
  if (has_zero(path)) return {ReadStatus::not_found, {}, "has a zero byte"};
  const FoundFile found(path);
  return found.error() != 0 ? failure(found.error()) : read_all(found, max_bytes);
}

bool DiskFiles::is_file(const std::string& path) const {
  sys::Status status{};
  return !has_zero(path) && sys::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
         sys::is_named_so(path);
}

std::vector<std::string> DiskFiles::list(const std::string& folder) const {
  return has_zero(folder) ? std::vector<std::string>{} : names_in(FoundFile(in_folder(folder)));
}

std::string DiskFiles::identity(const std::string& path) const {
  sys::Status status{};
  if (has_zero(path) || sys::stat(in_folder(path).c_str(), &status) != 0) {
    return path::normalize(path);
  }
  // The zero byte keeps an identity distinct from every path.
  return std::to_string(status.st_dev) + '\0' + std::to_string(status.st_ino);
}

/// All paths are canonical.
struct ConfinedFiles::Allowed {
  using Paths = std::set<std::string, std::less<>>;
  bool everything = false;
  Paths whole;     ///< with all that is in them
  Paths files_in;  ///< with what is in them and below, except hidden files and folders
  std::set<std::pair<std::string, std::string>, std::less<>> named;  ///< name and folder
  std::map<std::string, std::string, std::less<>> denied;            ///< denied names

  bool holds(std::string_view path) const {
    if (everything || is_whole(path) || is_visible(path)) return true;
    return !named.empty() && is_named(path::file_name(path), path::parent(path));
  }

  /// A path inside of a denied folder may be allowed.
  bool is_whole(std::string_view whole_path) const {
    for (std::string_view path = whole_path; path.size() > 1; path = path::parent(path)) {
      if (whole.contains(path)) return true;
      if (is_denied(path, whole_path)) return false;
    }
    return false;
  }

  /// Whether the path is known to exist, because it contains an allowed path.
  bool is_above(const std::string& folder) const {
    const std::string inside = folder == "/" ? folder : folder + "/";
    const auto has = [&](const Paths& paths) {
      const auto first = paths.lower_bound(inside);
      return first != paths.end() && first->starts_with(inside);
    };
    return whole.contains(folder) || files_in.contains(folder) || has(whole) || has(files_in) ||
           std::any_of(named.begin(), named.end(), [&](const auto& one) {
             return one.second == folder || one.second.starts_with(inside);
           });
  }

 private:
  /// Whether it lies below one of `files_in`, and nothing on the way is hidden.
  bool is_visible(std::string_view path) const {
    if (files_in.empty()) return false;
    for (; path.size() > 1 && !path::file_name(path).starts_with('.'); path = path::parent(path)) {
      if (files_in.contains(path::parent(path))) return true;
    }
    return false;
  }

  /// Whether `inside` is `path` or inside of it.
  bool is_denied(std::string_view path, std::string_view inside) const {
    const auto found = denied.find(path::to_lower(path::file_name(path)));
    if (found == denied.end()) return false;
    return found->second.empty() || inside.substr(path.size()) != "/" + found->second;
  }

  bool is_named(std::string_view name, std::string_view folder) const {
    for (; !folder.empty(); folder = path::parent(folder)) {
      if (named.contains({std::string(name), std::string(folder)})) return true;
      if (folder == "/") break;
    }
    return false;
  }
};

ConfinedFiles::ConfinedFiles()
    : canonical_(std::make_unique<CanonicalPaths>()), allowed_(std::make_unique<Allowed>()) {
  reset_ways();
}
ConfinedFiles::~ConfinedFiles() = default;

/// Decides again which links may be followed. Otherwise, a link that leaves the project and returns
/// to it could reveal whether folders outside exist.
void ConfinedFiles::reset_ways() {
  const auto is_known = [this](const std::string& place) {
    return allowed_->holds(place) || allowed_->is_above(place);
  };
  ways_ = std::make_unique<CanonicalPaths>(
      [this, is_known](const std::string& folder, const std::string& place) {
        if (!allowed_->holds(folder) || is_known(place)) return true;
        const auto canonical = canonical_->of(place);  // /home may be a link
        return canonical && is_known(*canonical);
      });
  lists_.clear();
}

std::optional<std::string> ConfinedFiles::place_of(const std::string& path,
                                                   const CanonicalPaths& paths) const {
  auto canonical = paths.of(path);
  if (canonical || has_zero(path)) return canonical;
  // A parent folder may be unreadable.
  const FoundFile found(in_folder(path));
  return found.error() == 0 ? found.real_path() : std::nullopt;
}

void ConfinedFiles::allow(const std::string& path) {
  const auto place = path.empty() ? std::nullopt : place_of(path, *canonical_);
  if (!place) return;
  const std::string whole = path::normalize(*place + "/");
  if (whole == "/") allowed_->everything = true;
  allowed_->whole.insert(whole);
  reset_ways();
}

void ConfinedFiles::allow_files_in(const std::string& folder) {
  if (auto place = place_of(folder, *canonical_)) allowed_->files_in.insert(*std::move(place));
  reset_ways();
}

void ConfinedFiles::allow_named(const std::string& name, const std::string& folder) {
  if (auto place = place_of(folder, *canonical_)) allowed_->named.emplace(name, *std::move(place));
  reset_ways();
}

void ConfinedFiles::deny_named(const std::string& name, const std::string& but) {
  allowed_->denied.emplace(path::to_lower(name), but);
  reset_ways();
}

std::string ConfinedFiles::scope() const {
  std::string text = allowed_->everything ? "all\n" : "";
  for (const std::string& path : allowed_->whole) text += "in " + path + "\n";
  for (const std::string& path : allowed_->files_in) text += "files " + path + "\n";
  for (const auto& [name, folder] : allowed_->named) text += "named " + name + "/" + folder + "\n";
  for (const auto& [name, but] : allowed_->denied) text += "not " + name + "/" + but + "\n";
  return text;
}

bool ConfinedFiles::is_denied(const std::string& path) const {
  if (allowed_->everything || has_zero(path)) return false;
  const auto place = place_of(path, *ways_);
  return !place || !allowed_->holds(*place);
}

FileContent ConfinedFiles::read(const std::string& path, std::uint64_t max_bytes) const {
  if (allowed_->everything || has_zero(path)) return disk_.read(path, max_bytes);
  const FoundFile found(path);
  if (found.error() != 0) {
    if (const auto place = found.real_path()) ways_->saw(path, *place);
    return is_denied(path) ? outside() : failure(found.error());
  }
  const auto real = found.real_path();
  if (real) ways_->saw(path, *real);
  const bool is_nowhere = !real && !S_ISREG(found.status().st_mode);  // a pipe of a shell
  const bool is_inside = real && allowed_->holds(*real) && !is_denied(path);
  return is_nowhere || is_inside ? read_all(found, max_bytes) : outside();
}

bool ConfinedFiles::is_file(const std::string& path) const {
  return disk_.is_file(path) && !is_denied(path);
}

std::string ConfinedFiles::identity(const std::string& path) const {
  return is_denied(path) ? path::normalize(path) : disk_.identity(path);
}

std::vector<std::string> ConfinedFiles::list(const std::string& folder) const {
  {
    const std::lock_guard lock(mutex_);
    const auto known = lists_.find(folder);
    if (known != lists_.end()) return known->second;
  }
  if (has_zero(folder)) return {};
  const FoundFile found(in_folder(folder));
  const auto real = found.error() == 0 ? found.real_path() : std::nullopt;
  if (real) ways_->saw(folder, *real);
  std::vector<std::string> names;
  const bool is_inside = real && allowed_->holds(*real) && !is_denied(in_folder(folder));
  if (is_inside || (real && allowed_->files_in.contains(*real))) names = names_in(found);
  if (!is_inside || !(allowed_->everything || allowed_->is_whole(*real)))
    std::erase_if(names, [](const std::string& name) { return name[0] == '.'; });
  const std::lock_guard lock(mutex_);
  return lists_.emplace(folder, std::move(names)).first->second;
}

void MemoryFiles::add(const std::string& path, std::string text) {
  files_[path::normalize(path)] = std::move(text);
}

FileContent MemoryFiles::read(const std::string& path, std::uint64_t max_bytes) const {
  const auto found = files_.find(path::normalize(path));
  if (found == files_.end()) {
    if (behind_ != nullptr) return behind_->read(path, max_bytes);
    return {ReadStatus::not_found, {}, "No such file or directory"};
  }
  if (found->second.size() > max_bytes) {
    return {ReadStatus::too_large, {}, "has " + std::to_string(found->second.size()) + " bytes"};
  }
  return {ReadStatus::ok, found->second, {}};
}

bool MemoryFiles::is_file(const std::string& path) const {
  if (files_.contains(path::normalize(path))) return true;
  return behind_ != nullptr && behind_->is_file(path);
}

bool MemoryFiles::is_denied(const std::string& path) const {
  return behind_ != nullptr && !files_.contains(path::normalize(path)) && behind_->is_denied(path);
}

std::string MemoryFiles::identity(const std::string& path) const {
  return behind_ == nullptr ? path::normalize(path) : behind_->identity(path);
}

void MemoryFiles::rely_on_list(const std::string& folder, const std::string& digest) const {
  if (behind_ != nullptr) behind_->rely_on_list(folder, digest);
}

std::vector<std::string> MemoryFiles::list(const std::string& folder) const {
  std::vector<std::string> names;
  if (behind_ != nullptr) names = behind_->list(folder);
  const std::size_t behind = names.size();
  const std::string wanted = path::normalize(folder);
  const std::string prefix = wanted == "." ? "" : wanted == "/" ? wanted : wanted + "/";
  for (auto file = files_.lower_bound(prefix); file != files_.end(); ++file) {
    const std::string& path = file->first;
    if (!path.starts_with(prefix)) break;
    if (prefix.empty() && path::is_absolute(path)) continue;
    const std::string_view rest = std::string_view(path).substr(prefix.size());
    names.emplace_back(rest.substr(0, rest.find('/')));
  }
  if (names.size() == behind) return names;
  // The first part is sorted, and the second is short.
  const auto middle = names.begin() + static_cast<std::ptrdiff_t>(behind);
  std::sort(middle, names.end());
  std::inplace_merge(names.begin(), middle, names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace smurf
