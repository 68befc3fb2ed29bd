// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const ModelFile& file : model.files) {
    if (!file.document) continue;
    for (const yaml::Node& node : file.document->nodes) {
      if (node.key != "URI" && node.key != "URIs") continue;
      findings.report(node.key_span, quoted(node.key) + " stands for the contents of another file")
          .construct = node.key;
    }
  }
}

}  // namespace

extern constinit const Rule sml7007_uri_in_model{
    .id = "SML7007",
    .name = "uri-in-model",
    .severity = Severity::warning,
    .summary = "A model file takes in another file by `URI` or `URIs`.",
    .why = "MARS replaces both keys by what the file holds, relative to the .smurf; MARS 2 "
           "replaces `URI` only, relative to the file it stands in; MARS with envire and Phobos "
           "replace neither.",
    .remedy = "Write the contents in place, or list the file in `files`.",
    .sources = "MARS smurf.cpp:125-149; configmaps ConfigMap.cpp:607-638; Phobos io/smurfrobot.py.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
