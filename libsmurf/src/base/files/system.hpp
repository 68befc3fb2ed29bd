// SPDX-License-Identifier: BSD-3-Clause
// The calls of POSIX that open, name and replace files. Only system*.cpp include the headers of a
// system. For Windows, system_windows.cpp defines them. A drive is a folder in the root there, as
// in "/C:/robots/arm.urdf", so that paths have one form on every system.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#ifndef _WIN32
#include <unistd.h>
#endif

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#ifdef _WIN32
// NOLINTBEGIN(cppcoreguidelines-macro-usage): the names of POSIX
#define O_CLOEXEC 0
#define O_NOCTTY 0
#define O_NONBLOCK 0
#define O_DIRECTORY 0x01000000
#define O_NOFOLLOW 0x02000000
#define AT_FDCWD (-100)
#define AT_SYMLINK_NOFOLLOW 0x100
#define AT_REMOVEDIR 0x200
#define AT_SYMLINK_FOLLOW 0x400
#define ESTALE ENOENT
#define S_IFLNK 0xA000
#define S_ISLNK(mode) (((mode)&S_IFMT) == S_IFLNK)
// NOLINTEND(cppcoreguidelines-macro-usage)
#endif

namespace smurf::sys {

#ifdef _WIN32
/// Whether the file system ignores case: "a.stl" and "A.stl" are then one file.
inline constexpr bool kIgnoresCase = true;
inline constexpr char kListSeparator = ';';

struct Status {
  std::uint64_t st_dev = 0;
  std::uint64_t st_ino = 0;
  unsigned st_mode = 0;
  std::uint64_t st_nlink = 0;
  std::int64_t st_size = 0;
  ::timespec st_mtim{};
  ::timespec st_ctim{};
};

int close(int number);
int open(const char* path, int flags, int mode = 0);
int openat(int folder, const char* name, int flags, int mode = 0);
int stat(const char* path, Status* status);
int lstat(const char* path, Status* status);
int fstat(int number, Status* status);
int fstatat(int folder, const char* name, Status* status, int flags);
ssize_t readlinkat(int folder, const char* name, char* target, std::size_t size);
ssize_t read(int number, void* to, std::size_t size);
ssize_t pread(int number, void* to, std::size_t size, off_t at);
ssize_t write(int number, const void* from, std::size_t size);
int fsync(int number);
/// What is written then follows.
int ftruncate(int number, off_t size);
int linkat(int folder, const char* name, int other_folder, const char* other_name, int flags);
int renameat(int folder, const char* name, int other_folder, const char* other_name);
int unlinkat(int folder, const char* name, int flags);
int mkdirat(int folder, const char* name, int mode);
int mkdir(const char* path, int mode);
int getpid();
#else
inline constexpr bool kIgnoresCase = false;
inline constexpr char kListSeparator = ':';

using Status = struct ::stat;
using ::close;
using ::fstat;
using ::fstatat;
using ::fsync;
using ::ftruncate;
using ::getpid;
using ::linkat;
using ::lstat;
using ::mkdir;
using ::mkdirat;
using ::open;
using ::openat;
using ::pread;
using ::read;
using ::readlinkat;
using ::renameat;
using ::stat;
using ::unlinkat;
using ::write;
#endif

/// The names in an open folder, without "." and "..", unsorted. Closes the folder.
std::vector<std::string> names_in(int folder);

/// The path with all links followed; none if it does not exist.
std::optional<std::string> real_path(const std::string& path);

/// Opens a file or folder for questions about it (O_PATH), if no name on the way to it is a link:
/// its path without links is then known, and need not be asked for. -1 with errno, which is ELOOP
/// where there is a link, and where the system cannot tell.
int open_unlinked(const std::string& path);

/// The path of the current folder, without links; "" if it is unknown.
std::string working_folder();

/// The path of an open file or folder, if the system provides it.
std::optional<std::string> place_of(int number);

/// Gives an open file the permissions and, as far as allowed, the owner and the group of another
/// one, but not the setuid, setgid and sticky bits. 0 or an errno.
int adopt_owner(int number, const Status& other);

/// Whether there may be a process with this number.
bool is_running(int process);

/// Letters and digits that name the numbering of processes: containers and machines, which may
/// share a folder, number their processes independently.
std::string process_space();

/// Waits until a terminal or pipe that someone made non-blocking accepts more.
void wait_until_writable(int number);

/// By default a program of POSIX may have 1,024 open files; it may raise that limit itself.
void allow_open_files(std::size_t count);

/// Holds back SIGINT, SIGTERM and SIGHUP, which end a program from outside, as long as the object
/// lives: files that are half written can then be removed. Nothing on Windows.
class HeldSignals {
 public:
  HeldSignals();
  /// Lets through what was held back, which ends the program.
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// Whether one of them waits.
  bool has_one() const;

 private:
  unsigned held_ = 0;  ///< a bit for each signal that was not held back before
};

/// The processor time that this thread has used, in seconds; where the system does not count it,
/// the time of a clock that never goes back.
double thread_seconds();

/// A text that is another one for each build of the program or module that has this code; "" if
/// this cannot be told.
std::string program_identity();

/// The reason for a value of errno.
std::string error_text(int error);

/// The reason why no file of this system can have the name; "" if one can.
std::string_view why_no_name(std::string_view name);

/// Converts a path from a person or a variable: "C:\robots" becomes "/C:/robots" on Windows.
std::string from_user(std::string_view path);

/// Converts a path for other programs: "C:/robots" on Windows.
std::string_view for_others(std::string_view path);

/// Whether every name of the path is written as the file system has it. Windows finds a file by
/// names in another case, but other systems do not find it, so this is reported.
bool is_named_so(const std::string& path);

/// The path without the drive: "/robots" for "/C:/robots"; unchanged on other systems.
std::string_view without_drive(std::string_view path);

/// The environment variable with the user's folder.
const char* home();

}  // namespace smurf::sys
