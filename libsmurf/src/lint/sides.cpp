// SPDX-License-Identifier: BSD-3-Clause
#include "lint/sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace smurf {
namespace {

struct Side {
  std::string_view left, right;
};
constexpr Side kSides[] = {{"left", "right"}, {"l", "r"},   {"fl", "fr"}, {"rl", "rr"},
                           {"hl", "hr"},      {"bl", "br"}, {"lf", "rf"}, {"lh", "rh"},
                           {"lr", "rr"},      {"lb", "rb"}, {"ml", "mr"}, {"lm", "rm"}};
constexpr std::size_t kLongestSide = 5;
/// Words for places that siblings have.
constexpr std::string_view kSideWords[] = {
    "left", "right", "front", "rear", "back", "middle", "mid", "fl", "fr", "rl",
    "rr",   "hl",    "hr",    "bl",   "br",   "lf",     "rf",  "lh", "rh", "lr",
    "lb",   "rb",    "ml",    "mr",   "lm",   "rm",     "l",   "r"};

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return is_lower(c) || is_upper(c); }
char lowered(char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }
char raised(char c) { return is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c; }

/// A part of a name: letters of one word, digits, or other characters.
struct Word {
  std::size_t begin, end;
};

/// "leftArm_2" has the words "left", "Arm", "_" and "2".
template <typename Visit>
void for_each_word(std::string_view name, const Visit& visit) {
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t begin = at++;
    const char first = name[begin];
    if (is_digit(first)) {
      while (at < name.size() && is_digit(name[at])) ++at;
    } else if (is_letter(first)) {
      while (at < name.size() && is_letter(name[at]) &&
             !(is_upper(name[at]) && is_lower(name[at - 1])) &&
             !(is_upper(name[at]) && at + 1 < name.size() && is_lower(name[at + 1]))) {
        ++at;
      }
    }
    visit(Word{begin, at});
  }
}

/// Whether `word` is the text in lower case.
bool is_lowered(std::string_view text, std::string_view word) {
  if (text.size() != word.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (lowered(text[i]) != word[i]) return false;
  }
  return true;
}

std::string lowered(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = lowered(c);
  return lower;
}

/// `word` in the case of `model`.
std::string in_case_of(std::string_view model, std::string_view word) {
  std::string text(word);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_raised = is_upper(model[0]) && (i == 0 || is_upper(model[model.size() - 1]));
    if (is_raised) text[i] = raised(text[i]);
  }
  return text;
}

/// The name without sides, places and numbers; empty if it has none.
std::string kind_of(std::string_view name) {
  std::string kind;
  bool has_place = false;
  for_each_word(name, [&](const Word& word) {
    const std::string_view text = name.substr(word.begin, word.end - word.begin);
    bool is_place = is_digit(text[0]);
    for (const std::string_view place : kSideWords) is_place = is_place || is_lowered(text, place);
    kind += is_place ? "*" : lowered(text);
    has_place = has_place || is_place;
  });
  return has_place ? kind : std::string();
}

}  // namespace

std::vector<std::string> right_names_of(std::string_view left) {
  std::vector<std::string> names;
  std::size_t sides = 0;
  for_each_word(left, [&](const Word& word) {
    const std::string_view text = left.substr(word.begin, word.end - word.begin);
    if (text.size() > kLongestSide || !is_letter(text[0])) return;
    bool is_side = false;
    for (const Side& side : kSides) {
      const bool is_left = is_lowered(text, side.left);
      is_side = is_side || is_left || is_lowered(text, side.right);
      if (!is_left) continue;
      names.push_back(std::string(left.substr(0, word.begin)) + in_case_of(text, side.right) +
                      std::string(left.substr(word.end)));
    }
    if (is_side) ++sides;
  });
  if (sides > 1) names.clear();  // "front_leftR" may be opposite of "front_rightL"
  return names;
}

std::vector<std::pair<std::size_t, std::size_t>>
pairs_of_sides(const std::vector<std::string_view>& names) {
  std::map<std::string_view, std::size_t> index_of;  // made if a name has a side
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::vector<std::string> right_names = right_names_of(names[i]);
    if (!right_names.empty() && index_of.empty()) {
      for (std::size_t k = 0; k < names.size(); ++k) index_of.emplace(names[k], k);
    }
    for (const std::string& right : right_names) {
      const auto found = index_of.find(right);
      if (found == index_of.end()) continue;
      pairs.emplace_back(i, found->second);
      break;
    }
  }
  return pairs;
}

std::vector<std::vector<std::size_t>> siblings_of(const std::vector<std::string_view>& names) {
  std::map<std::string, std::size_t> place_of;
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string kind = kind_of(names[i]);
    if (kind.empty()) continue;
    const auto [known, is_new] = place_of.try_emplace(std::move(kind), groups.size());
    if (is_new) groups.emplace_back();
    groups[known->second].push_back(i);
  }
  std::erase_if(groups, [](const auto& group) {
    constexpr std::size_t kFewest = 3;
    return group.size() < kFewest;
  });
  return groups;
}

bool has_chain(const LinkedModel& model, std::span<const std::size_t> links) {
  for (std::size_t at : links) {
    for (std::size_t steps = 0; steps < model.robot->links.size(); ++steps) {
      const auto above = model.tree.parent_joint[at];
      if (!above || !model.tree.joint_parent[to_size(*above)]) break;
      at = to_size(*model.tree.joint_parent[to_size(*above)]);
      if (std::find(links.begin(), links.end(), at) != links.end()) return true;
    }
  }
  return false;
}

bool are_near(double a, double b, double tolerance) {
  constexpr double kSmall = 1e-3;
  return std::fabs(a - b) <= kSmall + tolerance * std::max(std::fabs(a), std::fabs(b));
}

bool have_same_bounds(const urdf::Limit& a, const urdf::Limit& b, double tolerance) {
  return are_near(*a.lower, *b.lower, tolerance) && are_near(*a.upper, *b.upper, tolerance);
}

bool have_turned_bounds(const urdf::Limit& a, const urdf::Limit& b, double tolerance) {
  return are_near(*a.lower, -*b.upper, tolerance) && are_near(*a.upper, -*b.lower, tolerance);
}

}  // namespace smurf
