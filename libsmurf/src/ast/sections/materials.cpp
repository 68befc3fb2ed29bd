// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS MaterialData.cpp:47-118, smurf.cpp:333-352; rock-cpp/smurf Robot.cpp:343-375.
#include "ast/sections.hpp"

namespace smurf::sections {
namespace {

using enum ValueType;

constexpr Key<MaterialAnnotation> kKeys[] = {
    {{.name = "name", .type = text, .doc = "Name of a material of the URDF.", .required = true},
     &MaterialAnnotation::name},
    {{.name = "ambientColor", .type = color, .doc = "Ambient colour; absent components are 0 in MARS."},
     &MaterialAnnotation::ambient_color},
    {{.name = "diffuseColor", .type = color, .doc = "Diffuse colour; replaces the URDF's rgba."},
     &MaterialAnnotation::diffuse_color},
    {{.name = "specularColor", .type = color, .doc = "Specular colour."},
     &MaterialAnnotation::specular_color},
    {{.name = "emissionColor", .type = color, .doc = "Colour that the material emits."},
     &MaterialAnnotation::emission_color},
    {{.name = "ambientFront", .type = color, .doc = "Old name of ambientColor."}, {}},
    {{.name = "diffuseFront", .type = color, .doc = "Old name of diffuseColor."}, {}},
    {{.name = "specularFront", .type = color, .doc = "Old name of specularColor."}, {}},
    {{.name = "emissionFront", .type = color, .doc = "Old name of emissionColor."}, {}},
    {{.name = "ambientBack", .type = color, .doc = "Ambient colour of the back side."}, {}},
    {{.name = "diffuseBack", .type = color, .doc = "Diffuse colour of the back side."}, {}},
    {{.name = "specularBack", .type = color, .doc = "Specular colour of the back side."}, {}},
    {{.name = "emissionBack", .type = color, .doc = "Emitted colour of the back side."}, {}},
    {{.name = "transparency", .type = number, .doc = "0 is opaque, 1 invisible.", .fallback = "0",
      .minimum = 0, .maximum = 1},
     &MaterialAnnotation::transparency},
    {{.name = "shininess", .type = number, .doc = "Exponent of the specular highlight.",
      .fallback = "0", .minimum = 0},
     &MaterialAnnotation::shininess},
    {{.name = "diffuseTexture", .type = text, .doc = "Image file, relative to the .smurf."},
     &MaterialAnnotation::diffuse_texture},
    {{.name = "texturename", .type = text, .doc = "Old name of diffuseTexture."}, {}},
    {{.name = "normalTexture", .type = text, .doc = "Normal map, relative to the .smurf."},
     &MaterialAnnotation::normal_texture},
    {{.name = "bumpmap", .type = text, .doc = "Old name of normalTexture."}, {}},
    {{.name = "displacementTexture", .type = text, .doc = "Displacement map, relative to the .smurf."},
     &MaterialAnnotation::displacement_texture},
    {{.name = "displacementmap", .type = text, .doc = "Old name of displacementTexture."}, {}},
    {{.name = "tex_scale", .type = number, .doc = "Scale of the texture coordinates.",
      .fallback = "1"},
     {}},
    {{.name = "bumpNorFac", .type = number, .doc = "Strength of the normal map.", .fallback = "1"},
     {}},
    {{.name = "reflect", .type = boolean, .doc = "Mirror the surroundings.", .fallback = "false"},
     {}},
    {{.name = "getLight", .type = boolean, .doc = "Be lit by lights.", .fallback = "true"}, {}},
    {{.name = "exists", .type = boolean, .doc = "The material is used.", .fallback = "true"}, {}},
};

std::vector<const KeySpec*> keys() { return specs_of<MaterialAnnotation>(kKeys); }

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<MaterialAnnotation>(kKeys, "material", entry, section, out.materials, sink);
}

constexpr std::string_view kAliases[] = {"material"};

}  // namespace

constinit const SectionSpec materials{.name = "materials",
                                      .aliases = kAliases,
                                      .entry = "material",
                                      .doc = "Colours and textures of URDF materials.",
                                      .keys = keys,
                                      .read = read};

}  // namespace smurf::sections
