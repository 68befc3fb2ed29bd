// SPDX-License-Identifier: BSD-3-Clause
#include <dirent.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#if defined(__linux__) && __has_include(<linux/openat2.h>)
#include <linux/openat2.h>
#include <sys/syscall.h>
#endif

#if defined(__linux__) && __has_include(<link.h>)
#include <link.h>
#define SMURF_HAS_BUILD_ID
#endif

#include "base/files/path.hpp"
#include "base/files/system.hpp"

namespace smurf::sys {
std::vector<std::string> names_in(int folder) {
  std::vector<std::string> names;
#ifdef __GLIBC__
  // opendir() makes three more calls of the system.
  if (folder < 0) return names;
  alignas(dirent64) std::array<char, 16384> entries;
  ssize_t size = 0;
  while ((size = ::getdents64(folder, entries.data(), entries.size())) > 0) {
    for (ssize_t at = 0; at < size;) {
      const auto* const entry = reinterpret_cast<const dirent64*>(entries.data() + at);
      const std::string_view name = entry->d_name;
      if (name != "." && name != "..") names.emplace_back(name);
      at += entry->d_reclen;
    }
  }
  ::close(folder);
  return names;
#else
  DIR* opened = folder < 0 ? nullptr : ::fdopendir(folder);
  if (opened == nullptr) return names;
  while (const dirent* entry = ::readdir(opened)) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
  ::closedir(opened);
  return names;
#endif
}

std::optional<std::string> real_path(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr),
                                                         &std::free);
  if (!real) return std::nullopt;
  return std::string(real.get());
}

int open_unlinked([[maybe_unused]] const std::string& path) {
#if defined(RESOLVE_NO_SYMLINKS) && defined(SYS_openat2)
  static std::atomic<bool> is_known = true;
  if (is_known) {
    open_how how{};
    how.flags = O_PATH | O_CLOEXEC;
    how.resolve = RESOLVE_NO_SYMLINKS;
    const long number = ::syscall(SYS_openat2, AT_FDCWD, path.c_str(), &how, sizeof how);
    if (number >= 0 || errno == ENOENT) return static_cast<int>(number);
    if (errno == ENOSYS) is_known = false;  // before Linux 5.6
  }
#endif
  errno = ELOOP;
  return -1;
}

std::string working_folder() {
  std::array<char, path::kLongest> place;
  const char* const found = ::getcwd(place.data(), place.size());
  return found != nullptr && *found == '/' ? found : "";
}

std::optional<std::string> place_of(int number) {
  const std::string link = "/proc/self/fd/" + std::to_string(number);
  std::array<char, path::kLongest> place;
  const ssize_t size = ::readlink(link.c_str(), place.data(), place.size());
  if (size < 0) return std::nullopt;
  return std::string(place.data(), static_cast<std::size_t>(size));
}

int adopt_owner(int number, const Status& other) {
  // The owner comes first, because the mode is meant for this owner. Only root may change it.
  const bool is_given = ::fchown(number, other.st_uid, other.st_gid) == 0;
  [[maybe_unused]] const bool is_kept =
      is_given || ::fchown(number, static_cast<uid_t>(-1), other.st_gid) == 0;
  return ::fchmod(number, other.st_mode & 0777U) == 0 ? 0 : errno;
}

bool is_running(int process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

std::string process_space() {
  std::error_code error;
  std::string space = std::filesystem::read_symlink("/proc/self/ns/pid", error).string();
  std::erase_if(space, [](char c) { return c < '0' || c > '9'; });  // of "pid:[4026531836]"
  char boot[8] = {};
  const int file = ::open("/proc/sys/kernel/random/boot_id", O_RDONLY | O_CLOEXEC);
  if (file >= 0) {
    if (::read(file, boot, sizeof boot) == sizeof boot) space.append("x").append(boot, sizeof boot);
    ::close(file);
  }
  return space.empty() ? "0" : space;
}

void wait_until_writable(int number) {
  pollfd ready{number, POLLOUT, 0};
  ::poll(&ready, 1, -1);
}

void allow_open_files(std::size_t count) {
  constexpr rlim_t kOthers = 64;
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= count + kOthers) return;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, count + kOthers);
  ::setrlimit(RLIMIT_NOFILE, &limit);  // a denial shows later, when a file is opened
}

