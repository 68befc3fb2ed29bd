// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml2010_files_in_annotation_file_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const TopLevelKey& key : top_level_keys(model)) {
    const bool is_list = key.value.is_sequence() || key.value.is_mapping();
    if (key.file.kind != ModelFile::Kind::annotation || key.value.key() != "files" || !is_list)
      continue;
    findings.report(key.value.key_span(), "only the main file lists `files`")
        .help("list them in the .smurf");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "appends it to the list that it is walking through, which is undefined behaviour",
     "smurf_parser SMURFParser.cpp:43-69"},
    {&readers::phobos, Effect::ignores, "does not read it", "Phobos io/smurfrobot.py"},
};

}  // namespace

extern constinit const Rule sml2010_files_in_annotation_file{
    .id = "SML2010",
    .name = "files-in-annotation-file",
    .severity = Severity::error,
    .summary = "An annotation file has a `files` list.",
    .remedy = "List the files in the main file.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml2010_files_in_annotation_file_file
