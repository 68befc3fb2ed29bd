// SPDX-License-Identifier: BSD-3-Clause
// From a file to its results.
#include <algorithm>
#include <iterator>

#include "base/text/words.hpp"
#include "mjcf/mjcf.hpp"
#include "mjcf/robot.hpp"

namespace smurf::mjcf {
namespace {

/// What follows comments, declarations and blanks.
std::string_view root_name(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  while (true) {
    text = text.substr(std::min(text.find('<'), text.size()));
    const std::string_view end = text.starts_with("<!--") ? "-->"
                                 : text.starts_with("<?") ? "?>"
                                 : text.starts_with("<!") ? ">"
                                                          : "";
    if (end.empty()) break;
    const std::size_t at = text.find(end, 2);
    if (at == std::string_view::npos) return {};
    text.remove_prefix(at + end.size());
  }
  if (text.empty()) return {};
  text.remove_prefix(1);
  return text.substr(0, std::min(text.find_first_of(" \t\r\n/>"), text.size()));
}

}  // namespace

bool is_mjcf(std::string_view text) {
  const std::string_view name = root_name(text);
  return name == "mujoco" || name == "mujocoinclude";
}

bool is_made(const xacro::Expansion& result, Span part) {
  const auto after =
      std::upper_bound(result.leaves.begin(), result.leaves.end(), part.begin,
                       [](std::uint32_t at, const xacro::Leaf& leaf) { return at < leaf.begin; });
  if (after == result.leaves.begin()) return false;
  return std::prev(after)->first_input == kMade && std::prev(after)->inputs == 0;
}

Imported expand(SourceId root, Context& context) {
  Imported result;
  xacro::Expansion& robot = result.robot;
  robot.root = root;
  Reporter reporter(context);
  Model model;
  const std::string path = context.sources.path(root);
  if (build(root, reporter, model)) {
    check_references(model, reporter);
    weigh(model, reporter);
    arrange(model);
    name_all(model);
    tune_springs(model, reporter);
    const JointFacts facts = facts_of_joints(model, reporter);
    robot.frames = std::move(model.frames);
    model.files.front().report_unused_classes();
    std::string text = write_robot(model, facts, reporter, robot);
    xacro::Expansion& annotations = result.annotations;
    std::string sections = write_annotations(model, reporter, annotations);
    robot.is_complete = !reporter.has_refused();
    annotations.root = root;
    annotations.frames = robot.frames;
    annotations.is_complete = robot.is_complete && !sections.empty();
    if (annotations.is_complete)
      annotations.source = context.sources.add(path, std::move(sections));
    robot.source = context.sources.add(path, std::move(text));
  }
  for (ModelFile& file : model.files) {
    for (xml::Document& document : file.documents()) {
      robot.included.insert(context.sources.path(document.source));
      robot.documents.push_back(std::move(document));
    }
  }
  return result;
}

}  // namespace smurf::mjcf
