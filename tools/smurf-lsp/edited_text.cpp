// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/edited_text.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "base/text/utf8.hpp"

namespace smurf::lsp {
namespace {

constexpr std::size_t kBlock = 4096;

}  // namespace

EditedText::EditedText(std::string_view text, Encoding encoding)
    : encoding_(encoding), blocks_(cut(text)) {}

void EditedText::count(Block& block) const {
  block.lines = 0;
  for (std::size_t at = 0; (at = block.text.find('\n', at)) != std::string::npos; ++at) {
    ++block.lines;
  }
  block.units = block.lines == 0 ? units_in(block.text, encoding_) : 0;
}

std::vector<EditedText::Block> EditedText::cut(std::string_view text) const {
  std::vector<Block> blocks;
  do {
    std::size_t size = std::min(kBlock, text.size());
    while (size < text.size() && utf8::is_continuation(text[size])) ++size;
    count(blocks.emplace_back(Block{std::string(text.substr(0, size))}));
    text.remove_prefix(size);
  } while (!text.empty());
  return blocks;
}

/// None if there are fewer lines.
std::optional<EditedText::Place> EditedText::line_begin(std::uint32_t line) const {
  std::size_t block = 0;
  std::size_t left = line;
  for (; left > 0 && block < blocks_.size() && blocks_[block].lines < left; ++block) {
    left -= blocks_[block].lines;
  }
  if (block == blocks_.size()) return std::nullopt;
  std::size_t byte = 0;
  for (; left > 0; --left) byte = blocks_[block].text.find('\n', byte) + 1;
  return Place{block, byte};
}

EditedText::Place EditedText::place_of(const Json& position) const {
  const auto begin = line_begin(number_at(position, {"line"}).value_or(0));
  if (!begin) return {blocks_.size() - 1, blocks_.back().text.size()};
  Place at = *begin;
  std::uint32_t left = number_at(position, {"character"}).value_or(0);
  while (true) {
    const Block& block = blocks_[at.block];
    const bool is_last = at.block + 1 == blocks_.size();
    const bool is_whole = at.byte == 0 && block.lines == 0 && block.units <= left;
    if (is_whole && !is_last) {
      left -= block.units;
      at = {at.block + 1, 0};
      continue;
    }
    const std::string_view rest = std::string_view(block.text).substr(at.byte);
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::size_t bytes = bytes_of(rest.substr(0, end), left, encoding_);
    at.byte += bytes;
    if (bytes < end || end < rest.size() || is_last) return without_return(at);
    left -= units_in(rest, encoding_);
    at = {at.block + 1, 0};
  }
}

/// A line ends before its "\r\n". The byte before an empty line is a '\n', not a '\r'.
EditedText::Place EditedText::without_return(Place at) const {
  const std::string& text = blocks_[at.block].text;
  const bool is_end =
      at.byte < text.size() ? text[at.byte] == '\n' : at.block + 1 == blocks_.size();
  Place end = at;
  while (end.byte == 0 && end.block > 0) end = {end.block - 1, blocks_[end.block - 1].text.size()};
  const bool has_return = end.byte > 0 && blocks_[end.block].text[end.byte - 1] == '\r';
  return is_end && has_return ? Place{end.block, end.byte - 1} : at;
}

void EditedText::replace(Place begin, Place end, std::string_view inserted) {
  const bool is_backward = std::tie(end.block, end.byte) < std::tie(begin.block, begin.byte);
  if (is_backward) end = begin;
  std::string text = blocks_[begin.block].text.substr(0, begin.byte);
  text += inserted;
  text += std::string_view(blocks_[end.block].text).substr(end.byte);
  const auto first = blocks_.begin() + static_cast<std::ptrdiff_t>(begin.block);
  const auto last = blocks_.begin() + static_cast<std::ptrdiff_t>(end.block);
  const bool fits = text.size() <= 2 * kBlock && (!text.empty() || blocks_.size() == 1);
  if (begin.block == end.block && fits) {
    first->text = std::move(text);
    count(*first);
    return;
  }
  std::vector<Block> blocks = cut(text);
  const auto behind = blocks_.erase(first, last + 1);
  blocks_.insert(behind, std::make_move_iterator(blocks.begin()),
                 std::make_move_iterator(blocks.end()));
}

void EditedText::apply(const Json& change) {
  const std::string inserted = text_at(change, {"text"});
  const Json& range = at(change, {"range"});
  if (!range.is_object()) {
    blocks_ = cut(inserted);
  } else {
    replace(place_of(at(range, {"start"})), place_of(at(range, {"end"})), inserted);
  }
}

std::string EditedText::text() const {
  std::string whole;
  whole.reserve(blocks_.size() * kBlock);
  for (const Block& block : blocks_) whole += block.text;
  return whole;
}

}  // namespace smurf::lsp
