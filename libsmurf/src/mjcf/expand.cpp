// SPDX-License-Identifier: BSD-3-Clause
// From a file to its results.
#include <utility>

#include "base/findings/rules.hpp"
#include "mjcf/mjcf.hpp"
#include "mjcf/robot.hpp"

namespace smurf::mjcf {
namespace {

constexpr imports::Family kFamily{rules::sml9301_mujoco_refuses, rules::sml9302_mjcf_file_missing,
                                  rules::sml9303_mjcf_limit, "MuJoCo refuses this: "};

}  // namespace

bool is_mjcf(std::string_view text) {
  const std::string_view name = imports::root_name(text);
  return name == "mujoco" || name == "mujocoinclude";
}

bool is_part(std::string_view text) { return imports::root_name(text) == "mujocoinclude"; }

Imported expand(SourceId root, Context& context) {
  Imported result;
  xacro::Expansion& robot = result.robot;
  robot.root = root;
  robot.language = Language::mjcf;
  Reporter reporter(context, kFamily);
  Model model;
  const std::string path = context.sources.path(root);
  if (build(root, reporter, model)) {
    check_references(model, reporter);
    check_refusals(model, reporter);
    report_slips(model, reporter);
    weigh(model, reporter);
    arrange(model);
    name_all(model);
    tune_springs(model, reporter);
    add_actuators(model, reporter);
    JointFacts facts = facts_of_joints(model, reporter);
    robot.frames = std::move(model.frames);
    if (!reporter.lacks_file()) model.files.front().report_unused_classes();
    std::string text = write_robot(model, facts, reporter, robot);
    result.excluded = std::move(facts.excluded);
    xacro::Expansion& annotations = result.annotations;
    // Of half a model, everything would be lost.
    std::string sections =
        reporter.lacks_file() ? std::string() : write_annotations(model, reporter, annotations);
    robot.is_complete = !reporter.has_refused();
    if (!reporter.lacks_file()) report_unsaid(model, reporter);
    annotations.root = root;
    annotations.language = Language::mjcf;
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
