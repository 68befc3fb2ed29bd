// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/xml_prefixes.hpp"

#include <string>

#include "base/findings/rules.hpp"

namespace smurf {

void XmlPrefixes::declare(std::string_view prefix) {
  open_.push_back(prefix);
  ++declared_[prefix];
}

void XmlPrefixes::leave() {
  for (; open_.size() > elements_.back(); open_.pop_back()) --declared_[open_.back()];
  elements_.pop_back();
}

void XmlPrefixes::check(Span name) {
  const std::string_view text = text_.substr(name.begin, name.end - name.begin);
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return;
  const std::string_view prefix = text.substr(0, colon);
  if (prefix == "xml" || prefix == "xmlns") return;
  // Separate rules report residue of xacro and inclusions, and what to do.
  if (prefix == "xacro" || text == "xi:include" || text == "xi:fallback") return;
  const auto declared = declared_.find(prefix);
  if (declared != declared_.end() && declared->second > 0) return;
  if (!reported_.insert(prefix).second) return;
  Span place = name;
  place.end = place.begin + static_cast<std::uint32_t>(colon);
  sink_
      .report(rules::sml1002_xml_undeclared_prefix, place,
              "the prefix `" + std::string(prefix) + "` is not declared")
      .help("declare it: `<robot xmlns:" + std::string(prefix) + "=\"...\">`");
}

}  // namespace smurf
