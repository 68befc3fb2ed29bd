// SPDX-License-Identifier: BSD-3-Clause
#include "write/usd/usd_lights.hpp"

#include "base/numbers/numbers.hpp"
#include "base/text/unique_names.hpp"
#include "write/parts/scene_parts.hpp"

namespace smurf {
namespace {

constexpr Vector3 kLightAxis{0, 0, -1};  ///< direction of lights in USD

void add_light(const Light& light, const std::string& name, UsdaText& text) {
  const bool is_distant = light.directional.value_or(false);
  const bool is_spot = !is_distant && light.type.value_or(1) == 2;
  std::vector<std::string> schemas;
  if (is_spot) schemas.emplace_back("ShapingAPI");
  text.open(is_distant ? "DistantLight" : "SphereLight", name, schemas);
  text.pose({light.position.value_or({0, 0, 0}), rotation_onto(kLightAxis, direction_of(light))});
  const Rgba color = linear_color(color_or(light.diffuse, {1, 1, 1, 1}));
  text.line("color3f inputs:color = " + UsdaText::tuple({color[0], color[1], color[2]}));
  if (!is_distant) {
    text.line("float inputs:radius = 0");
    text.line("bool treatAsPoint = 1");
  }
  if (is_spot) {
    text.line("float inputs:shaping:cone:angle = " + format_number(light.angle.value_or(90)));
    text.line("float inputs:shaping:focus = " + format_number(light.exponent.value_or(0)));
  }
  text.line("custom string smurf:name = " + UsdaText::quoted(light.name.value_or({})));
  text.close();
}

}  // namespace

void add_usd_lights(const SceneExport& scene, const std::string& scope, UsdaText& text) {
  const std::vector<const Light*> lights = world_lights(scene);
  if (lights.empty()) return;
  text.open("Scope", scope);
  UniqueNames names;
  for (const Light* light : lights) {
    if (text.is_full()) break;
    add_light(*light, names.add(safe_name(light->name.value_or({}))), text);
  }
  text.close();
}

}  // namespace smurf
