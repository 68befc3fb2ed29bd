// SPDX-License-Identifier: BSD-3-Clause
// Prints differences as text and as JSON.
#include <algorithm>
#include <array>
#include <limits>

#include "base/counted.hpp"
#include "base/quoted.hpp"
#include "diff/values.hpp"
#include "render/paint.hpp"
#include "render/printable.hpp"
#include "render/wrap.hpp"
#include "smurf/diff.hpp"
#include "write/json_printer.hpp"

namespace smurf {
namespace {

using render::Ink;

constexpr int kColumns = 80;
constexpr int kFewestColumns = 40;
constexpr std::size_t kIndent = 4;
constexpr std::size_t kLongestName = 200;
constexpr std::size_t kLongestValue = 600;

std::string shown(std::string_view text, std::size_t most) {
  return render::escape(shortened(text, most));
}

/// "visual 2 of link hand".
std::string subject_of(const Difference& difference) {
  std::string subject = shown(difference.kind, kLongestName);
  if (!difference.name.empty()) subject += " " + shown(difference.name, kLongestName);
  if (difference.number != 0) subject += " " + std::to_string(difference.number);
  if (!difference.owner.empty()) subject += " of " + shown(difference.owner, kLongestName);
  return subject;
}

std::string sentence_of(const Difference& difference) {
  std::string text;
  switch (difference.change) {
  case Change::added: text = " added"; break;
  case Change::removed: text = " removed"; break;
  case Change::renamed: break;
  case Change::changed:
    text = ": " + shown(label_of(difference.property), kLongestName) + " " +
           shown(change_text(difference), kLongestValue);
    break;
  }
  if (!difference.detail.empty()) text += ", " + difference.detail;
  return text;
}

std::string place_of(const Difference& difference, const SourceMap& sources) {
  const std::optional<Span>& place =
      difference.new_place ? difference.new_place : difference.old_place;
  if (!place || static_cast<std::size_t>(place->source) >= sources.size()) return {};
  return render::escape(sources.path(place->source)) + ":" +
         std::to_string(sources.line_of(place->source, place->begin));
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

/// Adds the place at the right edge of the last line, or on a line of its own.
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
  Difference named = difference;
  if (is_renamed) named.name = difference.old_name;
  const std::string subject = subject_of(named);
  std::string text = subject + sentence_of(difference);
  if (is_renamed) {
    text += difference.name.empty() ? " lost its name"
                                    : " renamed to " + shown(difference.name, kLongestName);
  }
  std::string lines = render::wrap(text, kIndent, columns).substr(kIndent);
  lines.pop_back();
  if (const std::string place = place_of(difference, sources); !place.empty()) {
    append_place(lines, place, columns);
  }
  if (lines.starts_with(subject)) {
    lines.replace(0, subject.size(),
                  render::Painter(style.color)(ink_of(difference.change), subject));
  }
  return lines + "\n";
}

class JsonReport {
 public:
  JsonReport(const SourceMap& sources) : sources_(sources) {}

  std::string write(std::span<const Difference> differences, const DiffInputs& inputs,
                    const ToolName& tool) {
    json_.begin_object(JsonPrinter::Layout::block);
    text("schema_version", "1.0");
    json_.key("tool");
    json_.begin_object();
    text("name", tool.name);
    text("version", tool.version);
    json_.end();
    text("old", inputs.before);
    text("new", inputs.after);
    json_.key("tolerance");
    json_.number(inputs.tolerance);
    summary(differences);
    json_.key("differences");
    json_.begin_list(JsonPrinter::Layout::block);
    for (const Difference& difference : differences) this->difference(difference);
    json_.end();
    json_.end();
    return json_.take().value_or("");
  }

 private:
  void text(std::string_view key, std::string_view value) {
    json_.key(key);
    json_.text(value);
  }
  void text_if_any(std::string_view key, std::string_view value) {
    if (!value.empty()) text(key, value);
  }

  void summary(std::span<const Difference> differences) {
    std::array<std::int64_t, 4> counts{};
    for (const Difference& one : differences) ++counts[static_cast<std::size_t>(one.change)];
    json_.key("summary");
    json_.begin_object();
    for (std::size_t i = 0; i < counts.size(); ++i) {
      json_.key(to_string(static_cast<Change>(i)));
      json_.integer(counts[i]);
    }
    json_.end();
  }

  void difference(const Difference& difference) {
    json_.begin_object();
    text("change", to_string(difference.change));
    text("kind", difference.kind);
    text("name", difference.name);
    if (difference.number != 0) {
      json_.key("number");
      json_.integer(static_cast<std::int64_t>(difference.number));
    }
    text_if_any("of", difference.owner);
    if (difference.change == Change::renamed) text("old_name", difference.old_name);
    if (difference.change == Change::changed) changed(difference);
    text_if_any("effect", difference.detail);
    place("old_source", difference.old_place);
    place("new_source", difference.new_place);
    json_.end();
  }

  void changed(const Difference& difference) {
    text("property", difference.property);
    json_.key("old");
    value(difference.before);
    json_.key("new");
    value(difference.after);
    text_if_any("default", difference.fallback);
    text_if_any("unit", difference.unit);
  }

  void value(const DiffValue& value) {
    if (const auto* boolean = std::get_if<bool>(&value)) return json_.boolean(*boolean);
    if (const auto* number = std::get_if<double>(&value)) return json_.number(*number);
    if (const auto* text = std::get_if<std::string>(&value)) return json_.text(*text);
    if (const auto* pose = std::get_if<Pose>(&value)) return json_.pose(*pose);
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
      return list(*numbers, [&](double one) { json_.number(one); });
    }
    if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) {
      return list(*texts, [&](const std::string& one) { json_.text(one); });
    }
    if (const auto* q = std::get_if<Quaternion>(&value)) {
      json_.begin_object();
      for (const auto& [key, part] : {std::pair("w", q->w), std::pair("x", q->x),
                                      std::pair("y", q->y), std::pair("z", q->z)}) {
        json_.key(key);
        json_.number(part);
      }
      return json_.end();
    }
    json_.null();
  }

  template <class Items, class Print>
  void list(const Items& items, const Print& print) {
    json_.begin_list();
    for (const auto& item : items) print(item);
    json_.end();
  }

  void place(std::string_view key, const std::optional<Span>& place) {
    if (!place) return;
    json_.key(key);
    json_.place(*place, sources_);
  }

  const SourceMap& sources_;
  JsonPrinter json_{std::numeric_limits<std::uint64_t>::max()};
};

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

std::string render_diff_json(std::span<const Difference> differences, const SourceMap& sources,
                             const DiffInputs& inputs, const ToolName& tool) {
  return JsonReport(sources).write(differences, inputs, tool);
}

}  // namespace smurf
