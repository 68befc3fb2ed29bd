// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/explain.hpp"

#include <algorithm>
#include <vector>

#include "ast/format.hpp"
#include "base/files/path.hpp"
#include "base/text/did_you_mean.hpp"
#include "base/text/lists.hpp"
#include "config/key_help.hpp"
#include "render/wrap.hpp"
#include "smurf-lint/options.hpp"
#include "smurf/lint.hpp"

namespace smurf::tools {
namespace {

constexpr std::size_t kColumns = 80;

bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Rules whose ids begin with "SML31" or "31".
std::vector<const Rule*> family(std::string_view what) {
  std::vector<const Rule*> rules;
  const std::string prefix = (is_digits(what) ? "SML" : "") + std::string(what);
  constexpr std::string_view kFamily = "SML";
  if (!prefix.starts_with(kFamily)) return rules;
  for (const Rule* rule : all_rules()) {
    if (rule->id.starts_with(prefix)) rules.push_back(rule);
  }
  return rules;
}

bool is_called(const FormatPart& part, std::string_view name) {
  const bool is_main_file = part.name == "main file" && (name == "smurf" || name == "model");
  return is_main_file || part.name == name ||
         std::find(part.aliases.begin(), part.aliases.end(), name) != part.aliases.end();
}

/// "number, at least 0, in rad/s; default 0; read by MARS 2".
std::string facts_of(const KeyDescription& key) {
  std::string text = key.type;
  if (!key.unit.empty()) text.append(", in ").append(key.unit);
  if (key.is_required) text += "; required";
  if (!key.fallback.empty()) text.append("; default ").append(key.fallback);
  if (!key.read_by.empty()) text.append("; read by ").append(key.read_by);
  return text;
}

std::string page_of(const FormatPart& part) {
  std::string head =
      std::string(part.name) + ": " + std::string(part.form) + ". " + std::string(part.doc);
  std::string text = render::wrap(head, 0, kColumns);
  if (!part.read_by.empty()) {
    text += "\n" + render::wrap("Read by: " + std::string(part.read_by) + ".", 0, kColumns);
  }
  text += "\n";
  for (const KeyDescription& key : part.keys) {
    text += key.path + "\n" + render::wrap(facts_of(key), 4, kColumns) +
            render::wrap(key.doc, 4, kColumns);
  }
  if (!part.more.empty()) {
    text += "\nAn entry can also have the keys of `" + std::string(part.more) +
            "`: smurf-lint --explain " + std::string(part.more) + "\n";
  }
  return text;
}

/// All keys and attributes of a name: "maxEffort", "motors.maxEffort", "limit.effort".
std::string keys_called(std::string_view name) {
  std::string text;
  for (const KeyHelp& key : find_keys(name)) {
    if (!text.empty()) text += "\n";
    for (const std::string& line : describe(key)) text += render::wrap(line, 0, kColumns);
  }
  return text;
}

/// "mesh: ...", with the attributes and the elements in it; "" if URDF has no such element.
std::string element_called(std::string_view name) {
  const auto element = element_help(name);
  if (!element) return {};
  std::string text = render::wrap(
      std::string(name) + ": element of a URDF. " + std::string(element->doc), 0, kColumns);
  for (const KeyHelp& attribute : element->attributes) {
    text += "\n";
    for (const std::string& line : describe(attribute)) text += render::wrap(line, 0, kColumns);
  }
  if (element->children.empty()) return text;
  return text + "\n" +
         render::wrap("Elements in it: " + listed(element->children) + ".", 0, kColumns);
}

/// The rules about inertials, which the page of their element lists.
std::string mistakes_in_inertials() {
  std::string text = "\nMistakes that are reported (docs/inertia.md has an example of each):\n";
  for (const Rule* rule : family("SML15")) {
    text += render::wrap(std::string(rule->id) + " " + std::string(rule->summary), 0, kColumns);
  }
  constexpr std::string_view kCommands =
      "smurf-lint --masses ROBOT compares the masses with the shapes; smurf-lint --fix-inertia "
      "--diff ROBOT shows inertias that fit.";
  return text + "\n" + render::wrap(std::string(kCommands), 0, kColumns);
}

}  // namespace

std::string explanation(std::string_view name, const TextStyle& style) {
  // Ids may be written in lower case.
  std::string id = path::to_lower(name);
  if (id.starts_with("sml")) id.replace(0, 3, "SML");
  const std::string_view what = id.starts_with("SML") ? std::string_view(id) : name;
  // Before rules, because some had the name of a section once.
  for (const FormatPart& part : describe_format()) {
    if (is_called(part, what)) return page_of(part);
  }
  if (const Rule* rule = find_rule(what)) return render_rule(*rule, style);
  const std::vector<const Rule*> rules = family(what);
  if (rules.size() == 1) return render_rule(*rules.front(), style);
  if (!rules.empty()) return render_rule_list(rules, style);
  const std::string keys = keys_called(what);
  std::string element = element_called(what);
  if (what == "inertia" || what == "inertial") element += mistakes_in_inertials();
  return keys.empty() || element.empty() ? keys + element : element + "\n" + keys;
}

std::string nothing_to_explain(std::string_view what) {
  return "there is no rule, section, element or key '" + std::string(what) + "'" +
         did_you_mean(what, explained_words());
}

}  // namespace smurf::tools
