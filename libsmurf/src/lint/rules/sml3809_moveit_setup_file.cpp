// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3809_moveit_setup_file_file {
namespace {

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for (const Companion& file : companions.files) {
    for (const yaml::NodeId id : file.missing) {
      const yaml::View path(*file.document, id);
      findings.report(path.span(), "there is no file " + quoted(path.text()) + " in the package")
          .help("correct the path, or start the Setup Assistant again");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::ignores,
     "does not read the file; the Setup Assistant cannot open the package",
     "moveit2 moveit_setup_framework urdf_config.cpp, srdf_config.cpp"},
};

}  // namespace

extern constinit const Rule sml3809_moveit_setup_file{
    .id = "SML3809",
    .name = "moveit-setup-file",
    .severity = Severity::info,
    .summary = "A file that `.setup_assistant` names does not exist.",
    .remedy = "Correct the path.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3809_moveit_setup_file_file
