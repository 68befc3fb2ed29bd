// SPDX-License-Identifier: BSD-3-Clause
// Keys as MARS reads them (NodeData.cpp:98-286, MaterialData.cpp, Load.cpp:228-268).
#include "flatten/old_shapes.hpp"

#include <cmath>
#include <map>
#include <unordered_map>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"
#include "flatten/plain_values.hpp"
#include "flatten/scene_shapes.hpp"

namespace smurf {
namespace {

/// Finds elements by name, and attributes before elements; an element without children is its text.
Value to_value(xml::View element) {
  Value::Object object;
  for (const xml::Attribute& attribute : element.attributes()) {
    object.push_back({std::string(attribute.name()), {std::string(attribute.value())}});
  }
  for (const xml::View child : element) {
    object.push_back({std::string(child.name()), to_value(child)});
  }
  if (!object.empty()) return {std::move(object)};
  const std::string_view text = trimmed(element.text());
  if (const auto number = parse_number(text)) return {*number};
  return {std::string(text)};
}

/// The items of a list: a sequence in YAML, elements in an element in XML.
std::vector<const Value::Object*> items(const Value::Object& root, std::string_view key) {
  std::vector<const Value::Object*> objects;
  const auto add = [&](const Value& value) {
    if (const Value::Object* object = object_of(&value)) objects.push_back(object);
  };
  const Value* list = find(root, key);
  if (list == nullptr) return objects;
  if (const auto* sequence = std::get_if<Value::List>(&list->data)) {
    for (const Value& value : *sequence) add(value);
  } else if (const Value::Object* elements = object_of(list)) {
    for (const ValueMember& member : *elements) add(member.value);
  }
  return objects;
}

double component(const Value::Object& object, std::string_view key, double fallback) {
  return number_of(find(object, key)).value_or(fallback);
}

Vector3 vector_of(const Value::Object& object, std::string_view key) {
  const Value::Object* vector = object_of(find(object, key));
  if (vector == nullptr) return {};
  return {component(*vector, "x", 0), component(*vector, "y", 0), component(*vector, "z", 0)};
}

bool is_true(const Value* value) {
  if (value == nullptr) return false;
  if (const auto* boolean = std::get_if<bool>(&value->data)) return *boolean;
  return text_of(value) == "true" || number_of(value).value_or(0) != 0;
}

/// A quaternion, or angles in degrees.
Quaternion rotation_of(const Value::Object& node) {
  const Value::Object* rotation = object_of(find(node, "rotation"));
  if (rotation == nullptr) return {};
  if (find(*rotation, "alpha") != nullptr) {
    return from_rpy_degrees({component(*rotation, "alpha", 0), component(*rotation, "beta", 0),
                             component(*rotation, "gamma", 0)});
  }
  const Quaternion q{component(*rotation, "w", 1), component(*rotation, "x", 0),
                     component(*rotation, "y", 0), component(*rotation, "z", 0)};
  return norm(q) > 1e-6 ? normalized(q) : Quaternion{};
}

class NodeReader {
 public:
  NodeReader(const Value::Object& root, const std::string& path) : folder_(path::parent(path)) {
    read_colors(root);
    for (const Value::Object* data : items(root, "nodelist")) {
      const Pose own{vector_of(*data, "position"), rotation_of(*data)};
      const auto index = std::trunc(component(*data, "index", 0));
      by_index_.emplace(index, nodes_.size());
      nodes_.push_back({data, std::trunc(component(*data, "relativeid", 0)), own, false});
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) compose(i);
  }

  /// `rest` gets the keys that do not describe shapes.
  std::vector<FlatShape> shapes(bool is_named, FlatOldScene& rest) const {
    const auto root = by_index_.find(1);
    const bool moves = is_named && root != by_index_.end();
    const Pose X_ES = moves ? inverse(nodes_[root->second].X_SN) : Pose{};
    std::vector<FlatShape> shapes;
    for (const Node& node : nodes_) {
      const auto geometry = geometry_of(*node.data);
      std::string name = text_of(find(*node.data, "name"));
      if (is_true(find(*node.data, "movable"))) rest.movable.push_back(name);
      if (!geometry) rest.shapeless.push_back(name);
      if (!geometry) continue;
      shapes.push_back(
          {std::move(name), moves ? X_ES * node.X_SN : node.X_SN, *geometry, color_of(*node.data)});
    }
    return shapes;
  }

 private:
  struct Node {
    const Value::Object* data = nullptr;
    double relative_to = 0;  // as it is written: not every number fits an integer
    Pose X_SN;               ///< pose in the old scene, after composing parents
    bool is_composed = false;
  };

  void read_colors(const Value::Object& root) {
    for (const Value::Object* material : items(root, "materiallist")) {
      const Value::Object* color = object_of(find(*material, "diffuseFront"));
      if (color == nullptr) color = object_of(find(*material, "diffuseColor"));
      if (color == nullptr) continue;
      const Rgba rgba{component(*color, "r", 0), component(*color, "g", 0),
                      component(*color, "b", 0), component(*color, "a", 1)};
      if (const auto id = number_of(find(*material, "id"))) {
        colors_.emplace(format_number(*id), rgba);
      }
      colors_.emplace("name " + text_of(find(*material, "name")), rgba);
    }
  }

