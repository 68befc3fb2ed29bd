// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/yaml_context.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "smurf-lsp/flow_context.hpp"

namespace smurf::lsp {
namespace {

constexpr std::string_view kBlank = " \t";

/// "- " or "key:" in a line.
struct Level {
  std::size_t column = 0;
  bool is_item = false;
  std::string_view key;
};

/// The text before the value of a line, and the position of the value.
struct Line {
  std::vector<Level> levels;
  std::size_t value = 0;
};

/// The position of the colon after a key, or none.
std::optional<std::size_t> colon_of(std::string_view line, std::size_t at) {
  const char quote = at < line.size() && (line[at] == '"' || line[at] == '\'') ? line[at] : '\0';
  if (quote != '\0') at = std::min(line.find(quote, at + 1), line.size());
  for (; at < line.size(); ++at) {
    if (line[at] == '#' || line[at] == '{' || line[at] == '[') return std::nullopt;
    if (line[at] == ':' && (at + 1 == line.size() || kBlank.find(line[at + 1]) != kBlank.npos)) {
      return at;
    }
  }
  return std::nullopt;
}

std::string_view unquoted(std::string_view key) {
  while (!key.empty() && kBlank.find(key.back()) != kBlank.npos) key.remove_suffix(1);
  const bool is_quoted =
      key.size() >= 2 && (key.front() == '"' || key.front() == '\'') && key.back() == key.front();
  return is_quoted ? key.substr(1, key.size() - 2) : key;
}

std::size_t skip_blanks(std::string_view line, std::size_t at) {
  return std::min(line.find_first_not_of(kBlank, at), line.size());
}

Line read(std::string_view line) {
  Line read;
  std::size_t at = skip_blanks(line, 0);
  while (at < line.size() && line[at] == '-' &&
         (at + 1 == line.size() || kBlank.find(line[at + 1]) != kBlank.npos)) {
    read.levels.push_back({at, true, {}});
    at = skip_blanks(line, at + 1);
  }
  if (const auto colon = colon_of(line, at)) {
    read.levels.push_back({at, false, unquoted(line.substr(at, *colon - at))});
    at = skip_blanks(line, *colon + 1);
  }
  read.value = at;
  return read;
}

class LinesBefore {
 public:
  explicit LinesBefore(std::string_view text) : text_(text) {}

