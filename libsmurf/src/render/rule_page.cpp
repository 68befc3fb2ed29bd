// SPDX-License-Identifier: BSD-3-Clause
// The page of a rule, for `--explain`, and its line for `--list-rules`.
#include <algorithm>
#include <string>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "render/paint.hpp"
#include "render/wrap.hpp"
#include "smurf/render.hpp"

namespace smurf {
namespace {

using render::Ink;
using render::Painter;
using render::wrap;

constexpr std::size_t kPageColumns = 80;

std::string severity_of(const Rule& rule) {
  return std::string(to_string(rule.severity)) + (rule.needs_target ? ", with --target" : "");
}

std::string tolerance_of(const Rule& rule) {
  const Tolerance& tolerance = rule.tolerance;
  if (tolerance.meaning.empty()) return {};
  const std::string number = format_number(tolerance.value);
  std::string text = number;
  if (!tolerance.unit.empty()) text.append(" ").append(tolerance.unit);
  return text + ": " + std::string(tolerance.meaning) +
         ". To change it, write in the configuration: " + "`tolerances: {" + std::string(rule.id) +
         ": " + number + "}`.";
}

/// sources_of() without the marks of how each was checked, each once.
std::string sources_for_people(const Rule& rule) {
  constexpr std::string_view kMark = ", run";
  const std::string sources = sources_of(rule);
  std::string text;
  std::vector<std::string> known;
  for (std::size_t begin = 0; begin < sources.size();) {
    const std::size_t end = std::min(sources.find("; ", begin), sources.size());
    std::string one = sources.substr(begin, end - begin);
    begin = end + 2;
    if (one.ends_with('.')) one.pop_back();
    if (one.ends_with(kMark)) one.resize(one.size() - kMark.size());
    if (std::find(known.begin(), known.end(), one) != known.end()) continue;
    text += (text.empty() ? "" : "; ") + one;
    known.push_back(std::move(one));
  }
  return text.empty() ? text : text + ".";
}

}  // namespace

std::string rule_address(const Rule& rule, std::string_view site) {
  return std::string(site) + "/rules/" + std::string(rule.id) + "/";
}

std::string render_rule(const Rule& rule, const TextStyle& style) {
  const Painter paint(style.color);
  const std::size_t columns =
      style.width > 0 ? std::clamp<std::size_t>(static_cast<std::size_t>(style.width), 40, 80)
                      : kPageColumns;
  std::string out = paint(Ink::strong, std::string(rule.id) + " " + std::string(rule.name)) + " (" +
                    paint(render::ink_of(rule.severity), severity_of(rule)) + ")\n\n";
  out += wrap(rule.summary, 0, columns);
  const auto section = [&](std::string_view heading, std::string_view text) {
    if (!text.empty()) out += "\n" + paint(Ink::strong, heading) + "\n" + wrap(text, 2, columns);
  };
  section("Why it matters", rule.why);
  std::string readers;
  for (const Fact* fact : facts_about(rule)) readers += describe(*fact) + "\n";
  section("What readers make of it", readers.substr(0, readers.rfind('\n')));
  std::string remedies(rule.remedy);
  for (const std::string& cure : cures_of(rule)) remedies.append("\n").append(cure);
  section("What to do", remedies);
  section("Tolerance", tolerance_of(rule));
  section("Sources", sources_for_people(rule));
  return out;
}

std::string render_rule_list(std::span<const Rule* const> rules, const TextStyle& style) {
  const Painter paint(style.color);
  std::string out;
  for (const Rule* rule : rules) {
    constexpr std::size_t kIndent = 18;  // behind the id and the severity
    constexpr std::size_t kColumns = 80;
    const std::string_view severity = to_string(rule->severity);
    const std::string name(rule->name);
    const std::string text =
        render::wrap(name + ": " + std::string(rule->summary), kIndent, kColumns);
    out += std::string(rule->id) + "  " + paint(render::ink_of(rule->severity), severity) +
           std::string(9 - severity.size(), ' ') + paint(Ink::strong, name) +
           text.substr(kIndent + name.size());
  }
  return out;
}

}  // namespace smurf
