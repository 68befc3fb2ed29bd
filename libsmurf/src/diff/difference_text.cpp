// SPDX-License-Identifier: BSD-3-Clause
// Prints differences as text.
#include <algorithm>
#include <array>

#include "base/text/counted.hpp"
#include "diff/sentences.hpp"
#include "diff/values.hpp"
#include "render/paint.hpp"
#include "render/printable.hpp"
#include "render/wrap.hpp"

namespace smurf {
namespace {

using render::Ink;

constexpr int kColumns = 80;
constexpr int kFewestColumns = 40;
constexpr std::size_t kIndent = 4;

/// Whether the detail names the items of a list that were renamed.
bool is_about_names(std::string_view detail) {
  return !detail.starts_with("which") && detail.find(" was renamed to ") != detail.npos;
}

std::string sentence_of(const Difference& difference) {
  std::string text;
  switch (difference.change) {
  case Change::added: text = " added"; break;
  case Change::removed: text = " removed"; break;
  case Change::renamed: break;
  case Change::changed:
    text = ": " + label_in(difference) + " " + shown_value(change_text(difference));
    if (difference.before == difference.after && is_about_names(difference.detail)) {
      return ": " + label_in(difference) + " still has an old name: " + difference.detail;
    }
    if (difference.before == difference.after && !difference.detail.empty()) {
      text = ": " + label_in(difference) + " is still " +
             shown_value(value_text(difference.after, {}, {}));
    }
    break;
  }
  if (!difference.detail.empty()) text += ", " + difference.detail;
  return text;
}

Ink ink_of(Change change) {
  switch (change) {
  case Change::added: return Ink::info;
  case Change::removed: return Ink::error;
  case Change::renamed: return Ink::warning;
  case Change::changed: break;
  }
  return Ink::strong;
}

/// Adds the place at the right edge of the last line, or on a separate line.
void append_place(std::string& lines, const std::string& place, std::size_t columns) {
  const std::size_t begin = lines.rfind('\n');
  const std::size_t used = render::width_of(std::string_view(lines).substr(begin + 1));
  const std::size_t width = render::width_of(place);
  if (used + 2 + width <= columns) {
    lines.append(columns - used - width, ' ').append(place);
  } else {
    lines.append("\n").append(width + kIndent > columns ? kIndent : columns - width, ' ');
    lines.append(place);
  }
}

std::string paragraph_of(const Difference& difference, const SourceMap& sources,
                         const TextStyle& style) {
  const int wanted = style.width > 0 ? std::clamp(style.width, kFewestColumns, kColumns) : kColumns;
  const auto columns = static_cast<std::size_t>(wanted);
  const bool is_renamed = difference.change == Change::renamed;
  const std::string subject = subject_of(difference);
  std::string text = subject + sentence_of(difference);
  if (is_renamed) {
    text +=
        difference.name.empty() ? " lost its name" : " renamed to " + shown_name(difference.name);
  }
  std::string lines = render::wrap(text, kIndent, columns).substr(kIndent);
  lines.pop_back();
  const std::string place =
      place_text(difference.new_place ? difference.new_place : difference.old_place, sources);
  if (!place.empty()) append_place(lines, place, columns);
  if (lines.starts_with(subject)) {
    lines.replace(0, subject.size(),
                  render::Painter(style.color)(ink_of(difference.change), subject));
  }
  return lines + "\n";
}

}  // namespace

std::string render_diff(std::span<const Difference> differences, const SourceMap& sources,
                        const TextStyle& style) {
  if (differences.empty()) return "no differences\n";
  std::string text;
  std::array<std::size_t, 4> counts{};
  for (const Difference& difference : differences) {
    text += paragraph_of(difference, sources, style);
    ++counts[static_cast<std::size_t>(difference.change)];
  }
  text += counted(differences.size(), "difference") + ":";
  std::string separator = " ";
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    text += separator + std::to_string(counts[i]) + " " +
            std::string(to_string(static_cast<Change>(i)));
    separator = ", ";
  }
  return text + "\n";
}

}  // namespace smurf
