// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/frames.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4501_frame_unknown_file {
namespace {

constexpr Circumstance kOutside{"outside"};
constexpr Circumstance kPrefix{"prefix"};

/// A key that names a link of the robot, by the node around it; "": any node.
constexpr struct {
  std::string_view node, key;
} kRobotFrames[] = {
    {"", "robot_base_frame"},       {"", "base_frame_id"},
    {"", "base_link_frame"},        {"", "base_link_frame_output"},
    {"slam_toolbox", "base_frame"}, {"docking_server", "base_frame"},
    {"route_server", "base_frame"},
};
/// Keys of frames around the robot.
bool is_outside_key(std::string_view key) {
  return is_one_of(key, {"global_frame", "global_frame_id", "local_frame", "odom_frame_id",
                         "odom_frame", "fixed_frame", "map_frame", "route_frame"});
}

class Check {
 public:
  Check(const LinkedModel& model, const Surroundings& all, Findings& findings)
      : model_(model), all_(all), findings_(findings) {}

  void file(const FrameFile& file) {
    told_prefixes_.clear();
    if (file.form == FrameFile::Form::lua) {
      lua(file);
    } else if (file.document && file.document->view() && file.document->view().is_mapping()) {
      if (file.form == FrameFile::Form::parameters) mapping(file.document->view(), "", 0);
      if (file.form == FrameFile::Form::rviz) rviz(file.document->view());
    }
  }

 private:
  // The recursion is as deep as the file, whose depth is limited.
  void mapping(yaml::View value, std::string_view node, int depth) {
    for (const yaml::View member : value) {
      const std::string_view key = member.key();
      if (member.is_mapping()) {
        const bool is_node = node.empty() || node == "/**";
        mapping(member, is_node && key != "ros__parameters" ? key : node, depth + 1);
      } else if (member.is_scalar()) {
        for (const auto& one : kRobotFrames) {
          if (one.key == key && (one.node.empty() || one.node == node)) {
            base(member.text(), member.span(), quoted(key) + " of " + quoted(node));
            break;
          }
        }
        if (key == "sensor_frame") near_only(member.text(), member.span(), quoted(key));
        if (is_outside_key(key)) outside(member, node);
      }
    }
  }

  void base(std::string_view frame, Span place, const std::string& subject) {
    if (frame.empty() || is_placeholder(frame)) return;
    const std::size_t slash = frame.rfind('/');
    if (slash != std::string_view::npos && slash > 0) {
      prefix(frame, slash, place);
      return;
    }
    if (is_published_elsewhere(all_, frame)) return;
    Diagnostic* found = check_frame(model_, frame, place, subject, findings_);
    if (found == nullptr || found->severity != Severity::info) return;
    const bool is_whole =
        model_.is_complete && !root_link(model_).empty() && !all_.has_frame_prefix;
    if (is_whole) found->severity = Severity::warning;
  }

  void near_only(std::string_view frame, Span place, const std::string& subject) {
    if (frame.empty() || frame.find('/') != std::string_view::npos) return;
    if (model_.link_names.contains(frame) || is_published_elsewhere(all_, frame)) return;
    if (near_name(frame, model_.link_names.names()))
      check_frame(model_, frame, place, subject, findings_);
  }

  /// `robot1/base_link`, if no node publishes frames with this prefix.
  void prefix(std::string_view frame, std::size_t slash, Span place) {
    const std::string_view link = frame.substr(slash + 1);
    const std::string head(frame.substr(0, slash + 1));
    if (all_.has_frame_prefix || all_.launch_files.empty() || !model_.link_names.contains(link))
      return;
    if (is_published_elsewhere(all_, frame) || !told_prefixes_.insert(head).second) return;
    findings_
        .report(place, "the frames of this file begin with " + quoted(head) +
                           ", but no launch file gives the robot this prefix")
        .when(kPrefix)
        .help("write " + quoted(link) + ", or add `frame_prefix` to robot_state_publisher");
  }

  /// Frames that other nodes publish: only what is nearly one of their usual names.
  void outside(yaml::View value, std::string_view node) {
    const std::string_view frame = value.text();
    constexpr std::string_view kUsual[] = {"odom", "map"};
    const bool is_short = frame.size() >= 3 && frame.size() <= 5;
    if (!is_short || is_world_frame(frame) || model_.link_names.contains(frame) ||
        is_published_elsewhere(all_, frame)) {
      return;
    }
    for (const std::string_view one : kUsual) {
      if (edit_distance(frame, one, 1) > 1 || (one == "map" && frame.size() > 4)) continue;
      Diagnostic& found =
          findings_.report(value.span(), quoted(value.key()) + " of " + quoted(node) +
                                             " names the frame " + quoted(frame));
      found.severity = Severity::warning;
      found.when(kOutside).help("did you mean " + quoted(one) + "?");
      return;
    }
  }

  void rviz(yaml::View root) {
    const yaml::View manager = root.find("Visualization Manager");
    const yaml::View options =
        manager && manager.is_mapping() ? manager.find("Global Options") : yaml::View();
    const yaml::View frame =
        options && options.is_mapping() ? options.find("Fixed Frame") : yaml::View();
    if (frame && frame.is_scalar()) near_only(frame.text(), frame.span(), "`Fixed Frame`");
  }

  void lua(const FrameFile& file) {
    for (const std::string_view key : {"tracking_frame", "published_frame"}) {
      std::size_t at = file.text.find(key);
      if (at == std::string_view::npos) continue;
      at = file.text.find('=', at);
      const std::size_t open = file.text.find_first_of("\"'\n", std::min(at, file.text.size()));
      if (open == std::string_view::npos || file.text[open] == '\n') continue;
      const std::size_t close = file.text.find(file.text[open], open + 1);
      if (close == std::string_view::npos) continue;
      const Span place{file.source, static_cast<std::uint32_t>(open + 1),
                       static_cast<std::uint32_t>(close)};
      near_only(file.text.substr(open + 1, close - open - 1), place, quoted(key));
    }
  }

  const LinkedModel& model_;
  const Surroundings& all_;
  Findings& findings_;
  std::set<std::string> told_prefixes_;
};

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot || model.robot->links.size() < 2) return;
  Check check(model, companions.surroundings, findings);
  for (const FrameFile& one : companions.surroundings.frame_files) check.file(one);
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "waits for a transform from a frame that does not exist",
     "navigation2, robot_localization and slam_toolbox: parameters of the nodes; geometry2 buffer_core.cpp"},
};

}  // namespace

extern constinit const Rule sml4501_frame_unknown{
    .id = "SML4501",
    .name = "frame-unknown",
    .severity = Severity::warning,
    .summary = "A file of navigation or RViz names a frame that is no link of the robot.",
    .why = "Nodes wait for the transform without an error.",
    .remedy = "Write the name of a link, usually of the root.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4501_frame_unknown_file
