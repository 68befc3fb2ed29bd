// SPDX-License-Identifier: BSD-3-Clause
// The systems (plugins) of Gazebo, those of Gazebo Classic, and which release has what.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/readers.hpp"

namespace smurf::gazebo {

/// Releases are letters in texts: F Fortress, G Garden, H Harmonic, I Ionic, J Jetty.
inline constexpr std::string_view kAll = "FGHIJ";
/// "Harmonic and Ionic"
std::string release_names(std::string_view releases);

inline constexpr Circumstance kNotInFortress{"not in Fortress"};
inline constexpr Circumstance kNotInGarden{"not in Garden"};
inline constexpr Circumstance kNotInHarmonic{"not in Harmonic"};
inline constexpr Circumstance kNotInIonic{"not in Ionic"};
inline constexpr Circumstance kNotInJetty{"not in Jetty"};
/// Adds the releases that lack something to a finding about it.
void mark_missing(std::string_view releases, Diagnostic& found);

/// The versions of sdformat in the releases.
inline constexpr Version kGarden{13}, kHarmonic{14}, kIonic{15}, kJetty{16};
/// Facts about what a release lacks: one for each of them.
constexpr std::array<Fact, 5> facts_of_releases(Effect effect, std::string_view makes,
                                                std::string_view evidence, Where where = {}) {
  const auto fact = [&](Where one) { return Fact{&readers::gazebo, effect, makes, evidence, one}; };
  const auto with = [&](const Circumstance& missing, Version from, Version until) {
    Where one = where;
    std::size_t next = 0;
    while (one.cases.at(next) != nullptr) ++next;
    one.cases.at(next) = &missing;
    one.from = from;
    one.until = until;
    return one;
  };
  return {fact(with(kNotInFortress, {}, kGarden)), fact(with(kNotInGarden, kGarden, kHarmonic)),
          fact(with(kNotInHarmonic, kHarmonic, kIonic)), fact(with(kNotInIonic, kIonic, kJetty)),
          fact(with(kNotInJetty, kJetty, {}))};
}

/// A system of gz-sim: the library gz-sim-NAME-system.
struct System {
  std::string_view name;      ///< "diff-drive"
  std::string_view cls;       ///< "DiffDrive", of gz::sim::systems; "": the words of the name
  std::string_view releases;  ///< that have it
};
std::span<const System> systems();
/// "DiffDrive"
std::string class_of(const System& system);
const System* find_system(std::string_view name);

/// The library that a `filename` means.
struct Library {
  std::string_view name;  ///< "diff-drive" of "libgz-sim8-diff-drive-system.so"
  bool is_old = false;    ///< ignition-gazebo-...
};
/// None for a library that has not the form of those of gz-sim.
std::optional<Library> library_of(std::string_view filename);

/// What the parameters of a system must be.
struct Needs {
  std::string_view system;
  std::string_view required;  ///< names with blanks between them
};
std::span<const Needs> needs();

/// A parameter of Gazebo Classic, or one that is often confused, and what the system reads.
struct OldWord {
  std::string_view system, word, now;
  double factor = 1;  ///< the value changes, too
};
std::span<const OldWord> old_words();

/// A plugin of Gazebo Classic: libgazebo_ros_NAME.so.
struct ClassicPlugin {
  std::string_view file;       ///< "libgazebo_ros_diff_drive.so"
  std::string_view successor;  ///< what to use in Gazebo, in words; may be empty
};
const ClassicPlugin* find_classic(std::string_view filename);
/// Whether a library has the form of those of Gazebo Classic for ROS.
bool is_classic(std::string_view filename);

/// The system that a sensor needs: "imu" for "imu"; empty if none is known.
std::string_view system_of_sensor(std::string_view type);

}  // namespace smurf::gazebo
