// SPDX-License-Identifier: BSD-3-Clause
#include "diff/sentences.hpp"

#include "base/text/quoted.hpp"
#include "diff/values.hpp"
#include "render/printable.hpp"

namespace smurf {

std::string shown_name(std::string_view name) {
  constexpr std::size_t kLongest = 200;
  return render::escape(shortened(name, kLongest));
}

std::string shown_value(std::string_view value) {
  constexpr std::size_t kLongest = 600;
  return render::escape(shortened(value, kLongest));
}

std::string subject_of(const Difference& difference) {
  const bool is_renamed = difference.change == Change::renamed;
  const std::string& name = is_renamed ? difference.old_name : difference.name;
  std::string subject = shown_name(difference.kind);
  if (!name.empty()) subject += " " + shown_name(name);
  if (difference.number != 0) subject += " " + std::to_string(difference.number);
  if (!difference.owner.empty()) subject += " of " + shown_name(difference.owner);
  return subject;
}

std::string label_in(const Difference& difference) {
  return shown_name(label_of(difference.property));
}

std::string place_text(const std::optional<Span>& place, const SourceMap& sources) {
  if (!place || static_cast<std::size_t>(place->source) >= sources.size()) return {};
  return render::escape(sources.path(place->source)) + ":" +
         std::to_string(sources.line_of(place->source, place->begin));
}

}  // namespace smurf
