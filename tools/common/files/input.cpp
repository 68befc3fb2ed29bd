// SPDX-License-Identifier: BSD-3-Clause
#include "common/files/input.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "base/findings/limits.hpp"
#include "common/files/output.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/found_inputs.hpp"
#include "smurf/source.hpp"

namespace smurf::tools {
namespace {

/// 0 or an errno; EFBIG above `most` bytes.
int read_all(std::string& text, std::uint64_t most) {
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = sys::read(0, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    if (count == 0) return 0;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    if (text.size() > most) return EFBIG;
  }
}

}  // namespace

std::optional<std::string> read_standard_input(std::string_view tool, const std::string& filename,
                                               const Limits& limits, MemoryFiles& files) {
  std::string text;
  if (const int error = read_all(text, limits.file_bytes); error != 0) {
    complain(tool, "cannot read standard input: " +
                       (error == EFBIG ? "it has more than " + std::to_string(limits.file_bytes) +
                                             " bytes; " + raise_limit("file-bytes")
                                       : sys::error_text(error)));
    return std::nullopt;
  }
  std::string name = filename;
  if (name.empty()) name = standard_input_name(text);
  if (name.empty()) {
    complain(tool, "standard input is not XML; say what it is with --stdin-filename PATH");
    return std::nullopt;
  }
  files.add(name, std::move(text));
  return name;
}

std::optional<std::string> find_main_file(std::string_view tool, const std::string& path,
                                          const FileReader& files) {
  std::optional<std::string> reason = why_unreadable(path, files);
  if (!reason && is_archive(path)) {
    ArchivedMain main = main_file_of_archive(path, files);
    if (!main.path.empty()) return std::move(main.path);
    reason = "it " + main.reason;
  }
  if (!reason) return path;
  complain(tool, "cannot read '" + path + "': " + *reason);
  return std::nullopt;
}

std::optional<std::string> find_only_input(std::string_view tool, const std::string& folder,
                                           std::span<const InputKind> kinds, const Limits& limits) {
  const FoundInputs found = find_inputs(folder, limits);
  for (const std::string& problem : found.unreadable) complain(tool, "cannot read " + problem);
  if (!found.unreadable.empty()) return std::nullopt;
  for (const InputKind kind : kinds) {
    std::vector<std::string> files = found.files;
    std::erase_if(files, [&](const std::string& file) { return input_kind(file) != kind; });
    if (files.size() == 1) return files.front();
    if (files.empty()) continue;
    complain(tool, "'" + folder + "' contains " + std::to_string(files.size()) +
                       " files to choose from; name one, such as '" + files.front() + "'");
    return std::nullopt;
  }
  complain(tool, why_nothing(found, folder));
  return std::nullopt;
}

std::optional<std::string> current_folder(std::string_view tool) {
  std::error_code error;
  auto folder = places::current_folder(error);
  if (folder) return folder;
  complain(tool, "cannot determine the current folder: " + error.message());
  return std::nullopt;
}

InputFiles::InputFiles(const FileReader& behind) : behind_(behind) {
  sys::Status status{};
  if (sys::fstat(0, &status) == 0 && S_ISREG(status.st_mode)) {
    known_.insert({status.st_dev, status.st_ino});
  }
}

FileContent InputFiles::read(const std::string& path, std::uint64_t max_bytes) const {
  FileContent content = behind_.read(path, max_bytes);
  note(path);
  if (content.status == ReadStatus::ok || content.status == ReadStatus::too_large) add(path);
  return content;
}

bool InputFiles::is_file(const std::string& path) const {
  note(path);
  if (!behind_.is_file(path)) return false;
  add(path);
  return true;
}

void InputFiles::note(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  asked_.insert(path);
}

void InputFiles::add(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  read_.insert(path);
}

bool InputFiles::contains(const std::string& path) const {
  sys::Status status{};
  if (sys::stat(path.c_str(), &status) != 0) return false;
  // It decides which files a model may name.
  if (path::file_name(places::canonical(path).value_or(path)) == "package.xml") return true;
  const std::lock_guard lock(mutex_);
  for (const std::string& one : read_) {  // most runs have no output that exists
    sys::Status found{};
    if (sys::stat(one.c_str(), &found) == 0) known_.insert({found.st_dev, found.st_ino});
  }
  read_.clear();
  return known_.contains({status.st_dev, status.st_ino});
}

bool keeps_inputs(std::string_view tool, const InputFiles& inputs,
                  std::span<const std::string> outputs) {
  for (const std::string& output : outputs) {
    if (output.empty() || output == "-" || !inputs.contains(output)) continue;
    complain(tool, "'" + output + "' is an input of this run and would be lost; " +
                       "write to another file; nothing was written");
    return false;
  }
  return true;
}

}  // namespace smurf::tools
