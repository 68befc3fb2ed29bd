// SPDX-License-Identifier: BSD-3-Clause
// Defines the calls of base/files/system.hpp with functions of Windows. All paths go through
// to_windows().
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <mutex>

#include "base/files/path.hpp"
#include "base/files/system.hpp"
#include "base/files/windows_paths.hpp"
// The headers of Windows come last, because they define many macros.
#include <windows.h>
#include <winioctl.h>

namespace smurf::sys {
namespace {

constexpr int kFirst = 3;  // after the standard streams
constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

struct Opened {
  HANDLE handle = INVALID_HANDLE_VALUE;
  std::string place;
};

struct Table {
  std::mutex mutex;
  std::vector<Opened> opened;
};

Table& table() {
  static Table all;
  return all;
}

int error_of(DWORD error) {
  switch (error) {
  case ERROR_FILE_NOT_FOUND:
  case ERROR_PATH_NOT_FOUND:
  case ERROR_INVALID_NAME:
  case ERROR_BAD_NETPATH:
  case ERROR_BAD_NET_NAME:
  case ERROR_INVALID_DRIVE:
  case ERROR_NOT_READY: return ENOENT;
  case ERROR_ALREADY_EXISTS:
  case ERROR_FILE_EXISTS: return EEXIST;
  case ERROR_DIR_NOT_EMPTY: return ENOTEMPTY;
  case ERROR_DIRECTORY: return ENOTDIR;
  case ERROR_DISK_FULL:
  case ERROR_HANDLE_DISK_FULL: return ENOSPC;
  case ERROR_WRITE_PROTECT: return EROFS;
  case ERROR_BROKEN_PIPE:
  case ERROR_NO_DATA: return EPIPE;
  case ERROR_FILENAME_EXCED_RANGE: return ENAMETOOLONG;
  case ERROR_CANT_RESOLVE_FILENAME: return ELOOP;
  case ERROR_INVALID_HANDLE: return EBADF;
  case ERROR_NOT_SAME_DEVICE: return EXDEV;
  case ERROR_NOT_ENOUGH_MEMORY: return ENOMEM;
  default: return EACCES;
  }
}

int fail(int error) {
  errno = error;
  return -1;
}

int fail_as_windows() { return fail(error_of(::GetLastError())); }

int result_of(BOOL is_done) { return is_done != 0 ? 0 : fail_as_windows(); }

HANDLE handle_of(int number) {
  constexpr std::array<DWORD, 3> kStandard = {STD_INPUT_HANDLE, STD_OUTPUT_HANDLE,
                                              STD_ERROR_HANDLE};
  if (number < 0) return INVALID_HANDLE_VALUE;
  if (number < kFirst) return ::GetStdHandle(kStandard[static_cast<std::size_t>(number)]);
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  const auto index = static_cast<std::size_t>(number - kFirst);
  return index < all.opened.size() ? all.opened[index].handle : INVALID_HANDLE_VALUE;
}

int keep(HANDLE handle, std::string place) {
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  auto free = std::find_if(all.opened.begin(), all.opened.end(),
                           [](const Opened& one) { return one.handle == INVALID_HANDLE_VALUE; });
  if (free == all.opened.end()) free = all.opened.insert(free, Opened{});
  *free = {handle, std::move(place)};
  return kFirst + static_cast<int>(free - all.opened.begin());
}

/// The path of a name in an open folder.
std::string in_folder(int folder, const char* name) {
  if (folder == AT_FDCWD || *name == '/') return name;
  const auto place = place_of(folder);
  return place ? path::join(*place, name) : std::string();
}

/// Opens a file, a folder, or a link itself.
HANDLE open_handle(const std::wstring& name, DWORD access, DWORD how, bool follows) {
  const DWORD flags =
      FILE_FLAG_BACKUP_SEMANTICS | (follows ? 0U : DWORD{FILE_FLAG_OPEN_REPARSE_POINT});
  return ::CreateFileW(name.c_str(), access, kShared, nullptr, how, flags, nullptr);
}

bool is_link(HANDLE handle) {
  FILE_ATTRIBUTE_TAG_INFO info{};
  return ::GetFileInformationByHandleEx(handle, FileAttributeTagInfo, &info, sizeof(info)) != 0 &&
         (info.FileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 &&
         (info.ReparseTag == IO_REPARSE_TAG_SYMLINK ||
          info.ReparseTag == IO_REPARSE_TAG_MOUNT_POINT);
}

std::uint64_t joined(DWORD high, DWORD low) { return (std::uint64_t{high} << 32U) | low; }

::timespec time_of(const FILETIME& time) {
  constexpr std::int64_t kPerSecond = 10'000'000;
  constexpr std::int64_t kBefore1970 = 11'644'473'600;  // s, from 1601 on
  const auto ticks = static_cast<std::int64_t>(joined(time.dwHighDateTime, time.dwLowDateTime));
  return {ticks / kPerSecond - kBefore1970, static_cast<long>(ticks % kPerSecond * 100)};
}

int status_of(HANDLE handle, Status* status) {
  *status = {};
  const DWORD type = ::GetFileType(handle);
  if (type != FILE_TYPE_DISK) {
    if (type == FILE_TYPE_UNKNOWN) return fail(EBADF);
    status->st_mode = type == FILE_TYPE_PIPE ? S_IFIFO : S_IFCHR;
    return 0;
  }
  BY_HANDLE_FILE_INFORMATION info{};
  if (::GetFileInformationByHandle(handle, &info) == 0) return fail_as_windows();
  const bool is_folder = (info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  status->st_mode = is_link(handle) ? S_IFLNK : is_folder ? S_IFDIR : S_IFREG;
  status->st_dev = info.dwVolumeSerialNumber;
  status->st_ino = joined(info.nFileIndexHigh, info.nFileIndexLow);
  status->st_nlink = info.nNumberOfLinks;
  status->st_size = static_cast<std::int64_t>(joined(info.nFileSizeHigh, info.nFileSizeLow));
  status->st_mtim = time_of(info.ftLastWriteTime);
  status->st_ctim = time_of(info.ftLastWriteTime);
  return 0;
}

int status_at(const std::string& path, Status* status, bool follows) {
  const auto name = to_windows(path);
  if (!name) return -1;
  const HANDLE handle = open_handle(*name, FILE_READ_ATTRIBUTES, OPEN_EXISTING, follows);
  if (handle == INVALID_HANDLE_VALUE) return fail_as_windows();
  const int result = status_of(handle, status);
  ::CloseHandle(handle);
  if (result == 0 && path.ends_with('/') && !S_ISDIR(status->st_mode)) return fail(ENOTDIR);
  return result;
}

std::string place_of_handle(HANDLE handle) {
  std::wstring place(::GetFinalPathNameByHandleW(handle, nullptr, 0, FILE_NAME_NORMALIZED), L'\0');
  if (place.empty()) return {};
  const DWORD size = ::GetFinalPathNameByHandleW(
      handle, place.data(), static_cast<DWORD>(place.size()), FILE_NAME_NORMALIZED);
  if (size == 0 || size >= place.size() + 1) return {};
  place.resize(size);
  return from_windows(place);
}

int open_at(const std::string& path, int flags) {
  const auto name = to_windows(path);
  if (!name) return -1;
  const bool is_folder = (flags & O_DIRECTORY) != 0;
  const bool is_new = (flags & O_CREAT) != 0;
  DWORD access = (flags & O_WRONLY) != 0 ? GENERIC_WRITE | FILE_READ_ATTRIBUTES : GENERIC_READ;
  if ((flags & O_RDWR) != 0) access = GENERIC_READ | GENERIC_WRITE;
  if (is_folder) access = FILE_LIST_DIRECTORY | FILE_READ_ATTRIBUTES;
  const bool follows = (flags & O_NOFOLLOW) == 0;
  HANDLE handle = open_handle(*name, access, is_new ? CREATE_NEW : OPEN_EXISTING, follows);
  if (handle == INVALID_HANDLE_VALUE) return fail_as_windows();
  Status status;
  int error = status_of(handle, &status) != 0 ? errno : 0;
  if (error == 0 && S_ISLNK(status.st_mode)) error = ELOOP;
  if (error == 0 && is_folder && !S_ISDIR(status.st_mode)) error = ENOTDIR;
  if (error != 0) {
    ::CloseHandle(handle);
    return fail(error);
  }
  if (path == "/") return keep(handle, path);  // the folder of all drives
  std::string place = place_of_handle(handle);
  return keep(handle, place.empty() ? with_drive(path) : std::move(place));
}

/// The data of a link, which the headers of Windows for programs do not declare.
struct LinkData {
  ULONG tag;
  USHORT length, reserved;
  USHORT target_at, target_size, shown_at, shown_size;
};

std::string target_in(const std::vector<char>& data) {
  LinkData link{};
  std::memcpy(&link, data.data(), sizeof(link));
  constexpr std::size_t kFlags = 4;  // a symbolic link has these bytes before its names
  const std::size_t names = sizeof(link) + (link.tag == IO_REPARSE_TAG_SYMLINK ? kFlags : 0);
  if (names + link.target_at + link.target_size > data.size()) return {};
  std::wstring target(link.target_size / sizeof(wchar_t), L'\0');
  std::memcpy(target.data(), data.data() + names + link.target_at, link.target_size);
  constexpr std::wstring_view kOfKernel = L"\\??\\";
  if (target.starts_with(kOfKernel)) target.replace(0, kOfKernel.size(), L"\\\\?\\");
  return from_windows(target);
}

DWORD to_size(std::size_t size) {
  return static_cast<DWORD>(std::min<std::size_t>(size, std::size_t{1} << 30U));
}

}  // namespace

int close(int number) {
  if (number < kFirst) return 0;
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  Opened& one = all.opened.at(static_cast<std::size_t>(number - kFirst));
  ::CloseHandle(one.handle);
  one = {};
  return 0;
}

int open(const char* path, int flags, int /*mode*/) { return open_at(path, flags); }

int openat(int folder, const char* name, int flags, int /*mode*/) {
  return open_at(in_folder(folder, name), flags);
}

int stat(const char* path, Status* status) { return status_at(path, status, true); }
int lstat(const char* path, Status* status) { return status_at(path, status, false); }
int fstat(int number, Status* status) { return status_of(handle_of(number), status); }

int fstatat(int folder, const char* name, Status* status, int flags) {
  return status_at(in_folder(folder, name), status, (flags & AT_SYMLINK_NOFOLLOW) == 0);
}

ssize_t readlinkat(int folder, const char* name, char* target, std::size_t size) {
  const auto link = to_windows(in_folder(folder, name));
  if (!link) return -1;
  const DWORD attributes = ::GetFileAttributesW(link->c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES) return fail_as_windows();
  if ((attributes & FILE_ATTRIBUTE_REPARSE_POINT) == 0) return fail(EINVAL);
  const HANDLE handle = open_handle(*link, FILE_READ_ATTRIBUTES, OPEN_EXISTING, false);
  if (handle == INVALID_HANDLE_VALUE) return fail_as_windows();
  std::vector<char> data(MAXIMUM_REPARSE_DATA_BUFFER_SIZE);
  DWORD got = 0;
  const bool is_read =
      is_link(handle) && ::DeviceIoControl(handle, FSCTL_GET_REPARSE_POINT, nullptr, 0, data.data(),
                                           to_size(data.size()), &got, nullptr) != 0;
  ::CloseHandle(handle);
  if (!is_read || got < sizeof(LinkData)) return fail(EINVAL);
  data.resize(got);
  const std::string text = target_in(data);
  const std::size_t count = std::min(size, text.size());
  std::memcpy(target, text.data(), count);
  return static_cast<ssize_t>(count);
}

ssize_t read(int number, void* to, std::size_t size) {
  DWORD count = 0;
  if (::ReadFile(handle_of(number), to, to_size(size), &count, nullptr) != 0) return count;
  const DWORD error = ::GetLastError();  // the other end of a pipe is closed
  return error == ERROR_BROKEN_PIPE || error == ERROR_HANDLE_EOF ? 0 : fail(error_of(error));
}

ssize_t pread(int number, void* to, std::size_t size, off_t at) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(at);
  DWORD count = 0;
  if (::ReadFile(handle_of(number), to, to_size(size), &count, &place) != 0) return count;
  return ::GetLastError() == ERROR_HANDLE_EOF ? 0 : fail_as_windows();
}

ssize_t write(int number, const void* from, std::size_t size) {
  DWORD count = 0;
  const BOOL is_done = ::WriteFile(handle_of(number), from, to_size(size), &count, nullptr);
  return is_done != 0 ? static_cast<ssize_t>(count) : fail_as_windows();
}

int ftruncate(int number, off_t size) {
  LARGE_INTEGER end{};
  end.QuadPart = size;
  const HANDLE handle = handle_of(number);
  return result_of(
      ::SetFilePointerEx(handle, end, nullptr, FILE_BEGIN) != 0 ? ::SetEndOfFile(handle) : FALSE);
}

int fsync(int number) { return result_of(::FlushFileBuffers(handle_of(number))); }

int linkat(int folder, const char* name, int other_folder, const char* other_name, int /*flags*/) {
  const auto from = to_windows(in_folder(folder, name));
  const auto to = from ? to_windows(in_folder(other_folder, other_name)) : std::nullopt;
  return to ? result_of(::CreateHardLinkW(to->c_str(), from->c_str(), nullptr)) : -1;
}

int renameat(int folder, const char* name, int other_folder, const char* other_name) {
  const auto from = to_windows(in_folder(folder, name));
  const auto to = from ? to_windows(in_folder(other_folder, other_name)) : std::nullopt;
  constexpr DWORD kHow = MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH;
  return to ? result_of(::MoveFileExW(from->c_str(), to->c_str(), kHow)) : -1;
}

int unlinkat(int folder, const char* name, int flags) {
  const auto path = to_windows(in_folder(folder, name));
  if (!path) return -1;
  return result_of((flags & AT_REMOVEDIR) != 0 ? ::RemoveDirectoryW(path->c_str())
                                               : ::DeleteFileW(path->c_str()));
}

int mkdirat(int folder, const char* name, int /*mode*/) {
  const auto path = to_windows(in_folder(folder, name));
  return path ? result_of(::CreateDirectoryW(path->c_str(), nullptr)) : -1;
}

int mkdir(const char* path, int mode) { return mkdirat(AT_FDCWD, path, mode); }

bool is_running(int process) {
  const HANDLE opened =
      ::OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, static_cast<DWORD>(process));
  if (opened == nullptr) return ::GetLastError() != ERROR_INVALID_PARAMETER;
  DWORD code = 0;
  const bool is_known = ::GetExitCodeProcess(opened, &code) != 0;
  ::CloseHandle(opened);
  return !is_known || code == STILL_ACTIVE;
}

std::string process_space() { return "0"; }

int getpid() { return static_cast<int>(::GetCurrentProcessId()); }

std::vector<std::string> names_in(int folder) {
  std::vector<std::string> names;
  const auto pattern = place_of(folder);
  auto name = pattern ? to_windows(*pattern) : std::nullopt;
  if (folder >= 0) close(folder);
  if (!name) return names;
  if (!name->ends_with(L'\\')) *name += L'\\';
  WIN32_FIND_DATAW entry{};
  const HANDLE search = ::FindFirstFileExW((*name + L"*").c_str(), FindExInfoBasic, &entry,
                                           FindExSearchNameMatch, nullptr, 0);
  if (search == INVALID_HANDLE_VALUE) return names;
  do {
    std::string one = to_utf8(entry.cFileName);
    if (one != "." && one != "..") names.push_back(std::move(one));
  } while (::FindNextFileW(search, &entry) != 0);
  ::FindClose(search);
  return names;
}

std::optional<std::string> real_path(const std::string& path) {
  const auto name = to_windows(path);
  if (!name) return std::nullopt;
  const HANDLE handle = open_handle(*name, FILE_READ_ATTRIBUTES, OPEN_EXISTING, true);
  if (handle == INVALID_HANDLE_VALUE) return std::nullopt;
  std::string place = place_of_handle(handle);
  ::CloseHandle(handle);
  return place.empty() ? std::nullopt : std::optional(std::move(place));
}

int open_unlinked(const std::string& /*path*/) { return fail(ELOOP); }
std::string working_folder() { return {}; }

std::optional<std::string> place_of(int number) {
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  const auto index = static_cast<std::size_t>(number - kFirst);
  if (number < kFirst || index >= all.opened.size()) return std::nullopt;
  return all.opened[index].place;
}

// A new file gets its owner and rights from its folder, so there is nothing to copy.
int adopt_owner(int /*number*/, const Status& /*other*/) { return 0; }
void wait_until_writable(int /*number*/) {}
void allow_open_files(std::size_t /*count*/) {}

HeldSignals::HeldSignals() = default;
HeldSignals::~HeldSignals() = default;
bool HeldSignals::has_one() const { return held_ != 0; }

double thread_seconds() {
  FILETIME start{}, end{}, kernel{}, user{};
  if (::GetThreadTimes(::GetCurrentThread(), &start, &end, &kernel, &user) == 0) {
    return 1e-3 * static_cast<double>(::GetTickCount64());
  }
  const auto seconds = [](const FILETIME& time) {
    constexpr double kHigh = 4294967296;
    return 1e-7 * (kHigh * time.dwHighDateTime + time.dwLowDateTime);
  };
  return seconds(kernel) + seconds(user);
}

// The modules of Python are not built for Windows: the code is that of the program.
std::string program_identity() {
  std::wstring name(path::kLongest, L'\0');
  const DWORD size = ::GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
  name.resize(size);
  Status status{};
  if (size == 0 || stat(from_windows(name).c_str(), &status) != 0) return {};
  return std::to_string(status.st_size) + " " + std::to_string(status.st_mtim.tv_sec) + "." +
         std::to_string(status.st_mtim.tv_nsec) + " " + std::to_string(status.st_ino);
}

const char* home() {
  static const std::string folder = [] {
    const wchar_t* variable = ::_wgetenv(L"USERPROFILE");
    return variable == nullptr ? std::string() : from_windows(variable);
  }();
  return folder.c_str();
}

}  // namespace smurf::sys
