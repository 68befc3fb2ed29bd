// SPDX-License-Identifier: BSD-3-Clause
#include "link/companions/library.hpp"

#include <algorithm>
#include <numbers>
#include <string_view>
#include <utility>

#include "ast/companions/srdf_reader.hpp"
#include "base/files/path.hpp"
#include "base/numbers/digest.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/suggest.hpp"
#include "link/companions/companion_names.hpp"
#include "link/companions/places.hpp"
#include "smurf/companions.hpp"
#include "smurf/xacro.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

/// Lists of parameters of other programs, and SRDFs of other robots, are larger.
constexpr std::uint64_t kMostBytesOfCompanion = 1U << 20U;
/// More unknown names than these are no misspellings.
constexpr std::size_t kMostUnknownNames = 20;
constexpr std::size_t kMostNamesOfRobot =
    2000;  // of a robot in which misspelt names are looked for

SeenCompanion read(const std::string& path, const FileReader& files) {
  SeenCompanion seen;
  const bool is_srdf = is_companion_path(path);
  const FileContent content =
      files.read(path, is_srdf ? Limits{}.srdf_bytes : kMostBytesOfCompanion);
  if (content.status != ReadStatus::ok) return seen;
  seen.is_readable = true;
  SourceMap sources;
  DiagnosticSink ignored;
  Companion companion;
  companion.source = sources.add(path, content.text);
  const std::string_view text = sources.text(companion.source);
  if (is_srdf) {
    seen.what = {&spec_of(CompanionKind::srdf), CompanionState::readable};
    seen.robot = robot_name_in(text);
    if (xacro::is_xacro_file(path)) return seen;
    auto document = parse_xml(sources, companion.source, Limits{}, ignored);
    if (!document) return seen;
    companion.srdf = srdf::read(std::move(*document));
  } else if (may_be_parameters(path)) {
    companion.document = parse_yaml(sources, companion.source, Limits{}, ignored);
    seen.what = recognise(path, text, companion.document, ignored);
    if (seen.what.state != CompanionState::readable) return seen;
    companion.kind = seen.what.spec->kind;
    keep_last_keys(*companion.document, companion.kind == CompanionKind::controllers);
  }
  if (seen.what.spec != nullptr) seen.names = part_names(companion);
  return seen;
}

bool is_known(const CompanionName& one, const LinkedModel& model) {
  const NameTable* table = model.names(one.kind);
  return table != nullptr && table->contains(one.name);
}

/// Whether a name is probably a misspelling of another: variants of a robot have other numbers.
bool is_near(std::string_view name, std::string_view known) {
  constexpr std::size_t kShort = 5;  // letters
  const int limit = name.size() < kShort ? 1 : 2;
  return edit_distance(name, known, limit) <= limit && !differ_only_in_digits(name, known);
}

/// Whether a letter is left out, doubled or exchanged with the next one. Names that differ in one
/// letter, such as `arm_l` and `arm_r`, are two.
bool is_slip(std::string_view name, std::string_view known) {
  if (edit_distance(name, known, 1) > 1 || differ_only_in_digits(name, known)) return false;
  std::string a(name), b(known);
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a.size() != b.size() || a == b;
}

/// What is before the name in the robot, or before that of the robot in the file, with a sign.
std::string prefix_between(std::string_view name, std::string_view known) {
  const auto head = [](std::string_view longer, std::string_view shorter) {
    const bool is_tail = longer.size() > shorter.size() && longer.ends_with(shorter);
    return std::string(is_tail ? longer.substr(0, longer.size() - shorter.size()) : "");
  };
  if (std::string one = head(known, name); !one.empty()) return "+" + one;
  if (std::string one = head(name, known); !one.empty()) return "-" + one;
  return {};
}

/// The prefix that makes more than half of the unknown names known.
std::string common_prefix(const std::vector<const CompanionName*>& unknown,
                          const LinkedModel& model) {
  std::map<std::string, std::size_t> counts;
  for (const CompanionName* one : unknown) {
    std::set<std::string> prefixes;
    for (const std::string_view known : model.names(one->kind)->names()) {
      std::string prefix = prefix_between(one->name, known);
      if (!prefix.empty()) prefixes.insert(std::move(prefix));
    }
    for (const std::string& prefix : prefixes) ++counts[prefix];
  }
  for (const auto& [prefix, count] : counts) {
    if (count > 1 && count * 2 > unknown.size()) return prefix;
  }
  return {};
}

NamesInFolder names_of(std::vector<std::string> all) {
  NamesInFolder found;
  for (std::string& name : all) {
    if (name.starts_with('.') && name.rfind('.') != 0) continue;  // hidden, not .setup_assistant
    const std::string lower = path::to_lower(name);
    const auto ends = [&](std::string_view ending) { return lower.ends_with(ending); };
    if (ends(".urdf")) found.urdfs.push_back(name);
    if (ends(".xacro")) found.xacros.push_back(name);
    if (ends(".srdf") || is_companion_path(name) || may_be_parameters(name)) {
      found.companions.push_back(std::move(name));
    }
  }
  return found;
}

}  // namespace

