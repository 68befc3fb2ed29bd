// SPDX-License-Identifier: BSD-3-Clause
// From a file to its result.
#include <utility>

#include "base/findings/rules.hpp"
#include "sdf/model.hpp"
#include "sdf/sdf.hpp"

namespace smurf::sdformat {
namespace {

constexpr imports::Family kFamily{rules::sml9311_sdformat_refuses, rules::sml9312_sdf_file_missing,
                                  rules::sml9313_sdf_limit, "libsdformat refuses this: "};

}  // namespace

bool is_sdf(std::string_view text) { return imports::root_name(text) == "sdf"; }

Imported expand(SourceId root, Context& context) {
  Imported result;
  xacro::Expansion& robot = result.robot;
  robot.root = root;
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
    robot.source = context.sources.add(context.sources.path(root), std::move(text));
  }
  for (xml::Document& document : files.documents()) {
    robot.included.insert(context.sources.path(document.source));
    robot.documents.push_back(std::move(document));
  }
  return result;
}

}  // namespace smurf::sdformat
