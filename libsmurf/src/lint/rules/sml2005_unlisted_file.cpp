// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/counted.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml2005_unlisted_file_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  // A file that is missing may be one of these under a wrong name, and is reported.
  if (!model.has_main || !model.main.files || !model.is_complete) return;
  if (model.unlisted_files.empty()) return;
  const std::size_t others = model.unlisted_files.size() - 1;
  std::string who = quoted(model.unlisted_files.front());
  if (others > 0) who += " and " + counted(others, "other");
  Diagnostic& diagnostic =
      findings.report(model.files.front().document->view().find("files").key_span(),
                      who +
                          (others == 0 ? " lies beside the main file but is"
                                       : " lie beside the main file but are") +
                          " not listed");
  diagnostic.note("readers load only what `files` lists");
  diagnostic.help(others == 0 ? "list it, or delete it" : "list them, or delete them");
}

}  // namespace

extern constinit const Rule sml2005_unlisted_file{
    .id = "SML2005",
    .name = "unlisted-file",
    .severity = Severity::warning,
    .summary = "An annotation file lies beside the main file but is not listed.",
    .why = "Readers load only the files in `files`, so these annotations have no effect.",
    .remedy = "List it under `files`, or delete it.",
    .sources = "smurf_parser SMURFParser.cpp:43-69; Phobos io/smurfrobot.py:171.",
    .check_model = check};

}  // namespace smurf::rules::sml2005_unlisted_file_file
