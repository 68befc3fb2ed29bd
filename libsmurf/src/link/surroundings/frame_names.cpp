// SPDX-License-Identifier: BSD-3-Clause
#include "link/surroundings/frame_names.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "smurf/companions.hpp"

namespace smurf {
namespace {

/// In the order of FrameFile::Form.
constexpr std::array kFrameForms = {
    FrameForm{FrameFile::Form::parameters, ".yaml .yml", true, is_frame_parameters,
              visit_parameters},
    FrameForm{FrameFile::Form::rviz, ".rviz", true, is_rviz, visit_rviz},
    FrameForm{FrameFile::Form::lua, ".lua", false, is_cartographer, visit_lua},
};

/// Adds the names of files around the robot.
class Surrounding {
 public:
  Surrounding(const LinkedModel& model, const Companions& companions)
      : finder_(model, ReferenceFinder::Keep::all) {
    for (const Companion& one : companions.files) {
      read_.insert(one.source);
      if (one.srdf) finder_.add_groups(*one.srdf);
    }
  }

  template <class File>
  void read(const File& file, SourceId source) {
    if (file.whose == Whose::others || read_.contains(source)) return;
    for_each_frame(file, [&](const FrameName& frame) {
      std::string_view name = frame.name;
      NamePlace place = frame.place;
      // In ROS 1 frames may begin with a slash.
      if (name.starts_with('/')) {
        name.remove_prefix(1);
        place = part_of(place, 1, name.size());
      }
      if (name.empty()) return;
      const bool is_memory = frame.use == FrameName::Use::memory;
      finder_.set_around(file.whose == Whose::own ? Reference::Around::own
                         : is_memory              ? Reference::Around::memory
                                                  : Reference::Around::any);
      finder_.add_if_known(frame.kinds, name, place);
    });
  }

  std::vector<Reference> take() { return finder_.take(); }

 private:
  ReferenceFinder finder_;
  std::set<SourceId> read_;  ///< companions, whose names are found elsewhere
};

}  // namespace

const FrameForm* find_frame_form(std::string_view path) {
  const std::string extension = path::to_lower(path::extension(path));
  for (const FrameForm& form : kFrameForms) {
    std::size_t at = 0;
    for (std::string_view one = next_word(form.extensions, at); !one.empty();
         one = next_word(form.extensions, at)) {
      if (one == extension) return &form;
    }
  }
  return nullptr;
}

void for_each_frame(const FrameFile& file, const TakeFrame& take) {
  kFrameForms[static_cast<std::size_t>(file.form)].visit(file, take);
}

bool may_hold_link(std::string_view key) {
  constexpr std::string_view kEnds[] = {"frame_id", "frame", "link", "tip", "root"};
  return std::any_of(std::begin(kEnds), std::end(kEnds),
                     [&](std::string_view end) { return key.ends_with(end); });
}

std::vector<Reference> surrounding_references(const LinkedModel& model,
                                              const Companions& companions) {
  Surrounding names(model, companions);
  for (const LaunchFile& one : companions.surroundings.launch_files) names.read(one, one.source);
  for (const FrameFile& one : companions.surroundings.frame_files) names.read(one, one.source);
  return names.take();
}

}  // namespace smurf
