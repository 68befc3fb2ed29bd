// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS MaterialData.cpp:47-118, smurf.cpp:333-352; rock-cpp/smurf Robot.cpp:343-375.
#include "ast/sections.hpp"

namespace smurf::sections::materials_file {
namespace {

using enum ValueType;

constexpr Key<MaterialAnnotation> kKeys[] = {
    {{.name = "name",
      .type = text,
      .doc = "Name of a material of the URDF.",
      .required = true,
      .names = {NameKind::material}},
     &MaterialAnnotation::name},
    {{.name = "ambientColor",
      .type = color,
      .doc = "Ambient colour; absent components are 0 in MARS."},
     &MaterialAnnotation::ambient_color},
    {{.name = "diffuseColor", .type = color, .doc = "Diffuse colour; replaces the URDF's rgba."},
     &MaterialAnnotation::diffuse_color},
    {{.name = "specularColor", .type = color, .doc = "Specular colour."},
     &MaterialAnnotation::specular_color},
    {{.name = "emissionColor", .type = color, .doc = "Colour that the material emits."},
     &MaterialAnnotation::emission_color},
    {{.name = "transparency",
      .type = number,
      .doc = "0 is opaque, 1 invisible.",
      .fallback = "0",
      .minimum = 0,
      .maximum = 1},
     &MaterialAnnotation::transparency},
    {{.name = "shininess",
      .type = number,
      .doc = "Exponent of the specular highlight.",
      .fallback = "0",
      .minimum = 0},
     &MaterialAnnotation::shininess},
    {{.name = "diffuseTexture",
      .type = text,
      .doc = "Image file, relative to the .smurf.",
      .is_path = true},
     &MaterialAnnotation::diffuse_texture},
    {{.name = "normalTexture",
      .type = text,
      .doc = "Normal map, relative to the .smurf.",
      .is_path = true},
     &MaterialAnnotation::normal_texture},
    {{.name = "displacementTexture",
      .type = text,
      .doc = "Displacement map, relative to the .smurf.",
      .is_path = true},
     &MaterialAnnotation::displacement_texture},
};

constexpr KeySpec kMoreKeys[] = {
    {.name = "ambientFront", .type = color, .doc = "Old name of ambientColor."},
    {.name = "diffuseFront", .type = color, .doc = "Old name of diffuseColor."},
    {.name = "specularFront", .type = color, .doc = "Old name of specularColor."},
    {.name = "emissionFront", .type = color, .doc = "Old name of emissionColor."},
    {.name = "ambientBack", .type = color, .doc = "Ambient colour of the back side."},
    {.name = "diffuseBack", .type = color, .doc = "Diffuse colour of the back side."},
    {.name = "specularBack", .type = color, .doc = "Specular colour of the back side."},
    {.name = "emissionBack", .type = color, .doc = "Emitted colour of the back side."},
    {.name = "texturename", .type = text, .doc = "Old name of diffuseTexture."},
    {.name = "bumpmap", .type = text, .doc = "Old name of normalTexture."},
    {.name = "displacementmap", .type = text, .doc = "Old name of displacementTexture."},
    {.name = "tex_scale",
     .type = number,
     .doc = "Scale of the texture coordinates.",
     .fallback = "1"},
    {.name = "bumpNorFac", .type = number, .doc = "Strength of the normal map.", .fallback = "1"},
    {.name = "reflect", .type = boolean, .doc = "Mirror the surroundings.", .fallback = "false"},
    {.name = "getLight", .type = boolean, .doc = "Be lit by lights.", .fallback = "true"},
    {.name = "exists", .type = boolean, .doc = "The material is used.", .fallback = "true"},
    {.name = "cullMask", .type = any, .doc = "Accepted and ignored by MARS.", .read_by = "nobody"},
    {.name = "brightness",
     .type = any,
     .doc = "Accepted and ignored by MARS.",
     .read_by = "nobody"},
    {.name = "users",
     .type = integer,
     .doc = "Counter of Phobos up to 1.0, without meaning.",
     .read_by = "nobody"},
    {.name = "culling", .type = any, .doc = "Renderer of MARS: do not draw back sides."},
    {.name = "envMapSpecular", .type = any, .doc = "Renderer of MARS: environment map."},
    {.name = "envMapScale", .type = any, .doc = "Renderer of MARS: environment map."},
    {.name = "instancing", .type = any, .doc = "Renderer of MARS: draw many copies."},
    {.name = "instancesWidth", .type = number, .doc = "Renderer of MARS: extent of the copies."},
    {.name = "instancesLength", .type = number, .doc = "Renderer of MARS: extent of the copies."},
    {.name = "instancesHeight", .type = number, .doc = "Renderer of MARS: extent of the copies."},
    {.name = "maxNumLights",
     .type = integer,
     .doc = "Renderer of MARS: largest number of lights on it.",
     .minimum = 0},
    {.name = "renderBin", .type = any, .doc = "Renderer of MARS: order of drawing."},
    {.name = "shader", .type = any, .doc = "Renderer of MARS: shader program."},
    {.name = "shaderSources", .type = any, .doc = "Renderer of MARS: shader files."},
    {.name = "textures", .type = list, .doc = "Renderer of MARS: further textures."},
    {.name = "printShader", .type = any, .doc = "Renderer of MARS: write the shader to a file."},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<MaterialAnnotation>(kKeys, {kMoreKeys}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<MaterialAnnotation>(kKeys, {kMoreKeys}, "material", entry, section, out.materials,
                                sink);
}

constexpr std::string_view kAliases[] = {"material"};

}  // namespace

constinit const SectionSpec materials{
    .name = "materials",
    .aliases = kAliases,
    .entry = "material",
    .doc = "Colours and textures of URDF materials.",
    .read_by = "MARS 1, MARS 2, Phobos 2; MARS with envire reads ambientColor, specularColor and "
               "shininess only",
    .filtered_keys = keys,
    .read = read,
    .list = list_of<&Annotations::materials>()};

}  // namespace smurf::sections::materials_file
