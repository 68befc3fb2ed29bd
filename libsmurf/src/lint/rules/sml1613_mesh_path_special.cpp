// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1613_mesh_path_special_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const MeshReference* first = nullptr;
  std::set<std::string_view> names;
  for (const MeshReference& reference : model.meshes) {
    if (!reference.exists) continue;
    if (reference.filename.find_first_of(" %#?") == std::string::npos) continue;
    if (first == nullptr) first = &reference;
    names.insert(reference.filename);
  }
  if (first == nullptr) return;
  const char found = first->filename[first->filename.find_first_of(" %#?")];
  Diagnostic& diagnostic = findings.report(
      first->span, "the path " + quoted(first->filename) + " contains " +
                       (found == ' ' ? std::string("a space") : quoted(std::string(1, found))));
  if (names.size() > 1) {
    diagnostic.note("this applies to " + std::to_string(names.size()) + " files");
  }
}

}  // namespace

extern constinit const Rule sml1613_mesh_path_special{
    .id = "SML1613",
    .name = "mesh-path-special",
    .severity = Severity::info,
    .summary =
        "The path of a mesh or texture contains a space or a character with a special meaning in "
        "URLs.",
    .why =
        "Readers that treat paths as URLs decode `%20` and cut at `#` and `?`; most use the text "
        "literally.",
    .remedy = "Rename the file.",
    .sources = "`%` is literal in six readers, executed; RFC 3986 for addresses.",
    .check_model = check};

}  // namespace smurf::rules::sml1613_mesh_path_special_file
