// SPDX-License-Identifier: BSD-3-Clause
// A view of a scene from one side: outlines, axes, names and anchors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "write/parts/placed_shapes.hpp"
#include "write/svg/svg_canvas.hpp"
#include "write/svg/svg_outlines.hpp"

namespace smurf {

/// Colours of x, y and z.
inline constexpr std::string_view kAxisColors[] = {"#d62828", "#2a9134", "#1d5fd1"};

/// The instances on the sheet: those with a pose that are not far from the others.
class SvgSelection {
 public:
  explicit SvgSelection(const FlatScene& flat);

  bool has_pose(std::size_t i) const { return flat_.instances[i].X_WE.has_value(); }
  bool is_shown(std::size_t i) const { return has_pose(i) && !is_far_[i]; }

 private:
  const FlatScene& flat_;
  std::vector<bool> is_far_;
};

class SvgView {
 public:
  /// `X_VW` is the pose of the world in the frame of the view, in which x goes right, y up, and z
  /// to the viewer. All arguments must outlive this object.
  SvgView(const SceneExport& scene, const SvgSelection& selection, SvgOutlines& outlines,
          const Pose& X_VW);

  /// The area to show; m.
  const Box2& extent() const { return extent_; }
  std::size_t shapes() const { return footprints_.size(); }
  void draw(SvgCanvas& canvas);
  /// Draws arrows at the border towards the instances that are too far away.
  void add_pointers(SvgCanvas& canvas) const;

 private:
  /// One shape. Outlines are not stored, because there may be hundreds of thousands.
  struct Footprint {
    FlatGeometry geometry;
    Pose X_VS;
    double nearest = 0;  ///< m; nearer shapes are drawn later
    std::size_t instance = 0;

    bool is_ground() const { return std::holds_alternative<FlatPlane>(geometry); }
  };

  std::size_t count() const { return scene_.flat.instances.size(); }
  const FlatInstance& at(std::size_t i) const { return scene_.flat.instances[i]; }
  const std::string& name(std::size_t i) const { return at(i).path; }
  Pose in_view(const Pose& X_WA) const { return is_turned_ ? X_VW_ * X_WA : X_WA; }
  Point2 position(std::size_t i) const;
  std::string_view color(std::size_t i) const;
  void collect_footprints();
  void widen_to_ground();
  void add_footprints(SvgCanvas& canvas);
  void add_fixings(SvgCanvas& canvas) const;
  void add_frame(SvgCanvas& canvas, std::size_t i) const;
  std::string tooltip(std::size_t i) const;

  const SceneExport& scene_;
  const SvgSelection& selection_;
  SvgOutlines& outlines_;
  Pose X_VW_;
  bool is_turned_;
  std::vector<std::size_t> robots_;  ///< number of an instance among those of models
  std::vector<Footprint> footprints_;
  Box2 extent_;
};

}  // namespace smurf
