// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || !model.urdf_path.empty() || model.files.empty()) return;
  const ModelFile& main = model.files.front();
  if (!main.document || !main.document->view() || !main.document->view().is_mapping()) return;
  if (model.main.files.written && !model.main.files) return;  // its shape is wrong, reported
  const Span place = model.main.files.written ? main.document->view().find("files").key_span()
                                              : Span{main.source, 0, 0};
  findings.report(place, model.main.files.written ? "`files` lists no URDF"
                                                  : "the main file has no `files`");
}

}  // namespace

extern constinit const Rule sml2003_no_urdf{
    .id = "SML2003",
    .name = "no-urdf",
    .severity = Severity::error,
    .summary = "A main file lists no URDF.",
    .why = "MARS parses an empty path and dereferences the null model; Phobos has no robot.",
    .remedy = "List the URDF under `files`.",
    .sources = "smurf_parser SMURFParser.cpp:77, MARS smurf.cpp:988-998 (run).",
    .check_model = check};

}  // namespace smurf::rules
