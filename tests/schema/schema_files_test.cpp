// SPDX-License-Identifier: BSD-3-Clause
// The files in schemas/ match the tables. SMURF_UPDATE_SNAPSHOTS=1 rewrites them; in the schema of
// the dump, which is written by hand, it adds attributes of URDF.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "ast/keys.hpp"
#include "ast/sections.hpp"
#include "ast/urdf_attributes.hpp"
#include "schema/schema_writer.hpp"

namespace fs = std::filesystem;
namespace urdf = smurf::urdf;
using smurf::test::Json;

namespace {

const fs::path kSchemas = SMURF_SCHEMAS;

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void check_file(const std::string& name, const std::string& text) {
  CAPTURE(name);
  if (std::getenv("SMURF_UPDATE_SNAPSHOTS") != nullptr) {
    std::ofstream(kSchemas / name, std::ios::binary) << text;
  }
  CHECK_MESSAGE(read(kSchemas / name) == text,
                "stale: run this test with SMURF_UPDATE_SNAPSHOTS=1");
}

Json form_of(const smurf::Field<std::string>&) { return {{"type", "string"}}; }
Json form_of(const smurf::Field<double>&) { return {{"type", "number"}}; }
Json form_of(const smurf::Field<smurf::Vector3>&) { return {{"$ref", "#/definitions/vector3"}}; }
Json form_of(const smurf::Field<std::array<double, 4>>&) {
  return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 4}, {"maxItems", 4}};
}

/// Adds the attributes of URDF that an object of the dump lacks. The sentences of others are kept.
template <class T, std::size_t N>
void add_missing(Json& object, const urdf::Attribute<T> (&rows)[N]) {
  Json& properties = object.at("properties");
  const T any{};
  urdf::for_each_field(rows, any, [&](const urdf::AttributeSpec& spec, const auto& field) {
    const std::string name(spec.member_name());
    if (properties.contains(name)) return;
    const std::string unit = spec.unit.empty() ? "" : " [" + std::string(spec.unit) + "]";
    properties[name]["description"] = std::string(spec.doc) + unit;
    properties[name].update(form_of(field));
  });
}

Json dump_schema() {
  Json schema = Json::parse(read(kSchemas / "model-dump.schema.json"));
  Json& types = schema.at("definitions");
  add_missing(types["material"], urdf::kMaterial);
  add_missing(types["material"], urdf::kColor);
  add_missing(types["material"], urdf::kTexture);
  Json& shapes = types["geometry"]["oneOf"];
  add_missing(shapes[0], urdf::kBox);
  add_missing(shapes[1], urdf::kSphere);
  add_missing(shapes[2], urdf::kCylinder);
  add_missing(shapes[2], urdf::kCapsule);
  add_missing(shapes[3], urdf::kMesh);
  Json& link = types["link"]["properties"];
  add_missing(types["link"], urdf::kLink);
  add_missing(link["inertial"], urdf::kMass);
  add_missing(link["inertial"]["properties"]["inertia"], urdf::kInertia);
  add_missing(link["visuals"]["items"], urdf::kVisual);
  add_missing(link["collisions"]["items"], urdf::kCollision);
  Json& joint = types["joint"]["properties"];
  add_missing(types["joint"], urdf::kJoint);
  add_missing(types["joint"], urdf::kParent);
  add_missing(types["joint"], urdf::kChild);
  add_missing(types["joint"], urdf::kAxis);
  add_missing(joint["limit"], urdf::kLimit);
  add_missing(joint["dynamics"], urdf::kDynamics);
  add_missing(joint["mimic"], urdf::kMimic);
  add_missing(joint["safety_controller"], urdf::kSafetyController);
  add_missing(joint["calibration"], urdf::kCalibration);
  return schema;
}

}  // namespace

TEST_CASE("the schemas are up to date") {
  for (const auto& [name, text] : smurf::test::write_schemas()) check_file(name, text);
  check_file("model-dump.schema.json", smurf::test::to_text(dump_schema()));
}

TEST_CASE("every schema says what it is") {
  for (const auto& file : fs::directory_iterator(kSchemas)) {
    CAPTURE(file.path().string());
    const auto schema = nlohmann::json::parse(read(file.path()));
    const std::string id = schema.at("$id");
    CHECK(schema.at("$schema") == "http://json-schema.org/draft-07/schema#");
    CHECK(id.ends_with("/schemas/" + file.path().filename().string()));
    CHECK(!schema.at("title").get<std::string>().empty());
    CHECK(!schema.at("description").get<std::string>().empty());
  }
}

TEST_CASE("every key of every section has a sentence, and defaults are JSON") {
  for (const smurf::SectionSpec* section : smurf::all_sections()) {
    for (const smurf::KeySpec* key : section->keys()) {
      CAPTURE(section->name);
      CAPTURE(key->name);
      CHECK(!key->doc.empty());
      CHECK((key->fallback.empty() || nlohmann::json::accept(key->fallback)));
    }
  }
}

TEST_CASE("every attribute of URDF has a sentence") {
  for (const urdf::ElementSpec& element : urdf::all_element_specs()) {
    for (const urdf::AttributeSpec& attribute : element.attributes) {
      CAPTURE(element.name);
      CAPTURE(attribute.name);
      CHECK(attribute.doc.ends_with('.'));
    }
  }
}
