// SPDX-License-Identifier: BSD-3-Clause
// read(2) into a buffer of the file's size: faster than streams and never blocks on a device.
#include "smurf/file_reader.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/canonical_paths.hpp"
#include "base/path.hpp"

namespace smurf {
namespace {

std::string error_text(int error) { return std::generic_category().message(error); }

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

FileContent DiskFiles::read(const std::string& path, std::uint64_t max_bytes) const {
  if (path.find('\0') != std::string::npos) return {ReadStatus::not_found, {}, "has a zero byte"};
  // O_NONBLOCK: opening a named pipe must not wait for a writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.number() < 0) {
    const bool missing = errno == ENOENT || errno == ENOTDIR;
    return {missing ? ReadStatus::not_found : ReadStatus::denied, {}, error_text(errno)};
  }
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) return {ReadStatus::denied, {}, error_text(errno)};
  if (S_ISDIR(status.st_mode)) return {ReadStatus::not_a_file, {}, "is a folder"};
  if (!S_ISREG(status.st_mode)) return {ReadStatus::not_a_file, {}, "is not a regular file"};
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > max_bytes)
    return {ReadStatus::too_large, {}, "has " + std::to_string(size) + " bytes"};

  FileContent content{ReadStatus::ok, {}, {}};
  content.text.resize(size);
  std::size_t filled = 0;
  while (filled < content.text.size()) {
    const ssize_t count =
        ::read(file.number(), content.text.data() + filled, content.text.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return {ReadStatus::denied, {}, error_text(errno)};
    if (count == 0) break;  // the file shrank meanwhile
    filled += static_cast<std::size_t>(count);
  }
  content.text.resize(filled);
  return content;
}

bool DiskFiles::is_file(const std::string& path) const {
  struct stat status {};
  return path.find('\0') == std::string::npos && ::stat(path.c_str(), &status) == 0 &&
         S_ISREG(status.st_mode);
}

std::vector<std::string> DiskFiles::list(const std::string& folder) const {
  std::vector<std::string> names;
  std::error_code error;
  std::filesystem::directory_iterator entries(folder.empty() ? "." : folder, error);
  for (; !error && entries != std::filesystem::directory_iterator(); entries.increment(error)) {
    names.push_back(entries->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

ConfinedFiles::ConfinedFiles() : canonical_(std::make_unique<CanonicalPaths>()) {}
ConfinedFiles::~ConfinedFiles() = default;

void ConfinedFiles::allow(const std::string& folder) {
  if (const auto canonical = canonical_->of(folder)) {
    folders_.push_back(path::normalize(*canonical + "/") + "/");
  }
}

bool ConfinedFiles::allows(const std::string& path) const {
  const auto canonical = canonical_->of(path);
  return canonical && std::ranges::any_of(folders_, [&](const std::string& folder) {
           return folder == "//" || (*canonical + "/").starts_with(folder);
         });
}

FileContent ConfinedFiles::read(const std::string& path, std::uint64_t max_bytes) const {
  if (!allows(path) && disk_.is_file(path)) {
    return {ReadStatus::denied, {}, "it lies outside of the project; --allow-outside reads it"};
  }
  return disk_.read(path, max_bytes);
}

std::vector<std::string> ConfinedFiles::list(const std::string& folder) const {
  return allows(folder) ? disk_.list(folder) : std::vector<std::string>{};
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

std::vector<std::string> MemoryFiles::list(const std::string& folder) const {
  std::vector<std::string> names;
  if (behind_ != nullptr) names = behind_->list(folder);
  const std::string wanted = path::normalize(folder);
  const std::string prefix = wanted == "." ? "" : wanted == "/" ? wanted : wanted + "/";
  for (auto file = files_.lower_bound(prefix); file != files_.end(); ++file) {
    const std::string& path = file->first;
    if (!path.starts_with(prefix)) break;
    if (prefix.empty() && path::is_absolute(path)) continue;
    const std::string_view rest = std::string_view(path).substr(prefix.size());
    names.emplace_back(rest.substr(0, rest.find('/')));
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace smurf
