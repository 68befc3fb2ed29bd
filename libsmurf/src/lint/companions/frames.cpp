// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/frames.hpp"

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"

namespace smurf {

std::optional<std::string_view> like_name(std::string_view name,
                                          std::span<const std::string_view> known) {
  const std::size_t end = name.rfind('_');
  const std::string_view stem = name.substr(0, end);
  if (end == std::string_view::npos || stem.find('_') == std::string_view::npos)
    return std::nullopt;
  std::optional<std::string_view> found;
  for (const std::string_view one : known) {
    if (one.substr(0, one.rfind('_')) != stem || one == stem) continue;
    if (found) return std::nullopt;
    found = one;
  }
  return found;
}

bool is_world_frame(std::string_view frame) {
  return is_one_of(frame, {"odom", "map", "world", "earth", "utm", "enu", "odom_combined"});
}

std::string_view root_link(const LinkedModel& model) {
  std::string_view root;
  if (!model.robot) return root;
  for (std::size_t i = 0; i < model.robot->links.size(); ++i) {
    if (model.tree.parent_joint[i]) continue;
    if (!root.empty()) return {};
    if (const auto& name = model.robot->links[i].name) root = *name;
  }
  return root;
}

Diagnostic* check_frame(const LinkedModel& model, std::string_view frame, Span place,
                        const std::string& subject, Findings& findings) {
  if (!model.robot || frame.empty() || is_placeholder(frame)) return nullptr;
  const bool has_slash = frame.front() == '/';
  if (has_slash) frame.remove_prefix(1);
  const bool is_link = model.link_names.contains(frame);
  if (has_slash && (is_link || is_world_frame(frame))) {
    Diagnostic& found =
        findings.report(place, subject + " names the frame " + quoted("/" + std::string(frame)) +
                                   "; names of frames do not begin with a slash");
    found.severity = Severity::warning;
    found.when(kSlashedFrame);
    found.help("write " + quoted(frame));
    return &found;
  }
  if (has_slash || is_link || is_world_frame(frame) || frame.find('/') != std::string_view::npos) {
    return nullptr;
  }
  Diagnostic& found = findings.report(place, subject + " names the frame " + quoted(frame) +
                                                 ", which is no link of the robot");
  if (const auto near = near_name(frame, model.link_names.names())) {
    found.when(kMisspeltFrame);
    found.help("did you mean " + quoted(*near) + "?");
    found.fixes.push_back({Applicability::unsafe, {{place, std::string(*near)}}});
    return &found;
  }
  found.severity = Severity::info;
  if (const auto like = like_name(frame, model.link_names.names())) {
    found.help("did you mean " + quoted(*like) + "?");
    return &found;
  }
  const std::string_view root = root_link(model);
  found.help(root.empty() ? std::string("write the name of a link")
                          : "write the name of a link; the root of the robot is " + quoted(root));
  return &found;
}

}  // namespace smurf
