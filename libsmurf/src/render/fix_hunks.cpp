// SPDX-License-Identifier: BSD-3-Clause
#include "render/fix_hunks.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "base/text/edits.hpp"
#include "render/printable.hpp"

namespace smurf::render {
namespace {

constexpr std::size_t kMostHunks = 20;
constexpr std::uint32_t kMostAround = 80;  ///< bytes before and after the change in a line
constexpr std::size_t kMostBytes = 4000;   ///< bytes of each side of a hunk
constexpr std::string_view kEllipsis = "...";

/// The part of a text that a hunk shows.
struct Window {
  Span span;
  bool is_cut_left = false;
  bool is_cut_right = false;
};

Window window_of(std::span<const Edit> edits, const SourceMap& sources) {
  const SourceId source = edits.front().span.source;
  const std::string_view text = sources.text(source);
  const auto size = static_cast<std::uint32_t>(text.size());
  const std::uint32_t first = std::min(edits.front().span.begin, size);
  const std::uint32_t last = std::clamp(edits.back().span.end, first, size);
  Span span{source, sources.line_begin(source, sources.line_of(source, first)),
            sources.line_span(source, sources.line_of(source, last)).end};
  span.end = std::max(span.end, last);
  Window window{span};
  if (first - span.begin > kMostAround) {
    window.is_cut_left = true;
    window.span.begin = first - kMostAround;
    while (utf8::is_continuation(text[window.span.begin])) ++window.span.begin;
  }
  if (span.end - last > kMostAround) {
    window.is_cut_right = true;
    window.span.end = last + kMostAround;
    while (utf8::is_continuation(text[window.span.end])) --window.span.end;
  }
  return window;
}

std::string shown(std::string_view text, const Window& window, bool& is_cut) {
  std::string out(window.is_cut_left ? kEllipsis : "");
  std::size_t size = text.size();
  if (size > kMostBytes) {
    is_cut = true;
    size = kMostBytes;
    while (utf8::is_continuation(text[size])) --size;
  }
  out += visible_lines(text.substr(0, size));
  if (window.is_cut_right || size < text.size()) out += kEllipsis;
  return out;
}

/// The end of the edits that follow the first on the same line or the next one.
std::size_t end_of_hunk(std::span<const Edit> edits, const SourceMap& sources) {
  const auto line_of = [&](const Edit& edit, std::uint32_t offset) {
    const SourceId source = edit.span.source;
    const auto size = static_cast<std::uint32_t>(sources.text(source).size());
    return sources.line_of(source, std::min(offset, size));
  };
  std::size_t end = 1;
  while (end < edits.size() && edits[end].span.source == edits[end - 1].span.source &&
         line_of(edits[end], edits[end].span.begin) <=
             line_of(edits[end - 1], edits[end - 1].span.end) + 1) {
    ++end;
  }
  return end;
}

}  // namespace

Json fix_hunks(const Fix& fix, const SourceMap& sources) {
  std::vector<Edit> edits;
  for (const Edit& edit : fix.edits) {
    if (static_cast<std::size_t>(edit.span.source) < sources.size()) edits.push_back(edit);
  }
  std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) {
    return a.span.source != b.span.source ? a.span.source < b.span.source
                                          : a.span.begin < b.span.begin;
  });
  Json hunks = Json::array();
  bool is_cut = false;
  std::span<Edit> rest(edits);
  while (!rest.empty() && hunks.size() < kMostHunks) {
    const std::span<Edit> own = rest.first(end_of_hunk(rest, sources));
    rest = rest.subspan(own.size());
    const Window window = window_of(own, sources);
    const Span span = window.span;
    for (Edit& edit : own) {
      edit.span.begin -= span.begin;
      edit.span.end -= span.begin;
    }
    hunks.push_back({{"file", escape(sources.path(span.source))},
                     {"line", sources.line_of(span.source, span.begin)},
                     {"before", shown(sources.text(span), window, is_cut)},
                     {"after", shown(apply_edits(sources.text(span), own), window, is_cut)}});
  }
  if ((is_cut || !rest.empty()) && !hunks.empty()) hunks.back()["is_cut"] = true;
  return hunks;
}

}  // namespace smurf::render
