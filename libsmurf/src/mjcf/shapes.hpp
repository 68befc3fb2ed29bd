// SPDX-License-Identifier: BSD-3-Clause
// Shapes of bodies as visuals and collisions of a URDF, with their materials.
#pragma once

#include <map>
#include <string>

#include "imports/traced_xml.hpp"
#include "mjcf/model.hpp"

namespace smurf::mjcf {

/// The frame of a value of a class: "of the class `leg`, chosen here".
xacro::FrameId frame_of(const Place& place, const Settings& settings, xacro::FrameId around,
                        const Model& model, xacro::Expansion& expansion);

class ShapeWriter {
 public:
  ShapeWriter(const Model& model, Reporter& reporter, xacro::Expansion& expansion, TracedXml& xml)
      : model_(model), reporter_(reporter), expansion_(expansion), xml_(xml) {}

  void write_materials();
  void write(const Geom& geom);

 private:
  struct Material {
    std::string name;
    std::optional<std::array<double, 4>> rgba;
    std::string texture;
  };
  const Settings* asset(const ModelFile& file, std::string_view kind, const std::string& name);
  void material(const Geom& geom);
  std::string colour_name(const Geom& geom) const;
  std::string mesh_path(const Geom& geom, const Settings& mesh) const;
  bool has_geometry(const Geom& geom);
  void geometry(const Geom& geom);
  void one(const Geom& geom, std::string_view kind);
  Place place(const Geom& geom, std::initializer_list<std::string_view> names);

  const Model& model_;
  Reporter& reporter_;
  xacro::Expansion& expansion_;
  TracedXml& xml_;
  std::map<std::pair<const ModelFile*, std::string>, Settings> assets_;
};

}  // namespace smurf::mjcf
