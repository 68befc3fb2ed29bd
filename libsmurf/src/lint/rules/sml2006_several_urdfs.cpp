// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml2006_several_urdfs_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.main.files) return;
  const Spanned<std::string>* last = nullptr;
  for (const Spanned<std::string>& file : *model.main.files) {
    if (path::to_lower(path::extension(file.value)) != ".urdf") continue;
    if (last != nullptr && last->value != file.value) {
      Diagnostic& diagnostic =
          findings.report(file.span, "MARS reads this URDF instead of " + quoted(last->value));
      diagnostic.label(last->span, "the URDF before it");
      diagnostic.note("Phobos refuses two URDFs");
    }
    last = &file;
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "uses the last one",
     "smurf_parser SMURFParser.cpp:49-51, run"},
    {&readers::phobos, Effect::refuses,
     "stops with an assertion, or uses the first when they are adjacent",
     "Phobos io/smurfrobot.py:174-190, run"},
};

}  // namespace

extern constinit const Rule sml2006_several_urdfs{.id = "SML2006",
                                                  .name = "several-urdfs",
                                                  .severity = Severity::error,
                                                  .summary = "`files` lists more than one URDF.",
                                                  .remedy = "List one URDF.",
                                                  .check_model = check,
                                                  .facts = kFacts};

}  // namespace smurf::rules::sml2006_several_urdfs_file
