// SPDX-License-Identifier: BSD-3-Clause
#include "common/cli/browser.hpp"

#include <cerrno>

#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "common/files/new_file.hpp"
#include "common/files/output.hpp"
#include "common/files/random_word.hpp"
#include "render/printable.hpp"

namespace smurf::tools {
namespace {

constexpr int kAttempts = 100;
constexpr std::size_t kRandomLetters = 10;

}  // namespace

std::string write_temporary_page(std::string_view tool, std::string_view stem,
                                 std::string_view text) {
  constexpr int kForUser = 0600;
  const std::string begin = temporary_folder() + "/" + render::safe_file_name(stem) + "-";
  int error = EEXIST;
  for (int attempt = 0; attempt < kAttempts && error == EEXIST; ++attempt) {
    const std::string path = begin + random_word(kRandomLetters) + ".html";
    const int flags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW;
    const Descriptor file(sys::open(path.c_str(), flags, kForUser));
    error = file.is_open() ? write_all(file.number(), text) : errno;
    if (file.is_open() && error == 0) return path;
    if (file.is_open()) sys::unlinkat(AT_FDCWD, path.c_str(), 0);
  }
  complain(tool, "cannot write a page into '" + temporary_folder() +
                     "': " + sys::error_text(error) + "; name another place with -o FILE");
  return {};
}

bool show_page(std::string_view tool, const std::string& target) {
  const bool is_address = target.starts_with("http://");
  const std::string whole = is_address ? target : places::whole(target).value_or(target);
  const std::string reason = open_for_user(std::string(sys::for_others(whole)));
  if (reason.empty()) return true;
  complain(tool, reason + "; open this in a browser: " + std::string(sys::for_others(whole)));
  return false;
}

}  // namespace smurf::tools
