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

std::string_view word_of(Fate fate) {
  switch (fate) {
  case Fate::kept: return "kept";
  case Fate::partly: return "partly";
  case Fate::changed: return "changed";
  case Fate::lost: return "lost";
  case Fate::added: return "added";
  case Fate::shown: return "shapes only";
  }
  return {};
}

std::string text_of(const Cell& cell) {
  return std::string(word_of(cell.fate)) +
         (cell.reason.empty() ? "" : ": " + std::string(cell.reason));
}

void add_rows(std::ostringstream& page, const std::set<ThingOf>& kinds, std::string_view title) {
  page
      << "## " << title
      << "\n\n| | sdf | sdf1.6 | mjcf | urdf | dmd | html | gltf | usda |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const SceneThing& thing : scene_things()) {
    if (!kinds.contains(thing.of)) continue;
    page << "| " << thing.title;
    for (const Cell& cell : thing.cells) page << " | " << text_of(cell);
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
  add_rows(page, {ThingOf::urdf}, "URDF");
  add_rows(page, {ThingOf::annotation, ThingOf::setting}, "Annotations of a model");
  add_rows(page, {ThingOf::scene}, "Scenes and entities");
  std::string text = page.str();
  text.pop_back();
  return text;
}

}  // namespace

TEST_CASE("docs/scene-formats.md is what the table of things says") {
  test::check_page("scene-formats.md", scene_formats_page());
}

TEST_CASE("cells of the table of things say what, how and why") {
  std::set<std::string_view> titles;
  for (const SceneThing& thing : scene_things()) {
    CHECK(titles.insert(thing.title).second);
    for (const Cell& cell : thing.cells) {
      CAPTURE(text_of(cell));
      const bool needs_reason =
          cell.fate == Fate::partly || cell.fate == Fate::changed || cell.fate == Fate::added;
      CHECK((!needs_reason || !cell.reason.empty()));
      CHECK((cell.fate != Fate::shown || cell.reason.empty()));
    }
  }
}
