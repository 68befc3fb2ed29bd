// SPDX-License-Identifier: BSD-3-Clause
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const TopLevelKey& key : top_level_keys(model)) {
    const bool is_list = key.value.is_sequence() || key.value.is_mapping();
    if (key.file.kind != ModelFile::Kind::annotation || key.value.key() != "files" || !is_list)
      continue;
    findings.report(key.value.key_span(), "only the main file lists `files`").help =
        "list them in the .smurf";
  }
}

}  // namespace

extern constinit const Rule sml2010_files_in_annotation_file{
    .id = "SML2010",
    .name = "files-in-annotation-file",
    .severity = Severity::error,
    .summary = "An annotation file has a `files` list.",
    .why = "MARS appends it to the list that it is walking through, which is undefined "
           "behaviour; nobody else reads it.",
    .remedy = "List the files in the main file.",
    .sources = "smurf_parser SMURFParser.cpp:43-69.",
    .check_model = check};

}  // namespace smurf::rules
