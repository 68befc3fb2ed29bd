// SPDX-License-Identifier: BSD-3-Clause
// What a URDF says in `<gazebo>`, in the words of SDF: sensors, plugins and settings of physics.
#pragma once

#include "sdf/model.hpp"

namespace smurf::sdformat {

class ExtensionWriter {
 public:
  ExtensionWriter(Model& model, Reporter& reporter, TracedXml& xml)
      : model_(model), reporter_(reporter), xml_(xml), frames_(reporter) {}

  void write_all();

 private:
  void write(const Link& link);
  void write(const Joint& joint);
  void shapes(const Link& link, std::string_view kind, bool& is_open);
  void open(const Link& link, bool& is_open);
  void loop(const Joint& joint);
  void model_settings();
  void losses(const Scope& scope);
  void lost(View element);
  /// Copies an element with all that is in it; poses are those in the frame of `link`, if it is
  /// given.
  void copy(View element, xacro::FrameId frame, const Link* link);

  void declare(View element, const Place& tag);

  Model& model_;
  Reporter& reporter_;
  TracedXml& xml_;
  Frames frames_;
  std::vector<std::string> declared_;  ///< of the element that is open
};

}  // namespace smurf::sdformat
