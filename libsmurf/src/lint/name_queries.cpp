// SPDX-License-Identifier: BSD-3-Clause
#include "lint/name_queries.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "ast/urdf_numbers.hpp"
#include "base/text/words.hpp"
#include "lint/reference_queries.hpp"

namespace smurf {
namespace {

/// Letters, digits and `_`, by byte.
constexpr std::array<bool, 256> kWord = [] {
  std::array<bool, 256> words{};
  for (const char c : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                       "0123456789_")) {
    words[static_cast<unsigned char>(c)] = true;
  }
  return words;
}();
bool is_word(char c) { return kWord[static_cast<unsigned char>(c)]; }
bool is_identifier(std::string_view name) {
  return !name.empty() && !is_digit(name.front()) && std::all_of(name.begin(), name.end(), is_word);
}
bool is_beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }

}  // namespace

NameFault name_fault(std::string_view name) {
  // Checked first, because nearly all names are sound and every rule on names calls this.
  if (is_identifier(name) && !name.starts_with("__")) return NameFault::none;
  if (name.empty() || is_xacro(name)) return NameFault::none;  // separate rules report them
  if (is_blank(name.front()) || is_blank(name.back())) return NameFault::blank;
  if (name.find('/') != std::string_view::npos) return NameFault::slash;
  if (name.find("::") != std::string_view::npos) return NameFault::double_colon;
  if (name.size() > 3 && name.starts_with("__") && name.ends_with("__")) return NameFault::reserved;
  if (std::any_of(name.begin(), name.end(), is_beyond_ascii)) return NameFault::non_ascii;
  return is_identifier(name) ? NameFault::none : NameFault::irregular;
}

void for_each_name(const LinkedModel& model,
                   const std::function<void(std::string_view, const Field<std::string>&)>& visit) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (link.name && !link.name->empty()) visit("link", link.name);
  });
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.name && !joint.name->empty()) visit("joint", joint.name);
  });
}

const urdf::Link* link_without_name(const LinkedModel& model) {
  if (!model.robot) return nullptr;
  const auto& links = model.robot->links;
  const auto found = std::find_if(links.begin(), links.end(), [](const urdf::Link& link) {
    return !link.name || link.name->empty() || is_xacro(*link.name);
  });
  return found == links.end() ? nullptr : &*found;
}

Diagnostic* check_link_of_joint(const LinkedModel& model, const Reference& link,
                                const std::string& who, const urdf::Link* unnamed,
                                Findings& findings, const Meanings& meanings) {
  if (unnamed == nullptr) {
    return check_reference(model, NameKind::link, link.name, link.span, who.c_str(), findings,
                           meanings);
  }
  const bool has_name = unnamed->name && !unnamed->name->empty();
  findings.add_consequence(has_name ? unnamed->name.span : tag_name(model, unnamed->element));
  return nullptr;
}

std::string as_identifier(std::string_view name) {
  std::string identifier(name);
  std::replace_if(
      identifier.begin(), identifier.end(), [](char c) { return !is_word(c); }, '_');
  if (!identifier.empty() && (is_digit(identifier.front()) || identifier.front() == '_')) {
    identifier.insert(0, "a_");
  }
  return identifier;
}

std::vector<NameCollision>
name_collisions(const LinkedModel& model,
                const std::function<std::string(std::string_view)>& fold) {
  std::vector<NameCollision> collisions;
  bool has_changed = false;  // without such a character, no two names become equal
  for_each_name(model, [&](std::string_view, const Field<std::string>& name) {
    has_changed = has_changed || fold(*name) != *name;
  });
  if (!has_changed) return collisions;
  std::map<std::string, const Field<std::string>*> links, joints;
  for_each_name(model, [&](std::string_view kind, const Field<std::string>& name) {
    auto& seen = kind == "link" ? links : joints;
    const auto [first, is_new] = seen.try_emplace(fold(*name), &name);
    if (!is_new && **first->second != *name) collisions.push_back({kind, first->second, &name});
  });
  return collisions;
}

}  // namespace smurf
