// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/words.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml2017_uri_in_model_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const ModelFile& file : model.files) {
    if (!file.document) continue;
    for (const yaml::Node& node : file.document->nodes) {
      if (!is_same(node.key(), "URI") && !is_same(node.key(), "URIs")) continue;
      Diagnostic& diagnostic = findings.report(
          node.key_span(), "in MARS, the keys of another file override the keys here");
      const bool is_main = file.kind == ModelFile::Kind::main;
      if (is_main && node.text().starts_with('/')) {
        diagnostic.note("the absolute path is not found in the main file");
      }
      diagnostic.help("write the keys of that file here");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "merges the named files into the entry, and their keys override those written beside them",
     "configmaps ConfigMap.cpp:607-638, run; MARS smurf.cpp:125-149"},
    {&readers::mars2, Effect::loses, "does not read `URIs`", "envire_smurf_loader Model.cpp"},
    {&readers::envire, Effect::loses, "does not read the file", "rock-cpp/smurf Robot.cpp"},
    {&readers::phobos, Effect::loses, "does not read the file", "Phobos io/smurfrobot.py"},
};

}  // namespace

extern constinit const Rule sml2017_uri_in_model{
    .id = "SML2017",
    .name = "uri-in-model",
    .severity = Severity::warning,
    .summary =
        "A mapping of a model has the key `URI` or `URIs`, which readers resolve differently.",
    .why =
        "The documentation of configmaps states the opposite. In the main file absolute paths do "
        "not work, and a cycle overflows the stack. smurf-lint does not read the named files.",
    .remedy = "Write the keys here instead of naming a file.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml2017_uri_in_model_file
