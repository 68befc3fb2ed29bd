// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/flow_context.hpp"

#include <algorithm>
#include <utility>

namespace smurf::lsp {
namespace {

constexpr std::string_view kSpace = " \t\r\n";
constexpr std::size_t kMostLevels = 200;

class Reader {
 public:
  Reader(std::string_view text, std::size_t at, std::optional<std::size_t> column)
      : text_(text), at_(at), column_(column) {}

  FlowRead run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '[' || c == '{') {
        if (context_.levels.size() == kMostLevels) return {std::nullopt, text_.size()};
        context_.levels.push_back({c == '{', {}, {}});
        next();
      } else if (c == ']' || c == '}') {
        context_.levels.pop_back();
        next();
        if (context_.levels.empty()) return {std::nullopt, at_};
      } else if (c == ',') {
        end_of_entry();
        next();
      } else if (c == '#' && is_space_before()) {
        if (!skip_comment()) break;
      } else if (!has_word_ && (c == '"' || c == '\'')) {
        if (!read_quoted(c)) break;
      } else if (c == ':' && is_separator()) {
        FlowLevel& level = context_.levels.back();
        if (level.is_mapping && level.key.empty()) level.key = word();
        next();
      } else if (c == '\n' && is_over()) {
        return {std::nullopt, at_ + 1};
      } else {
        read_plain(c);
      }
    }
    if (!has_word_) begin_ = text_.size();
    context_.begin = begin_;
    return {std::move(context_), text_.size()};
  }

 private:
  /// Goes to the next character, which begins a new word.
  void next() {
    ++at_;
    has_word_ = false;
    begin_ = at_;
    end_ = at_;
  }

  void read_plain(char c) {
    if (kSpace.find(c) == kSpace.npos) {
      if (!has_word_) begin_ = at_;
      has_word_ = true;
      end_ = at_ + 1;
    }
    ++at_;
  }

  /// Reads a quoted word. False when the quote is not closed before the cursor.
  bool read_quoted(char quote) {
    std::size_t close = at_ + 1;
    while (close < text_.size() && text_[close] != quote && text_[close] != '\n') {
      close += quote == '"' && text_[close] == '\\' ? 2 : 1;
    }
    has_word_ = true;
    begin_ = at_ + 1;
    end_ = std::min(close, text_.size());
    at_ = end_;
    if (at_ == text_.size()) {
      context_.quote = quote;
      return false;
    }
    if (text_[at_] == quote) ++at_;
    return true;
  }

  /// Whether the collection ends before the next line.
  bool is_over() const {
    if (!column_) return false;
    const std::size_t first = text_.find_first_not_of(" \t\r", at_ + 1);
    if (first == text_.npos ||
        std::string_view("\n#]}").find(text_[first]) != std::string_view::npos) {
      return false;
    }
    return first - (at_ + 1) <= *column_;
  }

  bool skip_comment() {
    const std::size_t line_end = text_.find('\n', at_);
    context_.is_comment = line_end == text_.npos;
    at_ = line_end;
    return !context_.is_comment;
  }

  bool is_space_before() const { return at_ == 0 || kSpace.find(text_[at_ - 1]) != kSpace.npos; }

  /// Whether the colon ends a key: JSON has no space behind it.
  bool is_separator() const {
    const bool is_quoted =
        has_word_ && at_ > 0 && (text_[at_ - 1] == '"' || text_[at_ - 1] == '\'');
    const bool is_before_space =
        at_ + 1 >= text_.size() ||
        (std::string(kSpace) + ",[]{}").find(text_[at_ + 1]) != std::string::npos;
    return is_quoted || is_before_space;
  }

  std::string word() const {
    return has_word_ ? std::string(text_.substr(begin_, end_ - begin_)) : std::string();
  }

  void end_of_entry() {
    FlowLevel& level = context_.levels.back();
    if (!level.is_mapping) return;
    level.siblings.push_back(level.key.empty() ? word() : std::exchange(level.key, {}));
  }

  std::string_view text_;
  std::size_t at_;
  std::optional<std::size_t> column_;
  FlowContext context_;
  bool has_word_ = false;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

}  // namespace

FlowRead read_flow(std::string_view text, std::size_t begin, std::optional<std::size_t> column) {
  return Reader(text, begin, column).run();
}

}  // namespace smurf::lsp
