// SPDX-License-Identifier: BSD-3-Clause
// Line ends are counted once per source, in blocks; lines and columns are computed when a place is
// shown.
#include "smurf/source.hpp"

#include <algorithm>
#include <cassert>

#include "base/text/count.hpp"
#include "base/text/utf8.hpp"

namespace smurf {
namespace {

constexpr std::size_t kBlock = 256;  // bytes; a finding looks through a dozen blocks

std::uint32_t line_ends(std::string_view text) {
  return static_cast<std::uint32_t>(count_of(text, '\n'));
}

std::uint32_t characters(std::string_view text) {
  return static_cast<std::uint32_t>(utf8::count_code_points(text));
}

/// The number of characters that UTF-16 encodes as two units.
std::uint32_t wide(std::string_view text) {
  const auto is_wide = [](char lead) { return static_cast<unsigned char>(lead) >= 0xF0; };
  return static_cast<std::uint32_t>(std::count_if(text.begin(), text.end(), is_wide));
}

using Counter = std::uint32_t (*)(std::string_view);

/// The result of `count` for the text before each block; the last entry is for the end of the text.
std::vector<std::uint32_t> count_before_blocks(std::string_view text, Counter count) {
  std::vector<std::uint32_t> counts{0};
  counts.reserve(text.size() / kBlock + 1);
  for (std::size_t end = kBlock; end <= text.size(); end += kBlock) {
    counts.push_back(counts.back() + count(text.substr(end - kBlock, kBlock)));
  }
  return counts;
}

std::uint32_t count_before(std::string_view text, const std::vector<std::uint32_t>& before_blocks,
                           Counter count, std::size_t offset) {
  const std::size_t block = offset / kBlock;
  return before_blocks[block] + count(text.substr(block * kBlock, offset - block * kBlock));
}

}  // namespace

SourceId SourceMap::add(std::string path, std::string text) {
  Source source;
  source.path = std::move(path);
  source.text = std::move(text);
  source.is_ascii = utf8::ascii_prefix(source.text) == source.text.size();
  const std::string_view whole = source.text;
  source.line_ends_before = count_before_blocks(whole, line_ends);
  source.line_count = count_before(whole, source.line_ends_before, line_ends, whole.size()) + 1;
  if (!source.is_ascii) {
    source.characters_before = count_before_blocks(whole, characters);
    source.wide_before = count_before_blocks(whole, wide);
    if (count_before(whole, source.wide_before, wide, whole.size()) == 0) source.wide_before = {};
  }
  return keep(std::move(source));
}

SourceId SourceMap::add_unreadable(std::string path) {
  Source source;
  source.path = std::move(path);
  source.line_ends_before.push_back(0);
  source.readable = false;
  return keep(std::move(source));
}

SourceId SourceMap::keep(Source source) {
  sources_.push_back(std::make_shared<const Source>(std::move(source)));
  return SourceId{static_cast<std::uint32_t>(sources_.size() - 1)};
}

SourceShift SourceMap::take(SourceMap&& other, std::size_t common) {
  const SourceShift shift{static_cast<std::uint32_t>(common),
                          static_cast<std::uint32_t>(sources_.size() - common)};
  for (std::size_t i = common; i < other.sources_.size(); ++i) {
    std::shared_ptr<const Source>& source = other.sources_[i];
    std::shared_ptr<const Source>& known = taken_[source->path];
    const bool is_known =
        known && known->text == source->text && known->readable == source->readable;
    if (!is_known) known = std::move(source);
    sources_.push_back(known);
  }
  return shift;
}

std::uint32_t SourceMap::wide_characters(Span span) const {
  const Source& source = at(span.source);
  if (source.wide_before.empty()) return 0;
  const auto before = [&](std::uint32_t offset) {
    return count_before(source.text, source.wide_before, wide, offset);
  };
  return before(span.end) - before(span.begin);
}

std::string_view SourceMap::text(Span span) const {
  return std::string_view(at(span.source).text).substr(span.begin, span.end - span.begin);
}

std::uint32_t SourceMap::line_of(SourceId id, std::uint32_t offset) const {
  const Source& source = at(id);
  return count_before(source.text, source.line_ends_before, line_ends, offset) + 1;
}

std::uint32_t SourceMap::line_start(const Source& source, std::uint32_t line) {
  if (line == 1) return 0;
  const std::vector<std::uint32_t>& counts = source.line_ends_before;
  // The line begins after the line end of this number, which is in the last block before which
  // there are fewer line ends.
  const std::uint32_t line_end = line - 1;
  const auto block = std::lower_bound(counts.begin(), counts.end(), line_end) - 1;
  std::size_t at = static_cast<std::size_t>(block - counts.begin()) * kBlock;
  for (std::uint32_t count = *block; count < line_end; ++count) {
    at = source.text.find('\n', at) + 1;
  }
  return static_cast<std::uint32_t>(at);
}

std::uint32_t SourceMap::characters_before(const Source& source, std::uint32_t offset) {
  return count_before(source.text, source.characters_before, characters, offset);
}

Position SourceMap::position(SourceId id, std::uint32_t offset) const {
  assert(offset <= at(id).text.size());
  const std::uint32_t line = line_of(id, offset);
  std::uint32_t start = line_start(at(id), line);
  if (at(id).is_ascii) return {line, offset - start + 1};
  // Authors do not see a byte order mark as a column.
  if (line == 1 && at(id).text.starts_with(kByteOrderMark)) {
    start = std::min<std::uint32_t>(3, offset);
  }
  return {line, characters_before(at(id), offset) - characters_before(at(id), start) + 1};
}

std::uint32_t SourceMap::line_count(SourceId id) const { return at(id).line_count; }

Span SourceMap::line_span(SourceId id, std::uint32_t line) const {
  const Source& source = at(id);
  const std::uint32_t begin = line_start(source, line);
  std::uint32_t end = line < source.line_count ? line_start(source, line + 1) - 1
                                               : static_cast<std::uint32_t>(source.text.size());
  if (end > begin && source.text[end - 1] == '\r') --end;
  return {id, begin, end};
}

}  // namespace smurf
