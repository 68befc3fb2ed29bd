// SPDX-License-Identifier: BSD-3-Clause
// The text of a URDF with other shapes for some collisions, and where its bytes come from.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "conversion/collision_shapes.hpp"
#include "link/gazebo_names.hpp"

namespace smurf {

class CollisionTexts {
 public:
  /// The path of a file of the output as the URDF names it.
  using NameOfFile = std::function<std::string(const std::string& file)>;

  /// Both must outlive it. With `makes_names`, each new collision gets a name of its own;
  /// otherwise that of the collision before, for writers that make names unique.
  CollisionTexts(const LinkedModel& model, std::string_view text, bool makes_names);

  /// The first shape takes the place of the collision; the others follow all collisions of the
  /// link, so that the numbers of the collisions before do not change. Precondition: there is one.
  void replace(CollisionPlace place, const std::vector<NewShape>& shapes,
               const NameOfFile& name_of);
  /// Lets the contact sensors that name a collision name all shapes in its place. `changed`: the
  /// robot of text(). False if no sensor names one, and the text is as before.
  bool follow_contacts(const LinkedModel& changed);

  bool empty() const { return edits_.empty(); }
  std::string text();
  /// The place in the text before; precondition: text() was called.
  Span original(Span changed) const;

 private:
  struct Replacement {
    Edit edit;
    Span blame;  ///< the bytes in the text before that a finding in new bytes is about
  };
  /// A part of the new text.
  struct Piece {
    std::uint32_t begin = 0, end = 0;
    std::uint32_t original = 0;  ///< its first byte in the text before, if it is a copy
    bool is_copy = false;
    Span blame;
  };

  const urdf::Collision& collision(CollisionPlace place) const;
  std::vector<Edit> changes(const urdf::Collision& collision, const NewShape& shape,
                            const NameOfFile& name_of) const;
  std::string copy(const urdf::Collision& collision, std::vector<Edit> changes) const;
  std::string line_before(Span span) const;
  const Piece& piece_at(std::uint32_t offset) const;

  const LinkedModel& model_;
  std::string_view text_;
  SourceId source_{};  ///< of the text
  bool makes_names_;
  std::set<std::string, std::less<>> names_;  ///< of all collisions
  std::vector<Replacement> edits_;
  std::map<std::size_t, std::string> appended_;  ///< new collisions, by link
  std::map<std::size_t, Span> appended_for_;
  /// By link: the collision in whose place each appended one is.
  std::map<std::size_t, std::vector<std::size_t>> origins_;
  std::vector<Replacement> contacts_;
  std::vector<Piece> pieces_;
};

}  // namespace smurf
