// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS GraphicData.cpp, smurf.cpp:458-464.
#include "ast/sections.hpp"

namespace smurf::sections::graphics_file {
namespace {

using enum ValueType;

constexpr Key<Graphics> kKeys[] = {
    {{.name = "clearColor",
      .type = color,
      .doc = "Background colour.",
      .fallback = R"({"r": 0.25, "g": 0.27, "b": 0.48, "a": 1})"},
     &Graphics::clear_color},
    {{.name = "fogEnabled", .type = boolean, .doc = "Whether there is fog.", .fallback = "false"},
     &Graphics::fog_enabled},
    {{.name = "fogDensity",
      .type = number,
      .doc = "Density of the fog.",
      .fallback = "0.35",
      .minimum = 0},
     &Graphics::fog_density},
    {{.name = "fogStart",
      .type = number,
      .doc = "Distance at which the fog begins.",
      .unit = "m",
      .fallback = "10",
      .minimum = 0},
     &Graphics::fog_start},
    {{.name = "fogEnd",
      .type = number,
      .doc = "Distance at which the fog is full.",
      .unit = "m",
      .fallback = "30",
      .minimum = 0},
     &Graphics::fog_end},
    {{.name = "fogColor",
      .type = color,
      .doc = "Colour of the fog.",
      .fallback = R"({"r": 0.2, "g": 0.2, "b": 0.2, "a": 1})"},
     &Graphics::fog_color},
};

std::vector<const KeySpec*> keys(KeyFilter takes) { return specs_of<Graphics>(kKeys, {}, takes); }

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<Graphics>(kKeys, {}, "graphics entry", entry, section, out.graphics, sink);
}

}  // namespace

constinit const SectionSpec graphics{.name = "graphics",
                                     .entry = "graphics entry",
                                     .doc = "Display settings for the whole scene.",
                                     .read_by = "MARS 1",
                                     .form = SectionForm::list_or_mapping,
                                     .filtered_keys = keys,
                                     .read = read,
                                     .list = list_of<&Annotations::graphics>()};

}  // namespace smurf::sections::graphics_file