  std::optional<Rgba> color_of(const Value::Object& node) const {
    const auto id = number_of(find(node, "material_id"));
    const auto known =
        colors_.find(id ? format_number(*id) : "name " + text_of(find(node, "materialName")));
    if (known == colors_.end()) return std::nullopt;
    return known->second;
  }

  /// A node may be placed relative to another one. A cycle ends at its first node.
  void compose(std::size_t index) {
    std::vector<std::size_t> chain;
    for (std::size_t at = index; !nodes_[at].is_composed;) {
      nodes_[at].is_composed = true;
      chain.push_back(at);
      const auto parent = by_index_.find(nodes_[at].relative_to);
      if (nodes_[at].relative_to == 0 || parent == by_index_.end()) break;
      at = parent->second;
    }
    for (; !chain.empty(); chain.pop_back()) {
      Node& node = nodes_[chain.back()];
      const auto parent = by_index_.find(node.relative_to);
      if (node.relative_to == 0 || parent == by_index_.end()) continue;
      node.X_SN = nodes_[parent->second].X_SN * node.X_SN;
    }
  }

  std::optional<FlatGeometry> geometry_of(const Value::Object& node) const {
    const std::string heights = text_of(find(node, "t_srcname"));
    if (!heights.empty()) return heightmap_of(node, path::join(folder_, heights));
    const std::string file = text_of(find(node, "filename"));
    const std::string original = text_of(find(node, "origname"));
    if (!file.empty() && file != "PRIMITIVE") return FlatMesh{path::join(folder_, file)};
    const std::string type = original.empty() ? text_of(find(node, "physicmode")) : original;
    const Vector3 extent = vector_of(node, "extend");
    if (type == "plane") return FlatPlane{extent[0], extent[1]};
    if (type == "box") return FlatBox{extent};
    if (type == "sphere") return FlatSphere{extent[0]};
    if (type == "cylinder") return FlatCylinder{extent[0], extent[1]};
    if (type == "capsule") return FlatCapsule{extent[0], extent[1]};
    return std::nullopt;
  }

  std::string folder_;
  std::vector<Node> nodes_;
  std::unordered_map<double, std::size_t> by_index_;
  std::map<std::string, Rgba> colors_;
};

template <class T>
void set(Field<T>& field, std::optional<T> value) {
  field.written = value.has_value();
  if (value) field.set(*std::move(value));
}

std::optional<Color> color_of(const Value::Object& light, std::string_view key) {
  const Value::Object* color = object_of(find(light, key));
  if (color == nullptr) return std::nullopt;
  Color read;
  set(read.r, number_of(find(*color, "r")));
  set(read.g, number_of(find(*color, "g")));
  set(read.b, number_of(find(*color, "b")));
  set(read.a, number_of(find(*color, "a")));
  return read;
}

/// The keys are those of `lights` in a scene (LightData.cpp:43-75).
Light to_light(const Value::Object& object) {
  Light light;
  const auto number = [&](std::string_view key) { return number_of(find(object, key)); };
  const auto vector = [&](std::string_view key) {
    const bool is_there = object_of(find(object, key)) != nullptr;
    return is_there ? std::optional(vector_of(object, key)) : std::nullopt;
  };
  if (const Value* name = find(object, "name")) set(light.name, std::optional(text_of(name)));
  set(light.position, vector("position"));
  set(light.look_at, vector("lookat"));
  set(light.ambient, color_of(object, "ambient"));
  set(light.diffuse, color_of(object, "diffuse"));
  set(light.specular, color_of(object, "specular"));
  if (const auto type = number("type")) {
    set(light.type, std::optional(static_cast<std::int64_t>(*type == 2 ? 2 : 1)));
  }
  set(light.angle, number("angle"));
  set(light.exponent, number("exponent"));
  set(light.constant_attenuation, number("constantAttenuation"));
  set(light.linear_attenuation, number("linearAttenuation"));
  set(light.quadratic_attenuation, number("quadraticAttenuation"));
  if (const Value* far = find(object, "directional")) {
    set(light.directional, std::optional(is_true(far)));
  }
  return light;
}

constexpr std::pair<std::string_view, std::string_view> kOtherLists[] = {
    {"jointlist", "joint"},
    {"motorlist", "motor"},
    {"sensorlist", "sensor"},
    {"controllerlist", "controller"}};

}  // namespace

OldSceneContent old_scene_content(const OldSceneFile& file, const Instance& instance) {
  Value root;
  if (file.xml && file.xml->view()) root = to_value(file.xml->view());
  if (file.yaml && file.yaml->view()) root = smurf::to_value(file.yaml->view());
  const Value::Object* object = object_of(&root);
  if (object == nullptr) return {};
  OldSceneContent content;
  content.shapes = NodeReader(*object, instance.file).shapes(!instance.name.empty(), content.rest);
  for (const Value::Object* light : items(*object, "lightlist")) {
    content.rest.lights.push_back({*light});
    content.rest.lamps.push_back(to_light(*light));
  }
  for (const auto& [list, what] : kOtherLists) {
    const std::size_t count = items(*object, list).size();
    if (count > 0) content.rest.others.emplace_back(what, count);
  }
  return content;
}

}  // namespace smurf
