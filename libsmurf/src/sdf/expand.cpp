// SPDX-License-Identifier: BSD-3-Clause
// From a file to its result.
#include <string>
#include <utility>

#include "base/findings/rules.hpp"
#include "imports/traced_yaml.hpp"
#include "sdf/model.hpp"
#include "sdf/world.hpp"

namespace smurf::sdformat {
namespace {

constexpr imports::Family kFamily{rules::sml9311_sdformat_refuses, rules::sml9312_sdf_file_missing,
                                  rules::sml9313_sdf_limit, "libsdformat refuses this: "};

/// Keeps the files of a result, whose findings and comments are in them.
void keep_files(Files& files, const SourceMap& sources, xacro::Expansion& result) {
  for (xml::Document& document : files.documents()) {
    result.included.insert(sources.path(document.source));
    result.documents.push_back(std::move(document));
  }
}

/// What a URDF cannot say.
std::string annotations_of(const Model& model, xacro::Expansion& expansion) {
  imports::TracedYaml yaml(expansion);
  for (const Link& link : model.links) {
    if (!link.mass || !(link.mass->mass > 0) || link.mass->inertia != imports::kUnitTensor)
      continue;
    if (yaml.size() == 0) yaml.plain("link:\n");
    imports::keep_inertia(yaml, link.name, link.of_inertia);
  }
  return yaml.take();
}

}  // namespace

bool is_sdf(std::string_view text) { return imports::root_name(text) == "sdf"; }

bool is_world(std::string_view text) {
  return is_sdf(text) && imports::first_name(text) == "world";
}

Imported expand(SourceId root, Context& context) {
  Imported result;
  xacro::Expansion& robot = result.robot;
  robot.root = root;
  robot.language = Language::sdf;
  Reporter reporter(context, kFamily);
  Files files(root, reporter);
  Model model;
  if (build(files, model) && !reporter.has_refused()) {
    resolve(model, reporter);
    arrange(model, reporter);
    weigh(model, files, reporter);
    robot.frames = std::move(model.frames);
    std::string text = write_robot(model, files, reporter, robot);
    robot.is_complete = !reporter.has_refused();
    xacro::Expansion& annotations = result.annotations;
    std::string sections = annotations_of(model, annotations);
    annotations.root = root;
    annotations.language = Language::sdf;
    annotations.frames = robot.frames;
    annotations.is_complete = robot.is_complete && !sections.empty();
    const std::string& path = context.sources.path(root);
    if (annotations.is_complete)
      annotations.source = context.sources.add(path, std::move(sections));
    robot.source = context.sources.add(path, std::move(text));
  }
  keep_files(files, context.sources, robot);
  return result;
}

World expand_world(SourceId root, Context& context) {
  World result;
  result.scene.root = root;
  result.scene.language = Language::sdf;
  Reporter reporter(context, kFamily);
  Files files(root, reporter);
  Model model;
  if (build(files, model) && !reporter.has_refused()) {
    resolve(model, reporter);
    arrange(model, reporter);
    weigh(model, files, reporter);
    result.scene.frames = model.frames;
    write_world(model, files, reporter, result);
    result.scene.is_complete = !reporter.has_refused();
  }
  keep_files(files, context.sources, result.scene);
  return result;
}

}  // namespace smurf::sdformat
