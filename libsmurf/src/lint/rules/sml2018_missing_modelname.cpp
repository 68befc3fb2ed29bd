// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml2018_missing_modelname_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || model.files.empty() || !model.files.front().document) return;
  const yaml::View root = model.files.front().document->view();
  if (!root || !root.is_mapping() || root.size() == 0) return;
  if (is_slip(root, "modelname", findings)) return;
  const Field<std::string>& name = model.main.modelname;
  if (name.written && (!name || !name->empty())) return;
  const yaml::View written = root.find("modelname");
  const Span place = written ? written.key_span() : (*root.begin()).key_span();
  findings.report(place, "the main file has no `modelname`")
      .help("use the name of the robot in its URDF");
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "uses the name of the entity", "MARS smurf.cpp"},
    {&readers::mars2, Effect::changes, "names the loaded model by it",
     "envire_smurf_loader Model.cpp:94-97"},
    {&readers::envire, Effect::changes, "names the loaded model by it",
     "rock-cpp/smurf Robot.cpp:33-39"},
    {&readers::phobos, Effect::takes, "uses it unchanged", kRun, at("modelname")},
    {&readers::phobos, Effect::refuses, "stops with a KeyError", "Phobos io/smurfrobot.py:166"},
};

}  // namespace

extern constinit const Rule sml2018_missing_modelname{.id = "SML2018",
                                                      .name = "missing-modelname",
                                                      .severity = Severity::warning,
                                                      .summary =
                                                          "A main file does not name its model.",
                                                      .remedy = "Add `modelname`.",
                                                      .check_model = check,
                                                      .facts = kFacts};

}  // namespace smurf::rules::sml2018_missing_modelname_file
