// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS LightData.cpp:45-71, LightData.h; smurf.cpp:450-464.
#include "ast/sections.hpp"

namespace smurf::sections::lights_file {
namespace {

using enum ValueType;

constexpr Key<Light> kKeys[] = {
    {{.name = "name", .type = text, .doc = "Name of the light."}, &Light::name},
    {{.name = "position", .type = vector3, .doc = "Position in the world frame.", .unit = "m"},
     &Light::position},
    {{.name = "lookat",
      .type = vector3,
      .doc = "Point that a spot light is turned to.",
      .unit = "m"},
     &Light::look_at},
    {{.name = "ambient", .type = color, .doc = "Ambient colour."}, &Light::ambient},
    {{.name = "diffuse", .type = color, .doc = "Diffuse colour."}, &Light::diffuse},
    {{.name = "specular", .type = color, .doc = "Specular colour."}, &Light::specular},
    {{.name = "type",
      .type = integer,
      .doc = "1 shines in all directions, 2 is a spot.",
      .minimum = 1,
      .maximum = 2},
     &Light::type},
    {{.name = "angle",
      .type = number,
      .doc = "Half the opening of a spot.",
      .unit = "deg",
      .minimum = 0,
      .maximum = 180},
     &Light::angle},
    {{.name = "exponent",
      .type = number,
      .doc = "How strongly a spot fades towards its edge.",
      .minimum = 0},
     &Light::exponent},
    {{.name = "constantAttenuation",
      .type = number,
      .doc = "Constant part of the attenuation.",
      .minimum = 0},
     &Light::constant_attenuation},
    {{.name = "linearAttenuation",
      .type = number,
      .doc = "Attenuation by distance.",
      .unit = "1/m",
      .minimum = 0},
     &Light::linear_attenuation},
    {{.name = "quadraticAttenuation",
      .type = number,
      .doc = "Attenuation by squared distance.",
      .unit = "1/m^2",
      .minimum = 0},
     &Light::quadratic_attenuation},
    {{.name = "directional",
      .type = boolean,
      .doc = "Whether the light comes from far away, like the sun."},
     &Light::directional},
    {{.name = "nodeName",
      .type = text,
      .doc = "Node that carries the light; looked up in the whole scene.",
      .names = may_name(kNodeKinds)},
     &Light::node_name},
};

constexpr KeySpec kMoreKeys[] = {
    {.name = "index", .type = integer, .doc = "Number of the light; MARS sets it."},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<Light>(kKeys, {kMoreKeys}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<Light>(kKeys, {kMoreKeys}, "light", entry, section, out.lights, sink);
}

constexpr std::string_view kAliases[] = {"light"};

}  // namespace

constinit const SectionSpec lights{
    .name = "lights",
    .aliases = kAliases,
    .entry = "light",
    .doc = "Lights. MARS has no defaults for them: a key that is left out has an undefined value.",
    .read_by = "MARS 1; Phobos 2 stops with an error at this section",
    .filtered_keys = keys,
    .read = read,
    .list = list_of<&Annotations::lights>()};

}  // namespace smurf::sections::lights_file
