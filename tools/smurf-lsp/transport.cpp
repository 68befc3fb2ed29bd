// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/transport.hpp"

#include <algorithm>
#include <charconv>
#include <istream>
#include <ostream>
#include <string_view>
#include <utility>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"

namespace smurf::lsp {
namespace {

constexpr std::size_t kLongestHeader = 8192;             // bytes of a line
constexpr std::int64_t kLongestMessage = 1'000'000'000;  // bytes

/// A line of the header without its end; none at the end of the stream.
std::optional<std::string> read_line(std::istream& in) {
  std::string line;
  for (int c = in.get(); c != std::istream::traits_type::eof(); c = in.get()) {
    if (c == '\n') {
      if (line.ends_with('\r')) line.pop_back();
      return line;
    }
    if (line.size() < kLongestHeader) line += static_cast<char>(c);
  }
  return std::nullopt;
}

std::optional<std::int64_t> length_in(std::string_view line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  if (path::to_lower(line.substr(0, colon)) != "content-length") return std::nullopt;
  line.remove_prefix(std::min(line.find_first_not_of(" \t", colon + 1), line.size()));
  while (line.ends_with(' ')) line.remove_suffix(1);
  return parse_integer(line);
}

/// The UTF-16 unit of `\uXXXX` at the start of a JSON text.
std::optional<unsigned> unit_at(std::string_view text) {
  constexpr std::size_t kSize = 6;
  if (text.size() < kSize || !text.starts_with("\\u")) return std::nullopt;
  unsigned unit = 0;
  const char* end = text.data() + kSize;
  const auto read = std::from_chars(text.data() + 2, end, unit, 16);
  return read.ptr == end ? std::optional(unit) : std::nullopt;
}

/// Replaces halves of surrogate pairs, which editors send while somebody types, and which UTF-8
/// cannot represent. The replacement is also one unit, so positions stay the same. If the message
/// were dropped, the server and the editor would have different texts.
std::string without_halves(std::string_view text) {
  std::string whole;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t size = text[at] == '\\' ? 2 : 1;
    bool is_half = false;
    if (const auto unit = unit_at(text.substr(at))) {
      const auto next = unit_at(text.substr(at + 6));
      const bool is_pair = *unit >> 10U == 0x36 && next && *next >> 10U == 0x37;
      is_half = !is_pair && *unit >> 11U == 0x1b;
      size = is_pair ? 12 : 6;
    }
    whole += is_half ? "\\ufffd" : text.substr(at, size);
    at += size;
  }
  return whole;
}

/// Deeper values are dropped: printing or comparing them would need a deep stack.
Json parse(std::string_view text) {
  constexpr int kDeepest = 200;
  const auto keep = [](int depth, Json::parse_event_t, Json&) { return depth <= kDeepest; };
  return Json::parse(text, keep, false);
}

}  // namespace

std::optional<std::string> read_message(std::istream& in) {
  std::optional<std::int64_t> length;
  while (true) {
    const std::optional<std::string> line = read_line(in);
    if (!line) return std::nullopt;
    if (const auto found = length_in(*line)) length = found;
    if (!line->empty() || !length) continue;
    if (*length < 0 || *length > kLongestMessage) return std::nullopt;
    // Memory grows with the bytes that arrive, not with the announced length.
    std::string content;
    constexpr std::size_t kPart = 1U << 20U;
    for (auto left = static_cast<std::size_t>(*length); left > 0;) {
      const std::size_t size = content.size();
      const std::size_t part = std::min(left, kPart);
      content.resize(size + part);
      in.read(content.data() + size, static_cast<std::streamsize>(part));
      if (static_cast<std::size_t>(in.gcount()) != part) return std::nullopt;
      left -= part;
    }
    return content;
  }
}

void write_message(std::ostream& out, std::span<const std::string_view> parts) {
  std::size_t size = 0;
  for (const std::string_view part : parts) size += part.size();
  out << "Content-Length: " << size << "\r\n\r\n";
  for (const std::string_view part : parts) out << part;
  out << std::flush;
}

Inbox::Inbox(std::istream& in) : reader_([this, &in] { read(in); }) {}

Inbox::~Inbox() { reader_.join(); }

void Inbox::read(std::istream& in) {
  while (const auto text = read_message(in)) {
    Json message = parse(*text);
    if (message.is_discarded()) message = parse(without_halves(*text));
    const bool is_last = text_at(message, {"method"}) == "exit";
    messages_.push(std::move(message));
    if (is_last) break;
  }
  messages_.end();
}

}  // namespace smurf::lsp
