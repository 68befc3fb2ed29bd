// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void report(Span section, std::string_view name, Findings& findings) {
  findings.report(section, "the section " + quoted(name) + " is a list");
}

void check(const LinkedModel& model, Findings& findings) {
  for (const ModelFile& file : model.files) {
    if (file.kind != ModelFile::Kind::annotation || !file.document) continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping()) continue;
    for (const yaml::View value : root) {
      const bool is_read =
          is_section_name(value.key()) && value.key() != "controllers" && value.key() != "lights";
      if (!is_read && value.is_sequence()) report(value.key_span(), value.key(), findings);
    }
  }
}

}  // namespace

extern constinit const Rule sml7008_list_unknown_to_phobos{
    .id = "SML7008",
    .name = "list-unknown-to-phobos",
    .severity = Severity::error,
    .summary = "A list has a name that Phobos 2 does not know.",
    .why = "Phobos 2 has no `controllers` and `lights`, and takes a list of any unknown name for "
           "annotations of elements it then does not have: it raises an exception. The MARS "
           "generations pass over unknown sections.",
    .remedy = "Leave the file out of what Phobos loads, or make the section a mapping.",
    .sources = "Phobos io/smurfrobot.py:233-243, 376.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
