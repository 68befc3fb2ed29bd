// SPDX-License-Identifier: BSD-3-Clause
// Line starts are found once per source; columns are counted when a place is shown.
#include "smurf/source.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "base/utf8.hpp"

namespace smurf {

SourceId SourceMap::add(std::string path, std::string text) {
  Source source;
  source.path = std::move(path);
  source.text = std::move(text);
  source.is_ascii = utf8::ascii_prefix(source.text) == source.text.size();
  source.line_starts.push_back(0);
  for (std::size_t at = source.text.find('\n'); at != std::string::npos;
       at = source.text.find('\n', at + 1)) {
    source.line_starts.push_back(static_cast<std::uint32_t>(at + 1));
  }
  sources_.push_back(std::move(source));
  return SourceId{static_cast<std::uint32_t>(sources_.size() - 1)};
}

SourceId SourceMap::add_unreadable(std::string path) {
  const SourceId id = add(std::move(path), {});
  sources_.back().readable = false;
  return id;
}

SourceShift SourceMap::take(SourceMap&& other, std::size_t common) {
  const SourceShift shift{static_cast<std::uint32_t>(common),
                          static_cast<std::uint32_t>(sources_.size() - common)};
  const auto first = other.sources_.begin() + static_cast<std::ptrdiff_t>(common);
  std::move(first, other.sources_.end(), std::back_inserter(sources_));
  return shift;
}

std::string_view SourceMap::text(Span span) const {
  return std::string_view(at(span.source).text).substr(span.begin, span.end - span.begin);
}

std::uint32_t SourceMap::line_of(SourceId id, std::uint32_t offset) const {
  const std::vector<std::uint32_t>& starts = at(id).line_starts;
  const auto after = std::upper_bound(starts.begin(), starts.end(), offset);
  return static_cast<std::uint32_t>(after - starts.begin());
}

Position SourceMap::position(SourceId id, std::uint32_t offset) const {
  assert(offset <= at(id).text.size());
  const std::uint32_t line = line_of(id, offset);
  std::uint32_t start = at(id).line_starts[line - 1];
  if (at(id).is_ascii) return {line, offset - start + 1};
  // A byte order mark is not something the author sees as a column.
  if (line == 1 && at(id).text.starts_with("\xEF\xBB\xBF")) {
    start = std::min<std::uint32_t>(3, offset);
  }
  const std::string_view before =
      std::string_view(at(id).text).substr(start, offset > start ? offset - start : 0);
  return {line, static_cast<std::uint32_t>(utf8::count_code_points(before)) + 1};
}

std::uint32_t SourceMap::line_count(SourceId id) const {
  return static_cast<std::uint32_t>(at(id).line_starts.size());
}

Span SourceMap::line_span(SourceId id, std::uint32_t line) const {
  const Source& source = at(id);
  const std::uint32_t begin = source.line_starts[line - 1];
  std::uint32_t end = line < source.line_starts.size()
                          ? source.line_starts[line] - 1
                          : static_cast<std::uint32_t>(source.text.size());
  if (end > begin && source.text[end - 1] == '\r') --end;
  return {id, begin, end};
}

}  // namespace smurf
