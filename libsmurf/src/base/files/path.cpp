// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"

#include <algorithm>

#include "base/files/system.hpp"

namespace smurf::path {
namespace {

/// Whether the text continues with ".", ".." or nothing at the start of a part.
bool begins_oddly(std::string_view rest) {
  if (rest.empty() || rest.front() == '/') return true;
  return rest.front() == '.' && (rest.size() == 1 || rest[1] == '.' || rest[1] == '/');
}

/// Whether a quick check shows that normalising changes nothing.
bool is_final(std::string_view path) {
  if (path.size() > kLongest) return true;
  if (!path.starts_with('/') && begins_oddly(path)) return false;
  for (std::size_t at = path.find('/'); at != std::string_view::npos; at = path.find('/', at + 1)) {
    if (begins_oddly(path.substr(at + 1))) return false;
  }
  return true;
}

/// A path without a drive is on the drive of the other path.
bool are_on_two_drives(std::string_view path, std::string_view other) {
  const auto drive_of = [](std::string_view one) {
    return sys::without_drive(one) == one ? std::string() : to_lower(one.substr(0, one.find(':')));
  };
  const std::string drive = drive_of(path);
  const std::string other_drive = drive_of(other);
  return !drive.empty() && !other_drive.empty() && drive != other_drive;
}

}  // namespace

std::string_view parent(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string_view::npos) return {};
  return slash == 0 ? path.substr(0, 1) : path.substr(0, slash);
}

std::string_view file_name(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string_view extension(std::string_view path) {
  const std::string_view name = file_name(path);
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos ? std::string_view{} : name.substr(dot);
}

std::string_view stem(std::string_view path) {
  const std::string_view name = file_name(path);
  return name.substr(0, name.size() - extension(path).size());
}

bool is_absolute(std::string_view path) { return path.starts_with('/'); }

std::string normalize(std::string_view path) {
  if (is_final(path)) return std::string(path);
  std::vector<std::string_view> kept;
  for (const std::string_view part : names(path)) {
    if (part == ".") continue;
    if (part == ".." && !kept.empty() && kept.back() != "..") {
      kept.pop_back();
    } else if (part != ".." || !is_absolute(path)) {
      kept.push_back(part);
    }
  }
  std::string result = is_absolute(path) ? "/" : "";
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (i > 0) result += '/';
    result += kept[i];
  }
  return result.empty() ? "." : result;
}

std::vector<std::string_view> names(std::string_view path) {
  std::vector<std::string_view> found;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    if (end > 0) found.push_back(path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return found;
}

std::string join(std::string_view folder, std::string_view path) {
  if (is_absolute(path) || folder.empty()) return normalize(path);
  std::string whole;
  whole.reserve(folder.size() + 1 + path.size());
  whole.append(folder).append("/").append(path);
  if (is_final(whole)) return whole;
  return normalize(whole);
}

std::string relative(std::string_view path, std::string_view folder) {
  const std::string whole = normalize(path);
  const std::string base = normalize(folder.empty() ? "." : folder);
  if (is_absolute(whole) != is_absolute(base) || whole.size() > kLongest) return whole;
  if (are_on_two_drives(whole, base)) return whole;
  std::vector<std::string_view> to = names(sys::without_drive(whole));
  std::vector<std::string_view> from = names(sys::without_drive(base));
  if (whole == ".") to.clear();
  if (base == ".") from.clear();
  std::size_t common = 0;
  while (common < to.size() && common < from.size() && to[common] == from[common]) ++common;
  std::string result;
  for (std::size_t i = common; i < from.size(); ++i) {
    if (from[i] == "..") return whole;
    result += "../";
  }
  for (std::size_t i = common; i < to.size(); ++i) {
    result += to[i];
    if (i + 1 < to.size()) result += '/';
  }
  if (result.ends_with('/')) result.pop_back();
  return result.empty() ? "." : result;
}

std::string to_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

}  // namespace smurf::path
