// SPDX-License-Identifier: BSD-3-Clause
// The greedy algorithm of Myers, which keeps for each diagonal the farthest point that a number of
// changes reaches. After kMostChanges it begins again at the farthest point, so that time and
// memory are linear; the library dtl is quadratic if every line changes.
#include "smurf-lint/line_diff.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "render/printable.hpp"
#include "smurf/source.hpp"

namespace smurf::tools {
namespace {

constexpr int kMostChanges = 128;
constexpr std::size_t kContext = 3;  // equal lines around changes
constexpr int kUnreached = -1;

using Numbers = std::vector<int>;

/// A path from one corner of two texts, or of their remaining parts, towards the other corner. A
/// point is a number of lines of both texts; its diagonal is the difference of these.
class Path {
 public:
  Path(std::span<const int> before, std::span<const int> after) : before_(before), after_(after) {}

  /// Goes to the end, or as far as kMostChanges allow.
  void run() {
    for (int changes = 0; changes <= kMostChanges; ++changes) {
      reached_.emplace_back(static_cast<std::size_t>(2 * changes + 1), kUnreached);
      for (int diagonal = -changes; diagonal <= changes; diagonal += 2) {
        const int from = entry(changes, diagonal).first;
        if (from == kUnreached) continue;
        at(changes, diagonal) = follow(from, diagonal);
        if (is_end(changes, diagonal)) return;
      }
    }
    end_ = farthest();
  }

  /// The end of the path, as numbers of lines.
  std::pair<int, int> end() const {
    const int before = at(last(), end_);
    return {before, before - end_};
  }

  /// From the first to the last.
  std::vector<EqualLines> equal() const {
    std::vector<EqualLines> runs;
    int diagonal = end_;
    for (int changes = last(); changes >= 0; --changes) {
      const auto [from, previous] = entry(changes, diagonal);
      const int size = at(changes, diagonal) - from;
      if (size > 0) {
        runs.push_back({static_cast<std::size_t>(from), static_cast<std::size_t>(from - diagonal),
                        static_cast<std::size_t>(size)});
      }
      diagonal = previous;
    }
    std::reverse(runs.begin(), runs.end());
    return runs;
  }

 private:
  int last() const { return static_cast<int>(reached_.size()) - 1; }
  int at(int changes, int diagonal) const {
    if (diagonal < -changes || diagonal > changes) return kUnreached;
    return reached_[static_cast<std::size_t>(changes)]
                   [static_cast<std::size_t>(diagonal + changes)];
  }
  int& at(int changes, int diagonal) {
    return reached_[static_cast<std::size_t>(changes)]
                   [static_cast<std::size_t>(diagonal + changes)];
  }

  /// The point on this diagonal after the last change, and the previous diagonal.
  std::pair<int, int> entry(int changes, int diagonal) const {
    if (changes == 0) return {0, 0};
    int deleted = at(changes - 1, diagonal - 1);
    if (deleted != kUnreached) ++deleted;
    if (deleted > static_cast<int>(before_.size())) deleted = kUnreached;
    int added = at(changes - 1, diagonal + 1);
    if (added - diagonal > static_cast<int>(after_.size())) added = kUnreached;
    if (deleted > added) return {deleted, diagonal - 1};
    return {added, diagonal + 1};
  }

  int follow(int before, int diagonal) const {
    const auto begin = static_cast<std::size_t>(before);
    const auto other = static_cast<std::size_t>(before - diagonal);
    std::size_t size = 0;
    while (begin + size < before_.size() && other + size < after_.size() &&
           before_[begin + size] == after_[other + size]) {
      ++size;
    }
    return static_cast<int>(begin + size);
  }

  bool is_end(int changes, int diagonal) {
    const int before = at(changes, diagonal);
    if (before != static_cast<int>(before_.size()) ||
        before - diagonal != static_cast<int>(after_.size())) {
      return false;
    }
    end_ = diagonal;
    return true;
  }

  /// Of several diagonals that reach equally far, prefers the one with equally many removed and
  /// added lines, so that both sides advance evenly in a text with many replaced lines.
  int farthest() const {
    int best = 0;
    int most = kUnreached;
    for (int i = 0; i <= 2 * last(); ++i) {
      const int diagonal = i % 2 == 0 ? -i / 2 : (i + 1) / 2;
      const int before = at(last(), diagonal);
      if (before == kUnreached || 2 * before - diagonal <= most) continue;
      best = diagonal;
      most = 2 * before - diagonal;
    }
    return best;
  }

