// SPDX-License-Identifier: BSD-3-Clause
// The layout is that of rustc: line numbers in a gutter, marks under the lines, "..." for gaps, and
// a bracket in the margin for a mark of several lines.
#include "render/frame.hpp"

#include <algorithm>
#include <utility>

namespace smurf::render {
namespace {

constexpr std::uint32_t kLongBracket = 6;  ///< lines of a mark that is shown completely
constexpr std::uint32_t kBracketHead = 4;  ///< lines shown of a longer mark
constexpr std::uint32_t kBracketTail = 2;
/// Without a terminal, only very long lines are truncated: a file that is one line with n findings
/// would be printed n times.
constexpr int kUncutColumns = 500;

}  // namespace

Frame::Frame(const SourceMap& sources, const TextStyle& style, Mark main, std::vector<Mark> others,
             std::uint32_t context_lines)
    : sources_(sources),
      style_(style),
      paint_(style.color),
      main_(main),
      main_lines_(lines_of(main.span)),
      has_bracket_(main_lines_.first != main_lines_.last),
      others_(std::move(others)) {
  std::stable_sort(others_.begin(), others_.end(),
                   [](const Mark& a, const Mark& b) { return a.span.begin < b.span.begin; });
  share_mark();
  choose_lines(context_lines);
  gutter_ = std::to_string(shown_.back()).size();
}

/// A label on the main mark is the caption of that mark, if it has none.
void Frame::share_mark() {
  if (!main_.text.empty()) return;
  const auto same = std::find_if(others_.begin(), others_.end(),
                                 [&](const Mark& mark) { return mark.span == main_.span; });
  if (same == others_.end()) return;
  main_.text = same->text;
  others_.erase(same);
}

Frame::Lines Frame::lines_of(Span span) const {
  const std::uint32_t first = sources_.line_of(span.source, span.begin);
  // The end is exclusive: a span up to and with a line end stays on that line.
  const std::uint32_t last = span.empty() ? first : sources_.line_of(span.source, span.end - 1);
  return {first, last};
}

void Frame::choose_lines(std::uint32_t context_lines) {
  const SourceId source = main_.span.source;
  const std::uint32_t last_line = sources_.line_count(source);
  const auto [first, last] = main_lines_;
  const bool is_long = last - first >= kLongBracket;
  for (std::uint32_t line = first; line <= last; ++line) {
    if (!is_long || line < first + kBracketHead || line + kBracketTail > last) {
      shown_.push_back(line);
    } else {
      line = last - kBracketTail;
    }
  }
  for (std::uint32_t i = 1; i <= context_lines; ++i) {
    if (first > i) shown_.push_back(first - i);
    // After the last line end there is an empty line that no editor shows.
    const std::uint32_t below = last + i;
    const bool is_phantom = below == last_line && sources_.line_span(source, below).empty();
    if (below <= last_line && !is_phantom) shown_.push_back(below);
  }
  for (const Mark& mark : others_) shown_.push_back(lines_of(mark.span).first);

  std::sort(shown_.begin(), shown_.end());
  shown_.erase(std::unique(shown_.begin(), shown_.end()), shown_.end());
}

ByteRange Frame::on_first_line(Span span) const {
  const Span line = sources_.line_span(span.source, sources_.line_of(span.source, span.begin));
  const std::uint32_t begin = std::min(span.begin, line.end);
  return {begin, std::clamp(span.end, begin, line.end)};
}

std::string Frame::draw() const {
  std::string out = row("", "");
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (i > 0) out += gap(shown_[i - 1], shown_[i]);
    out += source_rows(shown_[i]);
  }
  return out + row("", "");
}

/// A gap of a single line is shown, because dots would take as much space.
std::string Frame::gap(std::uint32_t before, std::uint32_t after) const {
  if (after == before + 1) return {};
  if (after == before + 2) return source_rows(before + 1);
  std::string dots = "...";
  if (main_lines_.first <= before && after <= main_lines_.last) {
    dots.resize(std::max(gutter_ + 3, dots.size() + 1), ' ');
    return paint_(Ink::frame, dots) + paint_(main_.ink, "|") + "\n";
  }
  return paint_(Ink::frame, dots) + "\n";
}

