// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include "base/text/suggest.hpp"
#include "link/surroundings/frame_names.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/frames.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4501_frame_unknown_file {
namespace {

constexpr Circumstance kOutside{"outside"};
constexpr Circumstance kPrefix{"prefix"};

class Check {
 public:
  Check(const LinkedModel& model, const Surroundings& all, Findings& findings)
      : model_(model), all_(all), findings_(findings) {}

  void file(const FrameFile& file) {
    told_prefixes_.clear();
    for_each_frame(file, [&](const FrameName& frame) {
      using Use = FrameName::Use;
      switch (frame.use) {
      case Use::robot:
        base(frame.name, frame.written, quoted(frame.key) + " of " + quoted(frame.node));
        break;
      case Use::sensor: near_only(frame.name, frame.written, quoted(frame.key)); break;
      case Use::outside: outside(frame); break;
      case Use::parent:
      case Use::child:
      case Use::other:
      case Use::memory: break;
      }
    });
  }

 private:
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
  void outside(const FrameName& one) {
    const std::string_view frame = one.name;
    constexpr std::string_view kUsual[] = {"odom", "map"};
    const bool is_short = frame.size() >= 3 && frame.size() <= 5;
    if (!is_short || is_world_frame(frame) || model_.link_names.contains(frame) ||
        is_published_elsewhere(all_, frame)) {
      return;
    }
    for (const std::string_view usual : kUsual) {
      if (edit_distance(frame, usual, 1) > 1 || (usual == "map" && frame.size() > 4)) continue;
      Diagnostic& found =
          findings_.report(one.written, quoted(one.key) + " of " + quoted(one.node) +
                                            " names the frame " + quoted(frame));
      found.severity = Severity::warning;
      found.when(kOutside).help("did you mean " + quoted(usual) + "?");
      return;
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
