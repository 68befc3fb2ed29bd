// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml2014_ignored_file_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  constexpr std::string_view kKinds[] = {".urdf", ".yml", ".yaml", ".json"};
  if (!model.main.files) return;
  for (const Spanned<std::string>& file : *model.main.files) {
    const std::string extension = path::to_lower(path::extension(file.value));
    if (std::find(std::begin(kKinds), std::end(kKinds), extension) != std::end(kKinds)) continue;
    const bool is_model = extension == ".sdf" || extension == ".xacro";
    if (is_model && model.urdf_path.empty()) continue;  // SML2003 reports this
    Diagnostic& diagnostic = findings.report(file.span, "MARS ignores " + quoted(file.value) +
                                                            ": it is not a .urdf or .yml");
    if (extension == ".sdf") {
      diagnostic.note("Phobos reads it instead of a URDF");
    } else {
      diagnostic.note("Phobos treats it as an annotation file");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::ignores,
     "reads .urdf and .yml, and ignores everything else without a message",
     "smurf_parser SMURFParser.cpp:49-52, run"},
    {&readers::phobos, Effect::refuses,
     "treats it as an annotation file, and stops with an exception",
     "Phobos io/smurfrobot.py:179-197, run"},
};

}  // namespace

extern constinit const Rule sml2014_ignored_file{
    .id = "SML2014",
    .name = "ignored-file",
    .severity = Severity::warning,
    .summary = "`files` lists a file of a kind that MARS ignores.",
    .remedy = "Remove the file from `files`; name it under a custom key if a program needs it.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml2014_ignored_file_file
