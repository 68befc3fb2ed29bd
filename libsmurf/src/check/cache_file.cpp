// SPDX-License-Identifier: BSD-3-Clause
#include "check/cache_file.hpp"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <utility>

#include "base/files/path.hpp"
#include "base/files/system.hpp"

namespace smurf {
namespace {

constexpr std::string_view kHeader = "smurf-lint cache 1\n";
constexpr std::size_t kKeyDigits = 32;
constexpr std::size_t kStart = 2 * kKeyDigits + 2;  // bytes of a line before its text
constexpr std::uint32_t kLongestLine = 64U << 20U;
constexpr std::uint64_t kFewBytes = 4U << 20U;  // not worth to be made shorter
constexpr int kSafely = O_CLOEXEC | O_NOCTTY | O_NONBLOCK | O_NOFOLLOW;

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

template <class Key>
bool read_key(std::string_view digits, Key& key) {
  for (std::size_t i = 0; i < key.size(); ++i) {
    const int high = digit_of(digits[2 * i]), low = digit_of(digits[2 * i + 1]);
    if (high < 0 || low < 0) return false;
    key[i] = static_cast<std::uint8_t>(high * 16 + low);
  }
  return true;
}

/// The second part of a line, which a damaged one does not have.
std::string check_of(std::string_view key, std::string_view text) {
  return short_digest(std::string(key) + std::string(text));
}

bool write_whole(int number, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = sys::write(number, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// Makes a folder and those above it. 0 or an errno.
int make_folder(const std::string& folder) {
  for (std::size_t end = folder.find('/', 1); end < folder.size();
       end = folder.find('/', end + 1)) {
    sys::mkdir(folder.substr(0, end).c_str(), 0777);
  }
  if (sys::mkdir(folder.c_str(), 0777) != 0) return errno == EEXIST ? 0 : errno;
  // Repositories and searches for robots leave it out.
  const std::string ignore = path::join(folder, ".gitignore");
  const Descriptor file(sys::open(ignore.c_str(), O_WRONLY | O_CREAT | O_EXCL | kSafely, 0666));
  if (file.number() >= 0) write_whole(file.number(), "*\n");
  return 0;
}

}  // namespace

CacheFile::CacheFile(const std::string& folder, const std::string& name)
    : path_(path::join(folder, name)) {
  if (const int error = make_folder(folder); error != 0) {
    fail(error);
    return;
  }
  open();
  if (read_ && !read_lines()) {
    read_.reset();
    write_.reset();
    lines_.clear();
    problem_ = "'" + path_ + "' is no file of a cache; delete it, or name another folder";
    return;
  }
  keep_last_lines();
  const std::uint64_t unused = bytes_ - line_bytes_;
  if (write_ && unused > kFewBytes && unused > line_bytes_) compact();
}

void CacheFile::fail(int error) {
  problem_ = "cannot write '" + path_ + "': " + sys::error_text(error);
  write_.reset();
}

void CacheFile::open() {
  constexpr int kAdds = O_WRONLY | O_APPEND | O_CREAT | kSafely;
  write_.emplace(sys::open(path_.c_str(), kAdds, 0666));
  if (write_->number() < 0) fail(errno);
  read_.emplace(sys::open(path_.c_str(), O_RDONLY | kSafely));
  if (read_->number() < 0) read_.reset();
}

bool CacheFile::read_lines() {
  sys::Status status{};
  if (sys::fstat(read_->number(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
  std::string buffer(1U << 20U, '\0'), start;
  std::uint64_t begin = 0;  // of the line
  bool is_cache = true;
  const auto take_line = [&](std::uint64_t end) {
    Line line{
        {}, begin, static_cast<std::uint32_t>(std::min<std::uint64_t>(end - begin, kLongestLine))};
    if (begin == 0) {
      is_cache = !start.empty() && kHeader.starts_with(start);  // or its start, after a full disk
    } else if (line.size > kStart && line.size < kLongestLine && read_key(start, line.key)) {
      lines_.push_back(line);
    }
  };
  for (ssize_t count = 0;
       is_cache && (count = sys::pread(read_->number(), buffer.data(), buffer.size(),
                                       static_cast<off_t>(bytes_))) > 0;) {
    std::string_view left(buffer.data(), static_cast<std::size_t>(count));
    while (!left.empty()) {
      const std::size_t end = std::min(left.find('\n'), left.size());
      start += left.substr(0, std::min(end, kStart - start.size()));
      bytes_ += end;
      left.remove_prefix(end);
      if (left.empty()) break;
      take_line(bytes_);
      start.clear();
      left.remove_prefix(1);
      begin = ++bytes_;
    }
  }
  is_cut_ = begin != bytes_;
  if (bytes_ == 0) return !write_ || write_whole(write_->number(), kHeader);
  return is_cache && (begin > 0 || kHeader.starts_with(start));
}

void CacheFile::keep_last_lines() {
  std::stable_sort(lines_.begin(), lines_.end(),
                   [](const Line& a, const Line& b) { return a.key < b.key; });
  std::vector<Line> last;
  for (const Line& line : lines_) {
    if (!last.empty() && last.back().key == line.key) last.pop_back();
    last.push_back(line);
  }
  lines_ = std::move(last);
  line_bytes_ = 0;
  for (const Line& line : lines_) line_bytes_ += line.size + 1;
}

/// Writes the lines that can be found to a new file, which takes the place of this one.
void CacheFile::compact() {
  const std::string name = path_ + ".new";
  sys::Status status{};
  constexpr std::time_t kKilled = 3600;  // s
  if (sys::lstat(name.c_str(), &status) == 0 &&
      std::time(nullptr) - status.st_mtim.tv_sec > kKilled) {
    sys::unlinkat(AT_FDCWD, name.c_str(), 0);
  }
  std::optional<Descriptor> to(
      std::in_place, sys::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | kSafely, 0666));
  if (to->number() < 0) return;  // another process does so
  bool is_written = write_whole(to->number(), kHeader);
  std::vector<Line> by_place = lines_;
  std::sort(by_place.begin(), by_place.end(),
            [](const Line& a, const Line& b) { return a.begin < b.begin; });
  for (auto line = by_place.begin(); is_written && line != by_place.end(); ++line) {
    is_written = write_whole(to->number(), text_of(*line) + '\n');
  }
  to.reset();
  read_.reset();
  write_.reset();
  if (!is_written || sys::renameat(AT_FDCWD, name.c_str(), AT_FDCWD, path_.c_str()) != 0) {
    sys::unlinkat(AT_FDCWD, name.c_str(), 0);
  }
  open();
  lines_.clear();
  bytes_ = 0;
  if (read_ && read_lines()) keep_last_lines();
}

std::string CacheFile::text_of(const Line& line) const {
  std::string text(line.size, '\0');
  std::size_t filled = 0;
  while (read_ && filled < text.size()) {
    const ssize_t count = sys::pread(read_->number(), text.data() + filled, text.size() - filled,
                                     static_cast<off_t>(line.begin + filled));
    if (count <= 0) break;
    filled += static_cast<std::size_t>(count);
  }
  text.resize(filled);
  return text;
}

std::optional<std::string> CacheFile::find(const Digest& digest) const {
  Line wanted;
  std::copy_n(digest.begin(), wanted.key.size(), wanted.key.begin());
  const auto found = std::lower_bound(lines_.begin(), lines_.end(), wanted,
                                      [](const Line& a, const Line& b) { return a.key < b.key; });
  if (found == lines_.end() || found->key != wanted.key) return std::nullopt;
  const std::string line = text_of(*found);
  if (line.size() <= kStart) return std::nullopt;
  const std::string_view key = std::string_view(line).substr(0, kKeyDigits);
  const std::string_view text = std::string_view(line).substr(kStart);
  if (line.substr(kKeyDigits + 1, kKeyDigits) != check_of(key, text)) return std::nullopt;
  return std::string(text);
}

void CacheFile::add(const Digest& digest, std::string_view text) {
  const std::string key = hex_of(digest, kKeyDigits / 2);
  const std::string line = key + ' ' + check_of(key, text) + ' ' + std::string(text) + '\n';
  if (line.size() > kLongestLine) return;
  const std::lock_guard lock(mutex_);
  if (!write_) return;
  const bool is_written = write_whole(write_->number(), is_cut_ ? '\n' + line : line);
  is_cut_ = false;
  if (!is_written) fail(errno);
}

std::string CacheFile::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

}  // namespace smurf
