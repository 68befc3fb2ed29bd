// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path_patterns.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "smurf/source.hpp"

namespace smurf {
namespace {

constexpr std::string_view kAnyFolders = "**";

/// Length of the class at the front of `pattern`, such as "[!a-z]", when `c` is in it; else 0.
std::size_t match_class(std::string_view pattern, char c, std::uint64_t& steps) {
  std::size_t i = 1;
  const bool is_negated = i < pattern.size() && (pattern[i] == '!' || pattern[i] == '^');
  if (is_negated) ++i;
  bool is_in = false;
  for (bool is_first = true; i < pattern.size(); is_first = false) {
    ++steps;
    if (pattern[i] == ']' && !is_first) return is_in != is_negated ? i + 1 : 0;
    if (pattern[i] == '\\') ++i;
    if (i >= pattern.size()) break;
    const char low = pattern[i++];
    char high = low;
    if (i + 1 < pattern.size() && pattern[i] == '-' && pattern[i + 1] != ']') {
      i += pattern[i + 1] == '\\' ? 2 : 1;
      if (i >= pattern.size()) break;
      high = pattern[i++];
    }
    is_in = is_in || (low <= c && c <= high);
  }
  return 0;
}

/// Length of the front of `pattern` that matches the character `c`; 0 if it does not match.
std::size_t match_one(std::string_view pattern, char c, std::uint64_t& steps) {
  switch (pattern.front()) {
  case '?': return 1;
  case '[': return match_class(pattern, c, steps);
  case '\\': return pattern.size() > 1 && pattern[1] == c ? 2 : 0;
  default: return pattern.front() == c ? 1 : 0;
  }
}

/// A match with wildcards that span any number of items. Only the last wildcard is ever extended,
/// so the time is at most the product of both lengths.
template <class IsWild, class Match>
bool match_all(std::size_t pattern_size, std::size_t size, IsWild is_wild, Match match,
               std::uint64_t& steps) {
  std::size_t p = 0, i = 0;
  std::size_t after_wild = 0, taken = 0;
  bool has_wild = false;
  while (i < size) {
    ++steps;
    if (p < pattern_size && is_wild(p)) {
      has_wild = true;
      after_wild = ++p;
      taken = i;
    } else if (const std::size_t step = p < pattern_size ? match(p, i) : 0; step > 0) {
      p += step;
      ++i;
    } else if (has_wild) {
      p = after_wild;
      i = ++taken;
    } else {
      return false;
    }
  }
  while (p < pattern_size && is_wild(p)) ++p;
  return p == pattern_size;
}

bool match_name(std::string_view pattern, std::string_view name, std::uint64_t& steps) {
  const auto match = [&](std::size_t p, std::size_t i) {
    return match_one(pattern.substr(p), name[i], steps);
  };
  return match_all(
      pattern.size(), name.size(), [&](std::size_t p) { return pattern[p] == '*'; }, match, steps);
}

bool match_path(const std::vector<std::string>& pattern, const std::vector<std::string_view>& names,
                std::uint64_t& steps) {
  const auto match = [&](std::size_t p, std::size_t i) {
    return match_name(pattern[p], names[i], steps) ? 1U : 0U;
  };
  return match_all(
      pattern.size(), names.size(), [&](std::size_t p) { return pattern[p] == kAnyFolders; }, match,
      steps);
}

/// Spaces at the end are ignored unless a backslash precedes them.
std::string_view without_blanks(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::size_t end = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\') {
      end = std::min(i + 2, line.size());
      ++i;
    } else if (line[i] != ' ') {
      end = i + 1;
    }
  }
  return line.substr(0, end);
}

}  // namespace

void PathPatterns::add(std::string_view line) {
  line = without_blanks(line);
  if (line.empty() || line.starts_with('#') || line.size() > path::kLongest) return;
  Pattern pattern;
  if (line.starts_with('!')) {
    pattern.is_exclusion = false;
    line.remove_prefix(1);
  }
  if (line.ends_with('/')) {
    pattern.folders_only = true;
    line.remove_suffix(1);
  }
  const bool is_tied = line.find('/') != std::string_view::npos;
  if (!is_tied) pattern.names.emplace_back(kAnyFolders);
  for (const std::string_view name : path::names(line)) pattern.names.emplace_back(name);
  if (pattern.names.empty() || line.empty()) return;
  // "a/**" matches the contents of the folder, not the folder.
  if (is_tied && pattern.names.size() > 1 && pattern.names.back() == kAnyFolders) {
    pattern.names.emplace_back("*");
  }
  patterns_.push_back(std::move(pattern));
}

void PathPatterns::add_lines(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    add(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

PathVerdict PathPatterns::judge(std::string_view path, bool is_folder, std::uint64_t* steps) const {
  if (patterns_.empty()) return PathVerdict::unmentioned;
  const std::vector<std::string_view> names = path::names(path);
  std::uint64_t taken = 0;
  const auto last = std::find_if(patterns_.rbegin(), patterns_.rend(), [&](const Pattern& one) {
    ++taken;
    return (is_folder || !one.folders_only) && match_path(one.names, names, taken);
  });
  if (steps != nullptr) *steps += taken;
  if (last == patterns_.rend()) return PathVerdict::unmentioned;
  return last->is_exclusion ? PathVerdict::excluded : PathVerdict::included;
}

bool PathPatterns::excludes(std::string_view file, std::uint64_t* steps) const {
  for (std::size_t slash = file.find('/'); slash != std::string_view::npos;
       slash = file.find('/', slash + 1)) {
    if (judge(file.substr(0, slash), true, steps) == PathVerdict::excluded) return true;
  }
  return judge(file, false, steps) == PathVerdict::excluded;
}

}  // namespace smurf
