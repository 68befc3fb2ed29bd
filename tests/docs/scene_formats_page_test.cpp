// SPDX-License-Identifier: BSD-3-Clause
// docs/scene-formats.md is made from the table of what scenes can hold; this test fails when it is
// stale. SMURF_UPDATE_SNAPSHOTS=1 writes it.
#include <doctest/doctest.h>

#include <set>
#include <sstream>

#include "docs/page.hpp"
#include "write/losses/loss_table.hpp"

using namespace smurf;

namespace {

std::string cell_text(std::string_view cell) {
  return cell == "shown" ? "shapes only" : std::string(cell);
}

void add_rows(std::ostringstream& page, ThingOf of, std::string_view title) {
  page
      << "## " << title
      << "\n\n| | sdf | sdf1.6 | mjcf | urdf | dmd | html | gltf | usda |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const SceneThing& thing : scene_things()) {
    if (thing.of != of) continue;
    page << "| " << thing.title;
    for (const std::string_view cell : thing.cells) page << " | " << cell_text(cell);
    page << " |\n";
  }
  page << "\n";
}

std::string scene_formats_page() {
  std::ostringstream page;
  page << "# What the formats of scenes keep\n\n"
          "These tables show what each output format of smurfs-flatten keeps of a model and a "
          "scene. They are made from the table in `libsmurf/src/write/losses/loss_table.cpp` by "
          "`rules_page_test`; do not edit. The warnings "
          "come from the same table: things that are `lost` or `changed`, and the missing part of "
          "things kept `partly`, are reported by name "
          "([lost-part](rules.md#lost-part), [lost-annotations](rules.md#lost-annotations), "
          "[lost-world-setting](rules.md#lost-world-setting)) and refused by `--fail-on-loss`; "
          "`--loss-report` lists them for programs. `added` values are reported "
          "([chosen-value](rules.md#chosen-value)), but are no loss.\n\n"
          "`json` and `smurfs` name the models and keep the rest; `tsv`, `dot` and `svg` show only "
          "where things are. With `--form reference`, and in `dmd`, the result names the URDF of a "
          "model, so nothing of the URDF is lost; `smurf-lint --target` shows how its reader loads "
          "it.\n\n";
  add_rows(page, ThingOf::urdf, "URDF");
  add_rows(page, ThingOf::annotation, "Annotations of a model");
  add_rows(page, ThingOf::scene, "Scenes and entities");
  std::string text = page.str();
  text.pop_back();
  return text;
}

}  // namespace

TEST_CASE("docs/scene-formats.md is what the table of things says") {
  test::check_page("scene-formats.md", scene_formats_page());
}

TEST_CASE("every cell of the table of things is understood") {
  std::set<std::string_view> titles;
  for (const SceneThing& thing : scene_things()) {
    CHECK(titles.insert(thing.title).second);
    for (const std::string_view cell : thing.cells) {
      const bool is_bare = cell == "kept" || cell == "lost" || cell == "shown";
      CHECK_MESSAGE((is_bare || !reason_of(cell).empty()), cell);
      const bool starts_well = cell.starts_with("kept") || cell.starts_with("partly: ") ||
                               cell.starts_with("changed: ") || cell.starts_with("lost") ||
                               cell.starts_with("added: ") || cell == "shown";
      CHECK_MESSAGE(starts_well, cell);
    }
  }
}
