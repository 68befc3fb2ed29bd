// SPDX-License-Identifier: BSD-3-Clause
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    const std::string type = entity_type(entity);
    if (type != "zsmurf" && type != "zsmurfs" && type != "zsmurfa") return;
    findings.report(type_place(entity),
                    title(entity) + " is an archive, of which MARS loads nothing");
  });
}

}  // namespace

extern constinit const Rule sml5011_archive_entity{
    .id = "SML5011",
    .name = "archive-entity",
    .severity = Severity::error,
    .summary = "An entity is a .zsmurf, .zsmurfs or .zsmurfa archive.",
    .why = "MARS registers these types and unpacks the archive, but no branch then reads what "
           "was unpacked: nothing is loaded and success is reported.",
    .remedy = "Unpack the archive and name the .smurf or .smurfs inside it.",
    .sources = "MARS SMURFLoader.cpp:405-411.",
    .check_scene = check};

}  // namespace smurf::rules