  std::span<const int> before_;
  std::span<const int> after_;
  std::vector<Numbers> reached_;  ///< by number of changes and diagonal
  int end_ = 0;                   ///< its diagonal
};

/// Equal lines have equal numbers.
class Numbering {
 public:
  Numbers of(const std::vector<std::string_view>& lines) {
    Numbers numbers;
    numbers.reserve(lines.size());
    for (const std::string_view line : lines) {
      numbers.push_back(known_.try_emplace(line, static_cast<int>(known_.size())).first->second);
    }
    return numbers;
  }

 private:
  std::map<std::string_view, int> known_;
};

/// Keeps a byte order mark unescaped, because programs that apply the patch compare it.
void add_line(std::string& text, char mark, std::string_view line) {
  text += mark;
  if (line.starts_with(kByteOrderMark)) {
    text += kByteOrderMark;
    line.remove_prefix(kByteOrderMark.size());
  }
  text += render::escape_lines(line);
  if (!text.ends_with('\n')) text += "\n\\ No newline at end of file\n";
}

/// "3,2" in "@@ -3,2 +3,2 @@". An empty range is behind the line it names.
std::string range_text(std::size_t first, std::size_t size) {
  if (size == 1) return std::to_string(first + 1);
  return std::to_string(size == 0 ? first : first + 1) + "," + std::to_string(size);
}

/// The lines that are only in the old or the new text, by their positions. Either may be empty.
struct LineChange {
  std::size_t before = 0;
  std::size_t before_end = 0;
  std::size_t after = 0;
  std::size_t after_end = 0;
};

std::vector<LineChange> changes_between(std::vector<EqualLines> equal, std::size_t before_size,
                                        std::size_t after_size) {
  equal.push_back({before_size, after_size, 0});
  std::vector<LineChange> changes;
  std::size_t before = 0;
  std::size_t after = 0;
  for (const EqualLines& run : equal) {
    if (before < run.before || after < run.after) {
      changes.push_back({before, run.before, after, run.after});
    }
    before = run.before + run.size;
    after = run.after + run.size;
  }
  return changes;
}

/// Writes a hunk of adjacent changes.
std::string hunk(std::span<const LineChange> changes, const std::vector<std::string_view>& before,
                 const std::vector<std::string_view>& after) {
  const std::size_t lead = std::min(changes.front().before, kContext);
  const std::size_t tail = std::min(before.size() - changes.back().before_end, kContext);
  std::size_t at = changes.front().before - lead;
  const std::size_t end = changes.back().before_end + tail;
  const std::size_t first = changes.front().after - lead;
  std::string text = "@@ -" + range_text(at, end - at) + " +" +
                     range_text(first, changes.back().after_end + tail - first) + " @@\n";
  for (const LineChange& change : changes) {
    for (; at < change.before; ++at) add_line(text, ' ', before[at]);
    for (; at < change.before_end; ++at) add_line(text, '-', before[at]);
    for (std::size_t i = change.after; i < change.after_end; ++i) add_line(text, '+', after[i]);
  }
  for (; at < end; ++at) add_line(text, ' ', before[at]);
  return text;
}

}  // namespace

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

std::vector<EqualLines> equal_lines(const std::vector<std::string_view>& before,
                                    const std::vector<std::string_view>& after) {
  Numbering numbering;
  const Numbers first = numbering.of(before);
  const Numbers second = numbering.of(after);
  std::vector<EqualLines> all;
  std::size_t x = 0;
  std::size_t y = 0;
  while (x < first.size() && y < second.size()) {
    Path path{std::span(first).subspan(x), std::span(second).subspan(y)};
    path.run();
    for (const EqualLines& run : path.equal()) {
      EqualLines* last = all.empty() ? nullptr : &all.back();
      if (last != nullptr && last->before + last->size == x + run.before &&
          last->after + last->size == y + run.after) {
        last->size += run.size;
      } else {
        all.push_back({x + run.before, y + run.after, run.size});
      }
    }
    x += static_cast<std::size_t>(path.end().first);
    y += static_cast<std::size_t>(path.end().second);
  }
  return all;
}

std::string unified_hunks(std::string_view before, std::string_view after) {
  const std::vector<std::string_view> old_lines = lines_of(before);
  const std::vector<std::string_view> new_lines = lines_of(after);
  const std::vector<LineChange> changes =
      changes_between(equal_lines(old_lines, new_lines), old_lines.size(), new_lines.size());
  std::string text;
  for (std::size_t begin = 0; begin < changes.size();) {
    std::size_t end = begin + 1;
    while (end < changes.size() &&
           changes[end].before - changes[end - 1].before_end <= 2 * kContext) {
      ++end;
    }
    text += hunk(std::span(changes).subspan(begin, end - begin), old_lines, new_lines);
    begin = end;
  }
  return text;
}

}  // namespace smurf::tools
