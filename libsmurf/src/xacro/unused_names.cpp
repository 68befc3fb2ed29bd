// SPDX-License-Identifier: BSD-3-Clause
// Names that the file of a robot defines, and that nothing uses.
#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/rules.hpp"
#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"
#include "xacro/expander.hpp"
#include "xacro/whole_word.hpp"

namespace smurf::xacro {
namespace {

enum class Defined : std::uint8_t { macro, parameter, property, argument };
constexpr std::array<std::string_view, 4> kTitles = {"macro", "parameter", "property", "argument"};

struct Definition {
  Defined kind{};
  std::string_view name;
  Span place;  ///< the value of the attribute
};

/// "radius:=1" as `radius`, "*block" as `block`
std::string_view parameter_name(std::string_view written) {
  while (written.starts_with('*')) written.remove_prefix(1);
  const auto end = std::find_if_not(written.begin(), written.end(), is_of_name);
  return written.substr(0, static_cast<std::size_t>(end - written.begin()));
}

void collect(const Node& node, std::vector<Definition>& all) {
  const NodeAttribute* name = node.attribute("name");
  if (name != nullptr && node.name.starts_with("xacro:")) {
    const std::string_view element = node.name.substr(6);
    const Definition one{{}, name->text.value, name->text.whole.use};
    if (element == "property") all.push_back({Defined::property, one.name, one.place});
    if (element == "arg") all.push_back({Defined::argument, one.name, one.place});
    if (element == "macro") all.push_back({Defined::macro, one.name, one.place});
    const NodeAttribute* parameters = node.attribute("params");
    if (element == "macro" && parameters != nullptr) {
      const std::string_view text = parameters->text.value;
      // A default may contain blanks and names; its words are taken for parameters only if they
      // are found nowhere, and then they are none.
      for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
        const std::string_view written = text.substr(at, end - at);
        at = end + 1;
        if (written.find_first_of("'\"") != std::string_view::npos) break;
        if (written.ends_with(',')) continue;  // SML3411
        const std::string_view word = parameter_name(written);
        if (!word.empty()) all.push_back({Defined::parameter, word, parameters->text.whole.use});
      }
    }
  }
  for (const Node* child : node.children) {
    if (child->kind == NodeKind::element) collect(*child, all);
  }
}

}  // namespace

/// Whether a name occurs outside of its definitions, as a word that is no name of an attribute.
bool Expander::is_used(std::string_view name, const std::vector<Span>& definitions) const {
  for (const auto& [path, file] : files_) {
    const SourceId source = file->source;
    const std::string_view text = context_.sources.text(source);
    for (std::size_t at = text.find(name); at != std::string_view::npos;
         at = text.find(name, at + 1)) {
      const std::size_t end = at + name.size();
      if (!is_whole_name(text, at, end)) continue;
      const std::size_t next = std::min(text.find_first_not_of(" \t\r\n", end), text.size());
      if (text.substr(next, 1) == "=" && text.substr(next, 2) != "==") continue;
      const bool is_definition = std::any_of(definitions.begin(), definitions.end(), [&](Span one) {
        return one.source == source && one.begin <= at && end <= one.end;
      });
      if (!is_definition) return true;
    }
  }
  return false;
}

/// Only in the file of a robot: libraries have names for others.
void Expander::check_unused(const Node& in, const Node& out) {
  const bool is_robot = std::any_of(out.children.begin(), out.children.end(),
                                    [](const Node* child) { return child->name == "link"; });
  if (!is_robot || has_failed_) return;
  std::vector<Definition> all;
  collect(in, all);
  for (std::size_t kind = 0; kind < kTitles.size(); ++kind) {
    std::set<std::string_view> seen;
    Diagnostic* first = nullptr;
    std::string others;
    for (const Definition& one : all) {
      const bool is_computed = one.name.find('$') != std::string_view::npos;
      if (static_cast<std::size_t>(one.kind) != kind || one.name.empty() || is_computed) continue;
      if (!seen.insert(one.name).second) continue;
      std::vector<Span> places;
      for (const Definition& other : all) {
        if (other.kind == one.kind && other.name == one.name) places.push_back(other.place);
      }
      if (is_used(one.name, places)) continue;
      if (first != nullptr) {
        others += (others.empty() ? "" : ", ") + quoted(one.name);
        continue;
      }
      first = &context_.sink.report(rules::sml3413_xacro_unused_name, one.place,
                                    "nothing uses the " + std::string(kTitles[kind]) + " " +
                                        quoted(one.name));
      first->help("delete it");
    }
    if (!others.empty()) first->note("this also applies to " + shortened(others, 200));
  }
}

}  // namespace smurf::xacro