std::string Frame::source_rows(std::uint32_t number) const {
  const Span span = sources_.line_span(main_.span.source, number);
  std::vector<const Mark*> marks;
  if (!has_bracket_ && number == main_lines_.first) marks.push_back(&main_);
  for (const Mark& mark : others_) {
    if (lines_of(mark.span).first == number) marks.push_back(&mark);
  }
  std::vector<ByteRange> ranges;
  if (has_bracket_ && number == main_lines_.first) {
    const std::uint32_t begin = on_first_line(main_.span).begin;
    ranges.push_back({begin, begin});
  }
  for (const Mark* mark : marks) ranges.push_back(on_first_line(mark->span));
  if (has_bracket_ && number == main_lines_.last) ranges.push_back(last_of_bracket());
  const SourceLine line(sources_.text(span), span.begin, room(), ranges);

  const bool opens_beside =
      number == main_lines_.first && line.is_first_text(on_first_line(main_.span).begin);
  std::string out = row(std::to_string(number), bracket(number, opens_beside) + line.text());
  for (const Mark* mark : marks) out += mark_row(line, *mark);
  if (has_bracket_ && number == main_lines_.first && !opens_beside) out += opening_row(line);
  if (has_bracket_ && number == main_lines_.last) out += closing_row(line);
  return out;
}

/// The column between the gutter and the text when the main mark spans lines.
std::string Frame::bracket(std::uint32_t line, bool opens_beside) const {
  if (!has_bracket_) return {};
  if (line == main_lines_.first && opens_beside) return paint_(main_.ink, "/") + " ";
  if (line > main_lines_.first && line <= main_lines_.last) return paint_(main_.ink, "|") + " ";
  return "  ";
}

/// Columns available for a source line.
int Frame::room() const {
  if (style_.width <= 0) return kUncutColumns;
  return style_.width - static_cast<int>(gutter_) - 3 - (has_bracket_ ? 2 : 0);
}

/// The text is beside the mark or, when the terminal is too narrow, below it and further left.
std::string Frame::mark_row(const SourceLine& line, const Mark& mark) const {
  const ByteRange range = on_first_line(mark.span);
  const std::uint32_t number = lines_of(mark.span).first;
  const std::string margin = bracket(number, false);
  const std::string lead = line.lead(range.begin, ' ');
  const std::string drawn = line.underline(range, mark.line);
  if (mark.text.empty()) return row("", margin + lead + paint_(mark.ink, drawn));

  const std::string text = escape(mark.text);
  const std::size_t columns = width_of(text);
  const auto free = static_cast<std::size_t>(std::max(room(), 0));
  if (style_.width <= 0 || width_of(lead) + drawn.size() + 1 + columns <= free) {
    return row("", margin + lead + paint_(mark.ink, drawn + " " + text));
  }
  const std::size_t indent = std::min(lead.size(), free - std::min(columns, free));
  return row("", margin + lead + paint_(mark.ink, drawn)) +
         row("", margin + lead.substr(0, indent) + paint_(mark.ink, text));
}

std::string Frame::opening_row(const SourceLine& line) const {
  const std::uint32_t begin = on_first_line(main_.span).begin;
  return row("", " " + paint_(main_.ink, "_" + line.lead(begin, '_') + main_.line));
}

/// The last byte that the main mark covers.
ByteRange Frame::last_of_bracket() const {
  const Span line = sources_.line_span(main_.span.source, main_lines_.last);
  const std::uint32_t end = std::clamp(main_.span.end, line.begin, line.end);
  return {end > line.begin ? end - 1 : end, end};
}

std::string Frame::closing_row(const SourceLine& line) const {
  std::string drawn = "|_" + line.lead(last_of_bracket().begin, '_') + main_.line;
  if (!main_.text.empty()) drawn.append(" ").append(escape(main_.text));
  return row("", paint_(main_.ink, drawn));
}

std::string Frame::row(std::string_view number, std::string_view text) const {
  const std::string head = std::string(gutter_ - number.size(), ' ').append(number);
  std::string out = paint_(Ink::frame, head + " |");
  if (!text.empty()) out.append(" ").append(text);
  out.erase(out.find_last_not_of(' ') + 1);
  return out + "\n";
}

}  // namespace smurf::render
