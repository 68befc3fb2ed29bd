// SPDX-License-Identifier: BSD-3-Clause
// Code that the two COLLADA readers share: one finds facts, the other triangles.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mesh/affine.hpp"
#include "mesh/triangle_collector.hpp"
#include "smurf/mesh.hpp"
#include "smurf/source.hpp"
#include "smurf/xml.hpp"

namespace smurf::collada {

/// A file as a tree. Cannot be moved, because the tree points into it.
class File {
 public:
  explicit File(std::string_view text);
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// Null if the file is not XML, or has too many elements.
  const xml::Document* document() const { return document_ ? &*document_ : nullptr; }
  bool has_too_many_elements() const { return has_too_many_elements_; }
  /// The reason why it is not XML.
  const std::optional<MeshDefect>& defect() const { return defect_; }
  /// A defect at an element.
  MeshDefect defect_at(xml::View element, std::string what) const;
  std::uint32_t line_of(xml::View element) const;
  /// The texture whose name is the text of an element.
  MeshDependency dependency_at(xml::View element) const;

 private:
  SourceMap sources_;
  std::optional<xml::Document> document_;
  std::optional<MeshDefect> defect_;
  bool has_too_many_elements_ = false;
};

/// The value of an attribute; empty if it is absent.
std::string_view value(xml::View element, std::string_view attribute);
std::string_view trimmed_text(xml::View element);
/// The id in a reference to an element of the same file; empty for other references.
std::string_view id_in(std::string_view reference);
/// The numbers in a text; each word that is not a number becomes NaN.
std::vector<double> numbers(std::string_view text);
/// Numbers by the element that contains them.
using NumberLists = std::unordered_map<xml::ElementId, std::vector<double>>;
bool is_finite(const std::vector<double>& all);

/// The <source> with the positions of a mesh.
xml::View positions_of(xml::View mesh);
/// The positions of the coordinates of a point in a source.
struct Layout {
  std::size_t offset = 0, stride = 3;
  std::size_t axes[3] = {0, 1, 2};  ///< offsets from the beginning of a point

  /// The number of points in a list of numbers.
  std::size_t points(std::size_t numbers) const;
};
Layout layout_of(xml::View source);

/// Metres per unit of the file; none if it is not written.
std::optional<double> unit_of(xml::View asset);

/// Passes the triangles of the scene, moved by `X` and the transforms of the nodes, to `triangles`.
/// Returns the reason if this failed, as read_collada_triangles(). `known` as for GeometryReader.
/// If the file is broken, `defect` says so; it may be null.
std::string place_triangles(const File& file, const Affine& X, NumberLists* known,
                            TriangleCollector& triangles,
                            std::optional<MeshDefect>* defect = nullptr);

/// Applies <matrix>, <translate>, <rotate> or <scale> in a node to the transform of the node. False
/// if it has the wrong numbers.
bool transform(xml::View element, Affine& X);

}  // namespace smurf::collada
