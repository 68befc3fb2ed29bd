// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "imports/joint_xml.hpp"

namespace smurf::mjcf {
namespace {

constexpr double kThickness = 0.001;  // of a plane
constexpr double kEndless = 100;      // the sides of a plane without a size

}  // namespace

xacro::FrameId frame_of(const Place& place, const Settings& settings, xacro::FrameId around,
                        const Model&, xacro::Expansion& expansion) {
  const DefaultClass* of_class = settings.default_class();
  const Span use = place.use;
  const bool is_own = place.origin.source == use.source && place.origin.begin >= use.begin &&
                      place.origin.end <= use.end;
  if (is_own || of_class == nullptr) return around;
  xacro::Frame frame;
  frame.kind = xacro::Frame::Kind::include;
  frame.parent = around;
  const Attribute* chosen = settings.element().attribute("class");
  frame.call = chosen != nullptr ? chosen->value_span() : settings.element().name_span();
  frame.name = "class " + of_class->name;
  if (!expansion.frames.empty() && expansion.frames.back().call == frame.call &&
      expansion.frames.back().parent == around) {
    return xacro::FrameId{static_cast<std::uint32_t>(expansion.frames.size() - 1)};
  }
  expansion.frames.push_back(std::move(frame));
  return xacro::FrameId{static_cast<std::uint32_t>(expansion.frames.size() - 1)};
}

Place ShapeWriter::place(const Geom& geom, std::initializer_list<std::string_view> names) {
  Place result = geom.settings.place(names);
  result.frame = frame_of(result, geom.settings, geom.frame, model_, expansion_);
  return result;
}

const Settings* ShapeWriter::asset(const ModelFile& file, std::string_view kind,
                                   const std::string& name) {
  const std::string key = std::string(kind) + " " + name;
  const auto known = assets_.find({&file, key});
  if (known != assets_.end()) return known->second.element() ? &known->second : nullptr;
  Settings& found = assets_[{&file, key}];
  file.each_in("asset", [&](View one) {
    if (one.name() != kind || found.element()) return;
    const Attribute* own = one.attribute("name");
    const Attribute* path = one.attribute("file");
    const std::string_view usual = path != nullptr ? path::stem(path->value()) : std::string_view();
    if ((own != nullptr ? own->value() : usual) != name) return;
    const Attribute* of_class = one.attribute("class");
    found = Settings(one, file.find_class(of_class != nullptr ? of_class->value() : "main"));
  });
  return found.element() ? &found : nullptr;
}

std::string ShapeWriter::colour_name(const Geom& geom) const {
  if (!geom.material.empty() && !geom.rgba) return geom.material;
  if (!geom.rgba) return {};
  std::string name = geom.material.empty() ? "rgba" : geom.material;
  for (const double one : *geom.rgba) name += "_" + format_rounded(one, 4);
  return name;
}

void ShapeWriter::write_materials() {
  std::set<std::string> written;
  for (const Body& body : model_.bodies) {
    for (const Geom& geom : body.geoms) {
      const std::string name = colour_name(geom);
      if (name.empty() || !written.insert(name).second) continue;
      Place tag{geom.settings.element().name_span(), geom.settings.element().tag_span(),
                geom.frame};
      Place of_colour = place(geom, {"rgba", "material"});
      std::optional<std::array<double, 4>> rgba = geom.rgba;
      std::string texture;
      if (!geom.material.empty()) {
        const Settings* material = asset(*geom.file, "material", geom.material);
        if (material == nullptr) {
          reporter_.refuse_name(place(geom, {"material"}).origin,
                                "there is no material " + quoted(geom.material),
                                "add it to `<asset>`");
        } else {
          std::array<double, 4> own{1, 1, 1, 1};
          const bool has_own = material->numbers("rgba", own, 4, reporter_) > 0;
          if (!rgba && has_own) {
            rgba = own;
            of_colour = material->place({"rgba"});
          }
          if (!rgba) rgba = own;
          tag = {material->element().name_span(), material->element().tag_span()};
          const std::string of_texture(material->text("texture"));
          const Settings* image =
              of_texture.empty() ? nullptr : asset(*geom.file, "texture", of_texture);
          if (image != nullptr && image->has("file")) {
            texture = path::join(path::join(geom.file->folder(), geom.file->compiler().texturedir),
                                 image->text("file"));
          }
        }
      }
      xml_.open("material", tag);
      xml_.attribute("name", name, of_colour);
      if (rgba) {
        xml_.open("color", tag);
        std::string text;
        for (const double value : *rgba)
          text += (text.empty() ? "" : " ") + format_number(std::isfinite(value) ? value : 1);
        xml_.attribute("rgba", text, of_colour);
        xml_.close();
      }
      if (!texture.empty()) {
        xml_.open("texture", tag);
        xml_.attribute("filename", path::relative(texture, model_.files.front().folder()),
                       of_colour);
        xml_.close();
      }
      xml_.close();
    }
  }
}

std::string ShapeWriter::mesh_path(const Geom& geom, const Settings& mesh) const {
  std::string_view written = mesh.text("file");
  if (written.empty()) return {};
  const Compiler& c = geom.file->compiler();
  if (c.strippath) written = path::file_name(written);
  const std::string path = path::join(path::join(geom.file->folder(), c.meshdir), written);
  const std::string& folder = model_.files.front().folder();
  return path::relative(path, folder.empty() ? "." : folder);
}

/// Whether a URDF has the shape; reports those that it has not.
bool ShapeWriter::has_geometry(const Geom& geom) {
  const auto lost = [&](std::string what, std::string help) {
    reporter_
        .lose(place(geom, {"type", "mesh"}).origin,
              "a URDF has no " + what + ", so this shape is lost", "lost shapes")
        .help(std::move(help));
    return false;
  };
  switch (geom.shape) {
  case Shape::hfield: return lost("heightmap", "keep the MJCF for it, or use a mesh");
  case Shape::sdf: return lost("signed distances", "use a mesh");
  case Shape::ellipsoid: return lost("ellipsoid", "use a capsule, a sphere or a mesh");
  case Shape::mesh: {
    const Settings* mesh = asset(*geom.file, "mesh", geom.mesh);
    if (mesh == nullptr) return false;
    if (!mesh->has("file")) return lost("mesh without a file", "write the mesh into a file");
    return path::to_lower(path::extension(mesh->text("file"))) == ".msh"
               ? lost("mesh of MuJoCo's own format", "convert it to STL or OBJ")
               : true;
  }
  default:
    return std::all_of(geom.size.begin(), geom.size.end(),
                       [](double one) { return std::isfinite(one); });
  }
}

void ShapeWriter::write(const Geom& geom) {
  if (!has_geometry(geom)) return;
  geom.is_in_urdf = true;
  const bool is_contact = touches(geom);
  const bool is_shown = (!is_contact && !geom.file->compiler().discardvisual) ||
                        (is_contact && geom.group >= 0 && geom.group <= 2);
  if (is_shown) one(geom, "visual");
  if (is_contact) one(geom, "collision");
}

void ShapeWriter::one(const Geom& geom, std::string_view kind) {
  const View element = geom.settings.element();
  const Place tag{element.name_span(), element.tag_span(), geom.frame};
  xml_.open(kind, tag);
  if (!geom.name.empty()) {
    Place of_name = tag;
    if (const Attribute* name = element.attribute("name")) {
      of_name.origin = name->value_span();
      of_name.is_exact = name->value() == geom.name;
    }
    xml_.attribute("name", geom.name, of_name);
  }
  Pose X = geom.shape == Shape::mesh ? geom.mesh_pose : geom.pose;
  if (geom.shape == Shape::plane) X = X * Pose{{0, 0, -kThickness / 2}, {}};
  imports::add_origin(xml_, X, tag, place(geom, {"pos", "fromto", "quat", "euler"}));
  xml_.open("geometry", tag);
  geometry(geom);
  xml_.close();
  if (kind == "visual") material(geom);
  xml_.close();
}

void ShapeWriter::geometry(const Geom& geom) {
  const View element = geom.settings.element();
  const Place tag{element.name_span(), element.tag_span(), geom.frame};
  const Place of_size = place(geom, {"size", "fromto", "mesh"});
  const auto& s = geom.size;
  switch (geom.shape) {
  case Shape::plane: {
    xml_.open("box", tag);
    const auto side = [&](double half) { return half > 0 ? 2 * half : kEndless; };
    xml_.attribute("size", words_of({side(s[0]), side(s[1]), kThickness}), of_size);
    break;
  }
  case Shape::sphere:
    xml_.open("sphere", tag);
    xml_.number("radius", s[0], of_size);
    break;
  case Shape::capsule:
  case Shape::cylinder:
    xml_.open(geom.shape == Shape::capsule ? "capsule" : "cylinder", tag);
    xml_.number("length", 2 * s[1], of_size);
    xml_.number("radius", s[0], of_size);
    break;
  case Shape::box:
    xml_.open("box", tag);
    xml_.attribute("size", words_of({2 * s[0], 2 * s[1], 2 * s[2]}), of_size);
    break;
  default: {
    const Settings& mesh = *asset(*geom.file, "mesh", geom.mesh);
    xml_.open("mesh", tag);
    Place of_file = mesh.place({"file"});
    of_file.frame = geom.frame;
    xml_.attribute("filename", mesh_path(geom, mesh), of_file);
    Vector3 scale{1, 1, 1};
    mesh.numbers("scale", scale, 3, reporter_);
    if (scale != Vector3{1, 1, 1}) xml_.attribute("scale", words_of(scale), mesh.place({"scale"}));
    break;
  }
  }
  xml_.close();
}

void ShapeWriter::material(const Geom& geom) {
  const std::string name = colour_name(geom);
  if (name.empty()) return;
  const Place of_colour = place(geom, {"rgba", "material"});
  xml_.open("material", of_colour);
  xml_.attribute("name", name, of_colour);
  xml_.close();
}

}  // namespace smurf::mjcf
