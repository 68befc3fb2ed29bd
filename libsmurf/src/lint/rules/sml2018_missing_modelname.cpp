// SPDX-License-Identifier: BSD-3-Clause
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || model.files.empty() || !model.files.front().document) return;
  const yaml::View root = model.files.front().document->view();
  if (!root || !root.is_mapping() || root.size() == 0) return;
  if (has_misspelt(root, "modelname")) return;
  const Field<std::string>& name = model.main.modelname;
  if (name.written && (!name || !name->empty())) return;
  const yaml::View written = root.find("modelname");
  const Span place = written ? written.key_span() : (*root.begin()).key_span();
  findings.report(place, "the main file has no `modelname`").help =
      "name the model like its URDF's robot";
}

}  // namespace

extern constinit const Rule sml2018_missing_modelname{
    .id = "SML2018",
    .name = "missing-modelname",
    .severity = Severity::warning,
    .summary = "A main file does not name its model.",
    .why = "Phobos takes the name of the robot from `modelname` and stops with a KeyError "
           "without it; MARS 2 and rock-cpp/smurf name what they load by it. MARS takes the name"
           " of the entity.",
    .remedy = "Add `modelname`.",
    .sources = "Phobos io/smurfrobot.py:166; rock-cpp/smurf Robot.cpp:33-39; envire_smurf_loader "
               "Model.cpp:94-97.",
    .check_model = check};

}  // namespace smurf::rules
