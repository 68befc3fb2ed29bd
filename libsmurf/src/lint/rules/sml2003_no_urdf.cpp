// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/text/how_to_expand.hpp"
#include "lint/annotation_queries.hpp"
#include "smurf/xacro.hpp"

namespace smurf::rules::sml2003_no_urdf_file {
namespace {

/// The file in place of the URDF, which must be converted to one first.
const Spanned<std::string>* other_source(const NameList& files) {
  const auto found = std::find_if(files.begin(), files.end(), [](const auto& file) {
    const std::string extension = path::to_lower(path::extension(file.value));
    return extension == ".xacro" || extension == ".sdf";
  });
  return found == files.end() ? nullptr : &*found;
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || !model.urdf_path.empty() || model.files.empty()) return;
  const ModelFile& main = model.files.front();
  if (!main.document || !main.document->view() || !main.document->view().is_mapping()) return;
  if (!model.main.files) return;  // missing or of a wrong shape: reported where it is read
  const yaml::View root = main.document->view();
  if (const Spanned<std::string>* other = other_source(*model.main.files)) {
    findings
        .report(other->span, "MARS ignores " + quoted(other->value) + ", so `files` lists no URDF")
        .help(xacro::is_xacro_file(other->value) ? how_to_expand(other->value) + ", and list that"
                                                 : "convert it to a .urdf and list that");
    return;
  }
  findings.report(root.find("files").key_span(), "`files` lists no URDF");
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "has no URDF to read", "any reader"},
    {&readers::mars, Effect::crashes, "dereferences a null pointer", "MARS smurf.cpp:988-998"},
    {&readers::phobos, Effect::refuses, "has no robot", "Phobos smurfrobot.py"},
};

}  // namespace

extern constinit const Rule sml2003_no_urdf{.id = "SML2003",
                                            .name = "no-urdf",
                                            .severity = Severity::error,
                                            .summary = "A main file lists no URDF.",
                                            .remedy = "List the URDF under `files`.",
                                            .check_model = check,
                                            .facts = kFacts,
                                            .blocks_building = true};

}  // namespace smurf::rules::sml2003_no_urdf_file
