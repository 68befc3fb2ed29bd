// SPDX-License-Identifier: BSD-3-Clause
// Frames in configurations of RViz.
// Sources: rviz robot.cpp, frame_manager.cpp, tf_display.cpp, branches noetic to rolling; moveit2
// motion_planning_display.cpp.
#include <string_view>

#include "base/text/words.hpp"
#include "link/surroundings/frame_names.hpp"

namespace smurf {
namespace {

using Use = FrameName::Use;

void take_key(yaml::View member, std::string_view key, const TakeFrame& take) {
  if (member.is_repeated()) return;
  FrameName frame;
  frame.use = Use::memory;
  frame.name = member.key();
  frame.place = place_of_key(member);
  frame.written = member.key_span();
  frame.key = key;
  take(frame);
}

void take_value(yaml::View value, Use use, NameKinds kinds, const TakeFrame& take) {
  FrameName frame;
  frame.use = use;
  frame.kinds = kinds;
  frame.name = value.text();
  frame.place = place_of_name(value);
  frame.written = value.span();
  frame.key = value.key();
  take(frame);
}

// The recursions are as deep as the file, whose depth is limited.
/// The frames of a display of TF, one below the other.
void visit_tree(yaml::View value, const TakeFrame& take) {
  if (!value.is_mapping()) return;
  for (const yaml::View member : value) {
    take_key(member, "Tree", take);
    visit_tree(member, take);
  }
}

void visit(yaml::View value, const TakeFrame& take) {
  if (!value.is_mapping() && !value.is_sequence()) return;
  for (const yaml::View member : value) {
    const std::string_view key = value.is_mapping() ? member.key() : std::string_view();
    if (key == "Tree" && member.is_mapping()) {
      visit_tree(member, take);
    } else if (is_one_of(key, {"Links", "Frames"}) && member.is_mapping()) {
      for (const yaml::View one : member) take_key(one, key, take);
    } else if (key == "Fixed Frame" && member.is_scalar()) {
      const bool is_global = value.key() == "Global Options";
      take_value(member, is_global ? Use::sensor : Use::other, NameKind::link, take);
    } else if (is_one_of(key, {"Reference Frame", "Target Frame"}) && member.is_scalar()) {
      take_value(member, Use::other, NameKind::link, take);
    } else if (key == "Planning Group" && member.is_scalar()) {
      take_value(member, Use::other, NameKind::group, take);
    } else {
      visit(member, take);
    }
  }
}

}  // namespace

bool is_rviz(std::string_view text) {
  return text.find("Visualization Manager:") != std::string_view::npos;
}

void visit_rviz(const FrameFile& file, const TakeFrame& take) {
  const yaml::View root = file.document ? file.document->view() : yaml::View();
  if (root && root.is_mapping()) visit(root, take);
}

}  // namespace smurf