void keep_last_keys(yaml::Document& document, bool joins) {
  using yaml::NodeId;
  const auto at = [&](NodeId id) -> yaml::Node& {
    return document.nodes[static_cast<std::size_t>(id)];
  };
  const auto is_mapping = [&](NodeId id) {
    return at(id).kind() == yaml::Kind::mapping && !at(id).is_alias();
  };
  /// Puts the members of one mapping before those of the other.
  const auto join = [&](NodeId from, NodeId to) {
    NodeId last = yaml::kNoNode;
    for (NodeId id = at(from).first_child(); id != yaml::kNoNode; id = at(id).next_sibling) {
      at(id).parent = to;
      last = id;
    }
    if (last == yaml::kNoNode) return;
    at(last).next_sibling = at(to).first_child();
    at(to).set_children(at(from).first_child(), at(from).child_count() + at(to).child_count());
    at(from).set_children(yaml::kNoNode, 0);
    at(to).span.begin = std::min(at(from).span.begin, at(to).span.begin);
  };
  // Parents come before their children, and so do those that get children here.
  for (std::size_t i = 0; i < document.nodes.size(); ++i) {
    const NodeId mapping{static_cast<std::uint32_t>(i)};
    if (!is_mapping(mapping)) continue;
    std::map<std::string_view, NodeId> last;
    std::size_t members = 0;
    for (NodeId id = at(mapping).first_child(); id != yaml::kNoNode; id = at(id).next_sibling) {
      const auto [known, is_new] = last.try_emplace(at(id).key(), id);
      ++members;
      if (is_new) continue;
      if (joins && is_mapping(known->second) && is_mapping(id)) join(known->second, id);
      known->second = id;
    }
    if (members == last.size()) continue;
    NodeId first = yaml::kNoNode, previous = yaml::kNoNode;
    for (NodeId id = at(mapping).first_child(); id != yaml::kNoNode; id = at(id).next_sibling) {
      if (last[at(id).key()] != id) continue;
      at(id).is_repeated = false;
      (previous == yaml::kNoNode ? first : at(previous).next_sibling) = id;
      previous = id;
    }
    if (previous != yaml::kNoNode) at(previous).next_sibling = yaml::kNoNode;
    at(mapping).set_children(first, static_cast<std::uint32_t>(last.size()));
  }
}

void convert_degrees(yaml::Document& document, std::string_view text) {
  constexpr std::string_view kTag = "!degrees";
  if (text.find(kTag) == std::string_view::npos) return;
  for (yaml::Node& node : document.nodes) {
    if (node.kind() != yaml::Kind::scalar || node.is_alias()) continue;
    const std::size_t end = text.substr(0, node.span.begin).find_last_not_of(" \t");
    if (end == std::string_view::npos || !text.substr(0, end + 1).ends_with(kTag)) continue;
    const auto degrees = parse_number(node.text());
    if (!degrees) continue;
    std::string radians = format_number(*degrees * std::numbers::pi / 180);
    if (radians.find_first_of(".e") == std::string::npos) radians += ".0";
    node.set_text(document.decoded.emplace_back(std::move(radians)));
  }
}

const SeenCompanion& CompanionLibrary::look_at(const std::string& path, const FileReader& files) {
  const std::string key = path::normalize(path);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = seen_.find(key); known != seen_.end()) return *known->second;
  }
  auto seen = std::make_unique<SeenCompanion>(read(key, files));
  const std::lock_guard lock(mutex_);
  return *seen_.emplace(key, std::move(seen)).first->second;
}

const NamesInFolder& CompanionFolders::names_in(const std::string& folder,
                                                const FileReader& files) {
  const std::string key = path::normalize(folder);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = folders_.find(key); known != folders_.end()) {
      files.rely_on_list(folder, known->second.digest);
      return known->second;
    }
  }
  std::vector<std::string> names = files.list(folder);
  std::string digest = digest_of_names(names);
  NamesInFolder found = names_of(std::move(names));
  found.digest = std::move(digest);
  const std::lock_guard lock(mutex_);
  return folders_.emplace(key, std::move(found)).first->second;
}

NameScore score_of(const std::vector<CompanionName>& names, const LinkedModel& model) {
  NameScore score;
  score.names = names.size();
  std::vector<const CompanionName*> unknown;
  std::set<std::string_view> used;
  for (const CompanionName& one : names) {
    used.insert(one.name);
    if (is_known(one, model)) {
      ++score.known;
    } else {
      unknown.push_back(&one);
    }
  }
  const std::size_t size = model.link_names.names().size() + model.joint_names.names().size();
  if (unknown.empty() || unknown.size() > kMostUnknownNames || size > kMostNamesOfRobot)
    return score;
  for (const CompanionName* one : unknown) {
    const NameTable* table = model.names(one->kind);
    if (table == nullptr) continue;
    const auto& all = table->names();
    const bool has_near = std::any_of(all.begin(), all.end(), [&](std::string_view known) {
      return used.contains(known) ? is_slip(one->name, known) : is_near(one->name, known);
    });
    if (has_near) score.near.insert(one->name);
  }
  if (!is_enough(score)) score.lost_prefix = common_prefix(unknown, model);
  return score;
}

bool is_enough(const NameScore& score) {
  return (score.known * 10 + score.near.size() * 9) * 2 >= score.names * 10;
}

}  // namespace smurf