std::string_view why_no_name(std::string_view /*name*/) { return {}; }
std::string from_user(std::string_view path) { return std::string(path); }
std::string_view for_others(std::string_view path) { return path; }
bool is_named_so(const std::string& /*path*/) { return true; }
std::string_view without_drive(std::string_view path) { return path; }
#ifdef __EMSCRIPTEN__
// A module of WebAssembly gets no signals.
HeldSignals::HeldSignals() = default;
HeldSignals::~HeldSignals() = default;
bool HeldSignals::has_one() const { return held_ != 0; }
#else
namespace {

constexpr std::array kEndings{SIGINT, SIGTERM, SIGHUP};

sigset_t set_of(unsigned bits) {
  sigset_t set{};
  ::sigemptyset(&set);
  for (std::size_t i = 0; i < kEndings.size(); ++i) {
    if ((bits >> i & 1U) != 0) ::sigaddset(&set, kEndings.at(i));
  }
  return set;
}

}  // namespace

HeldSignals::HeldSignals() {
  const sigset_t all = set_of(~0U);
  sigset_t before{};
  if (::pthread_sigmask(SIG_BLOCK, &all, &before) != 0) return;
  for (std::size_t i = 0; i < kEndings.size(); ++i) {
    if (::sigismember(&before, kEndings.at(i)) == 0) held_ |= 1U << i;
  }
}

HeldSignals::~HeldSignals() {
  const sigset_t held = set_of(held_);
  ::pthread_sigmask(SIG_UNBLOCK, &held, nullptr);
}

bool HeldSignals::has_one() const {
  sigset_t waiting{};
  ::sigpending(&waiting);
  for (std::size_t i = 0; i < kEndings.size(); ++i) {
    if ((held_ >> i & 1U) != 0 && ::sigismember(&waiting, kEndings.at(i)) == 1) return true;
  }
  return false;
}
#endif

double thread_seconds() {
  timespec now{};
  if (::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

#ifdef SMURF_HAS_BUILD_ID
namespace {

/// The number that the linker gives each build (--build-id), which is in a note of it.
std::string build_id_of(const dl_phdr_info& info) {
  for (std::size_t i = 0; i < info.dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = info.dlpi_phdr[i];
    if (part.p_type != PT_NOTE) continue;
    std::string_view notes(reinterpret_cast<const char*>(info.dlpi_addr + part.p_vaddr),
                           part.p_memsz);
    ElfW(Nhdr) note;
    while (notes.size() >= sizeof note) {
      std::memcpy(&note, notes.data(), sizeof note);
      const auto aligned = [](std::size_t size) { return (size + 3) / 4 * 4; };
      const std::size_t text = sizeof note + aligned(note.n_namesz);
      const std::size_t end = text + aligned(note.n_descsz);
      if (end > notes.size()) break;
      const bool is_of_gnu =
          notes.substr(sizeof note, note.n_namesz) == std::string_view("GNU\0", 4);
      if (note.n_type == NT_GNU_BUILD_ID && is_of_gnu) {
        return std::string(notes.substr(text, note.n_descsz));
      }
      notes.remove_prefix(end);
    }
  }
  return {};
}

struct SearchedCode {
  ElfW(Addr) address = 0;
  std::string build_id;
};

int look_for_code(dl_phdr_info* info, std::size_t /*size*/, void* data) {
  auto& searched = *static_cast<SearchedCode*>(data);
  for (std::size_t i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = info->dlpi_phdr[i];
    const ElfW(Addr) begin = info->dlpi_addr + part.p_vaddr;
    if (part.p_type != PT_LOAD || searched.address - begin >= part.p_memsz) continue;
    searched.build_id = build_id_of(*info);
    return 1;
  }
  return 0;
}

}  // namespace

std::string program_identity() {
  SearchedCode searched{reinterpret_cast<ElfW(Addr)>(&look_for_code), {}};
  ::dl_iterate_phdr(look_for_code, &searched);
  return searched.build_id;
}
#else
std::string program_identity() { return {}; }
#endif

const char* home() { return std::getenv("HOME"); }

}  // namespace smurf::sys
