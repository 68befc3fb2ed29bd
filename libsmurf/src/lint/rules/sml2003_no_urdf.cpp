// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/path.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

/// What stands where the URDF should: it must be made into one first.
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
        .report(other->span,
                "MARS ignores " + quoted(other->value) + ", so that `files` lists no URDF")
        .help = "make a .urdf of it and list that";
    return;
  }
  findings.report(root.find("files").key_span(), "`files` lists no URDF");
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
