// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || !model.main.files) return;
  for (const std::string& file : model.unlisted_files) {
    Diagnostic& diagnostic =
        findings.report(model.files.front().document->view().find("files").key_span(),
                        quoted(file) + " lies beside the main file but is not listed");
    diagnostic.notes.push_back("readers load only what `files` lists");
    diagnostic.help = "list it, or delete it";
  }
}

}  // namespace

extern constinit const Rule sml2005_unlisted_file{
    .id = "SML2005",
    .name = "unlisted-file",
    .severity = Severity::warning,
    .summary = "An annotation file lies beside the main file but is not listed.",
    .why = "Readers load only what `files` lists: the annotations in it have no effect.",
    .remedy = "List it under `files`, or delete it.",
    .sources = "smurf_parser SMURFParser.cpp:43-69; Phobos io/smurfrobot.py:171.",
    .check_model = check};

}  // namespace smurf::rules
