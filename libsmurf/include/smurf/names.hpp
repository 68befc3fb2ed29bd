// SPDX-License-Identifier: BSD-3-Clause
// The kinds of things that have names.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace smurf {

/// Kinds of things with names. The order matters: see NameKinds.
enum class NameKind : std::uint8_t {
  motor,
  link,
  joint,
  visual,
  collision,
  material,
  sensor,
  node,       ///< of MARS, made by an entry of `nodes`; links, visuals and collisions are nodes too
  pose,       ///< a set of joint positions
  entity,     ///< of a scene
  group,      ///< of an SRDF
  extension,  ///< of a URDF: a transmission, a ros2_control element, ...
};
std::string_view to_string(NameKind kind);
/// The kind of this name ("joint").
std::optional<NameKind> find_name_kind(std::string_view name);

/// A set of kinds. If a text may name things of several kinds, it refers to the first kind in the
/// order of NameKind that has this name.
class NameKinds {
 public:
  constexpr NameKinds() = default;
  constexpr NameKinds(NameKind kind) : bits_(bit(kind)) {}

  constexpr bool empty() const { return bits_ == 0; }
  constexpr bool contains(NameKind kind) const { return (bits_ & bit(kind)) != 0; }
  /// Precondition: not empty.
  constexpr NameKind first() const {
    std::uint8_t kind = 0;
    while (!contains(NameKind{kind})) ++kind;
    return NameKind{kind};
  }
  constexpr NameKinds without(NameKind kind) const {
    NameKinds rest = *this;
    rest.bits_ = static_cast<std::uint16_t>(rest.bits_ & ~bit(kind));
    return rest;
  }
  friend constexpr NameKinds operator|(NameKinds a, NameKinds b) {
    a.bits_ = static_cast<std::uint16_t>(a.bits_ | b.bits_);
    return a;
  }
  friend bool operator==(const NameKinds&, const NameKinds&) = default;

 private:
  static constexpr std::uint16_t bit(NameKind kind) {
    return static_cast<std::uint16_t>(1U << static_cast<unsigned>(kind));
  }

  std::uint16_t bits_ = 0;
};
constexpr NameKinds operator|(NameKind a, NameKind b) { return NameKinds(a) | NameKinds(b); }

}  // namespace smurf
