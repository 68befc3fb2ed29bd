// SPDX-License-Identifier: BSD-3-Clause
// Prints differences as JSON, and as the page of web/diff around the JSON. web/diff/main.js reads
// the members, and documents those of the page alone.
#include <array>
#include <limits>

#include "diff/diff_page.hpp"
#include "diff/sentences.hpp"
#include "diff/values.hpp"
#include "smurf/diff.hpp"
#include "write/text/json_printer.hpp"

namespace smurf {
namespace {

class JsonReport {
 public:
  explicit JsonReport(const SourceMap& sources) : sources_(sources) {}
  /// Contains texts for people, and the selection in the picture, which may be empty.
  JsonReport(const SourceMap& sources, std::string_view picture)
      : sources_(sources), is_page_(true), picture_(picture) {}

  std::string write(std::span<const Difference> differences, const DiffInputs& inputs,
                    const ToolName& tool) {
    json_.begin_object(JsonPrinter::Layout::block);
    json_.member("schema_version", "1.0");
    json_.key("tool");
    json_.begin_object();
    json_.member("name", tool.name);
    json_.member("version", tool.version);
    json_.end();
    json_.member("old", inputs.before);
    json_.member("new", inputs.after);
    json_.key("tolerance");
    json_.number(inputs.tolerance);
    summary(differences);
    if (is_page_) {
      json_.member("old_title", shown_name(inputs.before));
      json_.member("new_title", shown_name(inputs.after));
      text_if_any("picture", picture_);
    }
    json_.key("differences");
    json_.begin_list(JsonPrinter::Layout::block);
    for (const Difference& difference : differences) this->difference(difference);
    json_.end();
    json_.end();
    return json_.take().value_or("");
  }

 private:
  void text_if_any(std::string_view key, std::string_view value) {
    if (!value.empty()) json_.member(key, value);
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
    json_.member("change", to_string(difference.change));
    json_.member("kind", difference.kind);
    json_.member("name", difference.name);
    if (difference.number != 0) {
      json_.key("number");
      json_.integer(static_cast<std::int64_t>(difference.number));
    }
    text_if_any("of", difference.owner);
    if (difference.change == Change::renamed) json_.member("old_name", difference.old_name);
    if (difference.change == Change::changed) changed(difference);
    text_if_any("effect", difference.detail);
    place("old_source", difference.old_place);
    place("new_source", difference.new_place);
    if (is_page_) add_page_members(difference);
    json_.end();
  }

  void add_page_members(const Difference& difference) {
    json_.member("group", shown_name(difference.kind));
    json_.member("subject", subject_of(difference));
    if (difference.change == Change::changed) {
      const ValueTexts texts = value_texts(difference);
      json_.member("label", label_in(difference));
      json_.member("old_text", shown_value(texts.before));
      json_.member("new_text", shown_value(texts.after));
      text_if_any("percentage", percentage_of(difference));
    } else if (difference.change == Change::renamed) {
      json_.member("old_text", shown_name(difference.old_name));
      json_.member("new_text", shown_name(difference.name));
    }
    text_if_any("old_place", place_text(difference.old_place, sources_));
    text_if_any("new_place", place_text(difference.new_place, sources_));
    model("old_model", difference.old_model);
    model("new_model", difference.new_model);
  }

  void model(std::string_view key, const std::optional<ModelIndex>& index) {
    if (!index) return;
    json_.key(key);
    json_.integer(static_cast<std::int64_t>(to_size(*index)));
  }

  void changed(const Difference& difference) {
    json_.member("property", difference.property);
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
  bool is_page_ = false;
  std::string_view picture_;
  JsonPrinter json_{std::numeric_limits<std::uint64_t>::max()};
};

}  // namespace

std::string render_diff_json(std::span<const Difference> differences, const SourceMap& sources,
                             const DiffInputs& inputs, const ToolName& tool) {
  return JsonReport(sources).write(differences, inputs, tool);
}

std::string render_diff_html(std::span<const Difference> differences, const SourceMap& sources,
                             const DiffInputs& inputs, const ToolName& tool,
                             std::string_view picture) {
  return page_around(diff_page(), JsonReport(sources, picture).write(differences, inputs, tool));
}

}  // namespace smurf
