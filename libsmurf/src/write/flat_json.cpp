// SPDX-License-Identifier: BSD-3-Clause
// Flat JSON, one line per instance: large scenes stay readable and diff well.
#include <algorithm>

#include "base/numbers.hpp"
#include "smurf/write.hpp"

namespace smurf {
namespace {

class JsonWriter {
 public:
  explicit JsonWriter(bool links) : links_(links) {}

  std::string run(const FlatScene& scene) {
    out_.reserve(1024 + 400 * scene.instances.size());
    out_ += "{\n  \"schema_version\": \"1.0\",\n  \"scene\": ";
    text(scene.scene);
    out_ += ",\n  \"frame\": \"world\",\n  \"physics\": ";
    physics(scene.physics);
    out_ += ",\n  \"environment\": ";
    object(scene.environment);
    out_ += ",\n  \"lights\": ";
    rows(scene.lights, [&](const Value& light) { value(light); });
    out_ += ",\n  \"models\": ";
    rows(scene.models, [&](const FlatModel& flat) { model(flat); });
    out_ += ",\n  \"instances\": ";
    rows(scene.instances, [&](const FlatInstance& flat) { instance(flat, scene); });
    out_ += "\n}\n";
    return std::move(out_);
  }

 private:
  /// A list with one item per line.
  template <class Items, class Write>
  void rows(const Items& items, const Write& write) {
    out_ += '[';
    bool is_first = true;
    for (const auto& item : items) {
      out_ += is_first ? "\n    " : ",\n    ";
      is_first = false;
      write(item);
    }
    out_ += items.empty() ? "]" : "\n  ]";
  }

  void number(double value) { out_ += format_number(value); }

  void text(std::string_view value) {
    out_ += '"';
    for (const char c : value) character(c);
    out_ += '"';
  }

  void character(char c) {
    switch (c) {
    case '"': out_ += "\\\""; return;
    case '\\': out_ += "\\\\"; return;
    case '\n': out_ += "\\n"; return;
    case '\r': out_ += "\\r"; return;
    case '\t': out_ += "\\t"; return;
    default: break;
    }
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f) {
      out_ += c;
      return;
    }
    constexpr std::string_view kDigits = "0123456789abcdef";
    out_ += "\\u00";
    out_ += kDigits[byte >> 4U];
    out_ += kDigits[byte & 0xfU];
  }

  void key(std::string_view name, bool is_first = false) {
    if (!is_first) out_ += ", ";
    text(name);
    out_ += ": ";
  }

  void vector(const Vector3& v) {
    out_ += '[';
    for (std::size_t i = 0; i < 3; ++i) {
      if (i > 0) out_ += ", ";
      number(v[i]);
    }
    out_ += ']';
  }

  void pose(const Pose& pose, bool is_first) {
    key("position", is_first);
    vector(pose.position);
    key("orientation");
    const Quaternion& q = pose.orientation;
    out_ += "{\"w\": ";
    number(std::clamp(q.w, -1.0, 1.0));
    for (const auto& [name, component] :
         {std::pair("x", q.x), std::pair("y", q.y), std::pair("z", q.z)}) {
      key(name);
      number(std::clamp(component, -1.0, 1.0));
    }
    out_ += '}';
  }

  void value(const Value& value) {
    const auto write = [&](const auto& data) {
      using Data = std::decay_t<decltype(data)>;
      if constexpr (std::is_same_v<Data, std::monostate>) {
        out_ += "null";
      } else if constexpr (std::is_same_v<Data, bool>) {
        out_ += data ? "true" : "false";
      } else if constexpr (std::is_same_v<Data, std::int64_t>) {
        out_ += std::to_string(data);
      } else if constexpr (std::is_same_v<Data, double>) {
        number(data);
      } else if constexpr (std::is_same_v<Data, std::string>) {
        text(data);
      } else if constexpr (std::is_same_v<Data, Value::List>) {
        list(data);
      } else {
        object(data);
      }
    };
    std::visit(write, value.data);
  }

  void list(const Value::List& items) {
    out_ += '[';
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (i > 0) out_ += ", ";
      value(items[i]);
    }
    out_ += ']';
  }

  void object(const Value::Object& members) {
    out_ += '{';
    for (std::size_t i = 0; i < members.size(); ++i) {
      key(members[i].key, i == 0);
      value(members[i].value);
    }
    out_ += '}';
  }

  void physics(const FlatPhysics& physics) {
    out_ += '{';
    bool is_first = true;
    if (physics.gravity) {
      key("gravity", is_first);
      vector(*physics.gravity);
      is_first = false;
    }
    for (const auto& [name, given] :
         {std::pair("step_size", physics.step_size), std::pair("cfm", physics.cfm),
          std::pair("erp", physics.erp)}) {
      if (!given) continue;
      key(name, is_first);
      number(*given);
      is_first = false;
    }
    out_ += '}';
  }

  void model(const FlatModel& model) {
    out_ += '{';
    key("id", true);
    text(model.id);
    key("type");
    text(model.type);
    key("file");
    text(model.file);
    if (!model.urdf.empty()) {
      key("urdf");
      text(model.urdf);
    }
    out_ += '}';
  }

  void attachment(const FlatAttachment& attachment, std::string_view none) {
    switch (attachment.kind) {
    case Attachment::Kind::none: return text(none);
    case Attachment::Kind::world: return text("world");
    case Attachment::Kind::link: break;
    }
    out_ += "{\"instance\": ";
    text(attachment.instance);
    key("link");
    text(attachment.link);
    out_ += '}';
  }

  void instance(const FlatInstance& instance, const FlatScene& scene) {
    out_ += '{';
    key("name", true);
    text(instance.name);
    key("path");
    text(instance.path);
    key("type");
    text(instance.type);
    if (instance.model) {
      key("model");
      text(scene.models[*instance.model].id);
    } else if (!instance.file.empty()) {
      key("file");
      text(instance.file);
    }
    out_ += ", \"source\": {\"file\": ";
    text(instance.source_file);
    out_ += ", \"line\": " + std::to_string(instance.source_line) + "}";
    if (instance.X_WE) {
      pose(*instance.X_WE, false);
    } else {
      out_ += ", \"position\": null, \"orientation\": null";
    }
    key("anchor");
    attachment(instance.anchor, "none");
    key("parent");
    attachment(instance.parent, "world");
    key("joint_positions");
    out_ += '{';
    for (std::size_t i = 0; i < instance.joint_positions.size(); ++i) {
      key(instance.joint_positions[i].first, i == 0);
      number(instance.joint_positions[i].second);
    }
    out_ += '}';
    key("properties");
    object(instance.properties);
    if (links_ && instance.model) links(instance);
    out_ += '}';
  }

  void links(const FlatInstance& instance) {
    key("links");
    out_ += '{';
    for (std::size_t i = 0; i < instance.links.size(); ++i) {
      key(instance.links[i].first, i == 0);
      out_ += '{';
      pose(instance.links[i].second, true);
      out_ += '}';
    }
    out_ += '}';
  }

  bool links_;
  std::string out_;
};

}  // namespace

std::string write_flat_json(const FlatScene& scene, bool links) {
  return JsonWriter(links).run(scene);
}

}  // namespace smurf
