// SPDX-License-Identifier: BSD-3-Clause
// Sources: Phobos robot.py:412-424 and 790-830.
#include "ast/sections.hpp"

namespace smurf::sections::submodels_file {
namespace {

using enum ValueType;

constexpr Key<Submodel> kKeys[] = {
    {{.name = "export_dir", .type = text, .doc = "Folder of the submodel, relative to this file."},
     &Submodel::export_directory},
    {{.name = "start",
      .type = text,
      .doc = "Root link of the submodel.",
      .names = {NameKind::link}},
     &Submodel::start},
    {{.name = "stop",
      .type = names,
      .doc = "Links at which the submodel ends.",
      .names = {NameKind::link}},
     &Submodel::stop},
};

std::vector<const KeySpec*> keys(KeyFilter takes) { return specs_of<Submodel>(kKeys, {}, takes); }

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<Submodel>(kKeys, {}, "submodel", entry, section, out.submodels, sink);
  out.submodels.back().name = {std::string(entry.key()), entry.key_span()};
}

}  // namespace

constinit const SectionSpec submodels{
    .name = "submodels",
    .entry = "submodel",
    .doc = "Parts of the model that Phobos exported as separate models.",
    .read_by = "Phobos 2",
    .form = SectionForm::named,
    .filtered_keys = keys,
    .read = read,
    .list = list_of<&Annotations::submodels>()};

}  // namespace smurf::sections::submodels_file
