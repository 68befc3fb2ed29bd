// SPDX-License-Identifier: BSD-3-Clause
#include "common/xacro_roots.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include "base/path.hpp"

namespace smurf::tools {
namespace {

/// The paths in the includes of a text.
std::vector<std::string> includes_of(std::string_view text) {
  std::vector<std::string> paths;
  constexpr std::string_view kTag = "<xacro:include";
  for (std::size_t at = text.find(kTag); at != std::string_view::npos;
       at = text.find(kTag, at + 1)) {
    const std::size_t end = std::min(text.find('>', at), text.size());
    const std::string_view tag = text.substr(at, end - at);
    const std::size_t name = tag.find("filename");
    if (name == std::string_view::npos) continue;
    const std::size_t open = tag.find_first_of("\"'", name);
    if (open == std::string_view::npos) continue;
    const std::size_t close = tag.find(tag[open], open + 1);
    if (close == std::string_view::npos) continue;
    paths.emplace_back(tag.substr(open + 1, close - open - 1));
  }
  return paths;
}

/// The parts of a path without its expressions: "$(find a)/urdf/${x}.xacro" is "", "/urdf/",
/// ".xacro".
std::vector<std::string> literal_parts(std::string_view written) {
  std::vector<std::string> parts(1);
  while (!written.empty()) {
    const bool is_expression = written.starts_with("${") || written.starts_with("$(");
    if (!is_expression) {
      parts.back().push_back(written[0]);
      written.remove_prefix(1);
      continue;
    }
    const std::size_t end = written.find(written[1] == '{' ? '}' : ')');
    written.remove_prefix(end == std::string_view::npos ? written.size() : end + 1);
    parts.emplace_back();
  }
  return parts;
}

/// Whether an include in a file may mean the other file.
bool may_mean(const std::string& written, const std::string& from, const std::string& other) {
  const std::vector<std::string> parts = literal_parts(written);
  if (parts.size() == 1) {
    return path::join(path::parent(from), written) == path::normalize(other);
  }
  if (!other.ends_with(parts.back())) return false;
  // The last parts must follow each other in the name of the file.
  std::string_view rest = std::string_view(other).substr(0, other.size() - parts.back().size());
  for (std::size_t i = parts.size() - 1; i > 0; --i) {
    const std::string& part = parts[i - 1];
    const bool has_folder = part.find('/') != std::string::npos || i == 1;
    const std::size_t found = rest.rfind(part);
    if (found == std::string_view::npos) return i == 1;
    rest = rest.substr(0, found);
    if (has_folder) return true;
  }
  return true;
}

}  // namespace

std::vector<std::string> xacro_roots(const std::vector<std::string>& files,
                                     const FileReader& reader, const Limits& limits) {
  // Files by their last name: comparing all with all would take long in large repositories.
  std::map<std::string, bool> is_included;
  for (const std::string& file : files) {
    const FileContent content = reader.read(file, limits.file_bytes);
    for (const std::string& written : includes_of(content.text)) {
      for (const std::string& other : files) {
        if (other == file || is_included[other]) continue;
        is_included[other] = may_mean(written, file, other);
      }
    }
  }
  std::vector<std::string> roots;
  for (const std::string& file : files) {
    if (!is_included[file]) roots.push_back(file);
  }
  return roots;
}

}  // namespace smurf::tools