  std::size_t begin_of(std::size_t at) const {
    const std::size_t before = at == 0 ? text_.npos : text_.rfind('\n', at - 1);
    return before == text_.npos ? 0 : before + 1;
  }
  /// The text from `begin` to the line end.
  std::string_view line(std::size_t begin) const {
    std::string_view line = text_.substr(begin, text_.find('\n', begin) - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }
  std::optional<std::size_t> next(std::size_t begin) const {
    const std::size_t end = text_.find('\n', begin);
    return end == text_.npos || end + 1 > text_.size() ? std::nullopt : std::optional(end + 1);
  }

 private:
  std::string_view text_;
};

bool says_something(std::string_view line) {
  const std::size_t first = line.find_first_not_of(kBlank);
  return first != line.npos && line[first] != '#' && !line.substr(first).starts_with("---");
}

/// The steps from the root to a column, found in the lines above.
KeyPath path_above(const LinesBefore& lines, std::size_t begin, std::vector<Level> own) {
  KeyPath path;
  std::size_t limit = 0;
  bool is_item = false;
  const auto take = [&](const std::vector<Level>& levels) {
    for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
      const bool fits =
          level->column < limit || (is_item && !level->is_item && level->column == limit);
      if (!fits) continue;
      path.emplace_back(level->is_item ? std::string(kItem) : std::string(level->key));
      limit = level->column;
      is_item = level->is_item;
    }
  };
  limit = own.back().column;
  is_item = own.back().is_item;
  own.pop_back();
  take(own);
  while (begin > 0 && (limit > 0 || is_item)) {
    begin = lines.begin_of(begin - 1);
    const std::string_view line = lines.line(begin);
    if (says_something(line)) take(read(line).levels);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

/// The keys at a column of the entry around a line.
std::vector<std::string> siblings_at(const LinesBefore& lines, std::size_t begin,
                                     std::size_t column) {
  std::vector<std::string> keys;
  // Whether the line still belongs to the entry.
  const auto take = [&](std::string_view line, bool is_above) {
    if (!says_something(line)) return true;
    const Line one = read(line);
    const std::size_t first = one.levels.empty() ? skip_blanks(line, 0) : one.levels[0].column;
    bool begins_entry = false;
    for (const Level& level : one.levels) {
      if (!level.is_item && level.column == column) keys.emplace_back(level.key);
      begins_entry = begins_entry || (level.is_item && level.column < column);
    }
    if (begins_entry && !is_above && !keys.empty() && first < column) {
      if (!one.levels.back().is_item && one.levels.back().column == column) keys.pop_back();
      return false;
    }
    return first >= column;
  };
  for (std::size_t at = begin; at > 0;) {
    at = lines.begin_of(at - 1);
    if (!take(lines.line(at), true)) break;
  }
  for (auto at = lines.next(begin); at; at = lines.next(*at)) {
    if (!take(lines.line(*at), false)) break;
  }
  return keys;
}

/// Whether a "#" begins a comment in the line, as far as it is written.
bool is_in_comment(std::string_view before) {
  char quote = '\0';
  for (std::size_t i = 0; i < before.size(); ++i) {
    const char c = before[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#' && (i == 0 || kBlank.find(before[i - 1]) != kBlank.npos)) {
      return true;
    }
  }
  return false;
}

/// Whether a block of text (`|` or `>`) begins here. Its lines are neither keys nor items.
bool begins_block(std::string_view value) {
  return value.starts_with('|') || value.starts_with('>');
}

/// The brackets that are open at the cursor, and the line in which the first of them stands.
struct OpenFlow {
  Line line;
  std::size_t line_begin = 0;
  FlowContext context;
};

std::optional<OpenFlow> open_flow(std::string_view before) {
  const LinesBefore lines(before);
  std::optional<std::size_t> text_column;  // of the key of a block of text
  for (std::optional<std::size_t> at = 0; at; at = lines.next(*at)) {
    const std::string_view text = lines.line(*at);
    if (!says_something(text) || text.starts_with('%')) continue;
    if (text_column && skip_blanks(text, 0) > *text_column) continue;
    Line line = read(text);
    text_column.reset();
    const std::string_view value = text.substr(line.value);
    if (begins_block(value)) {
      text_column = line.levels.empty() ? 0 : line.levels.back().column;
    } else if (value.starts_with('[') || value.starts_with('{')) {
      const auto column =
          line.levels.empty() ? std::nullopt : std::optional(line.levels.back().column);
      FlowRead flow = read_flow(before, *at + line.value, column);
      if (flow.context) return OpenFlow{std::move(line), *at, *std::move(flow.context)};
      if (flow.end > *at + text.size()) at = lines.begin_of(flow.end - 1);
    }
  }
  return std::nullopt;
}

YamlContext within(const OpenFlow& flow, std::string_view text, std::size_t offset) {
  YamlContext context;
  context.is_flow = true;
  context.is_comment = flow.context.is_comment;
  context.begin = flow.context.begin;
  context.end = offset;
  context.quote = flow.context.quote;
  std::vector<Level> levels = flow.line.levels;
  levels.push_back({flow.line.value, false, {}});
  context.path = path_above(LinesBefore(text), flow.line_begin, std::move(levels));
  for (const FlowLevel& level : flow.context.levels) {
    const bool is_last = &level == &flow.context.levels.back();
    if (!level.is_mapping) {
      context.path.emplace_back(kItem);
    } else if (is_last) {
      context.key = level.key;
      context.siblings = level.siblings;
    } else {
      context.path.push_back(level.key);
    }
  }
  return context;
}

/// The word of a block begins behind a quote that is still open.
void skip_quote(std::string_view text, YamlContext& context) {
  if (context.begin >= context.end) return;
  const char first = text[context.begin];
  if (first != '"' && first != '\'') return;
  const std::size_t close = text.find(first, context.begin + 1);
  if (close < context.end) return;
  context.quote = first;
  ++context.begin;
}

}  // namespace

YamlContext yaml_context(std::string_view text, std::size_t offset) {
  if (const auto flow = open_flow(text.substr(0, offset))) return within(*flow, text, offset);
  const LinesBefore lines(text);
  const std::size_t begin = lines.begin_of(offset);
  const std::string_view before = text.substr(begin, offset - begin);
  Line own = read(before);
  YamlContext context;
  context.end = offset;
  context.is_comment = is_in_comment(before);
  if (context.is_comment) return context;
  context.begin = begin + own.value;
  const bool has_key = !own.levels.empty() && !own.levels.back().is_item;
  context.column = has_key ? own.levels.back().column : own.value;
  if (has_key) context.key = own.levels.back().key;
  std::vector<Level> levels = own.levels;
  if (!has_key) levels.push_back({own.value, false, {}});
  context.path = path_above(lines, begin, std::move(levels));
  if (!has_key) context.siblings = siblings_at(lines, begin, context.column);
  skip_quote(text, context);
  return context;
}

}  // namespace smurf::lsp
