// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || model.main.modelname.written || model.files.empty()) return;
  const std::optional<yaml::Document>& document = model.files.front().document;
  if (!document || !document->view() || !document->view().is_mapping()) return;
  const yaml::View first = *document->view().begin();
  findings.report(first ? first.key_span() : document->view().span(),
                  "the main file has no `modelname`");
}

}  // namespace

extern constinit const Rule sml7009_modelname_missing{
    .id = "SML7009",
    .name = "modelname-missing",
    .severity = Severity::error,
    .summary = "The main file has no modelname.",
    .why = "Phobos 2 asks for it and stops with a KeyError; the MARS generations do not read it.",
    .remedy = "Add `modelname:`.",
    .sources = "Phobos io/smurfrobot.py:166.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
