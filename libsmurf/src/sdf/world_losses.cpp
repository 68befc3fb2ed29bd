// SPDX-License-Identifier: BSD-3-Clause
#include "sdf/world_losses.hpp"

#include <cmath>

#include "base/text/quoted.hpp"
#include "base/text/words.hpp"

namespace smurf::sdformat {
namespace {

/// `usual`: what libsdformat has without the element; "": nothing that says the same.
struct WorldSetting {
  std::string_view parent, name, usual;
  bool is_of_look = false;
};

constexpr WorldSetting kSettings[] = {
    {"world", "actor", ""},
    {"world", "audio", "", true},
    {"world", "particle_emitter", ""},
    {"world", "population", ""},
    {"world", "road", ""},
    {"world", "spherical_coordinates", ""},
    {"world", "state", ""},
    // Gazebo Classic writes the rounded one into each world that it saves.
    {"world", "magnetic_field", "5.5645e-6 22.8758e-6 -42.3884e-6"},
    {"wind", "linear_velocity", "0 0 0"},
    {"atmosphere", "temperature", "288.15"},
    {"atmosphere", "temperature_gradient", "-0.0065"},
    {"atmosphere", "pressure", "101325"},
    {"physics", "max_contacts", "20"},
    {"physics", "real_time_factor", "1", true},
    {"physics", "real_time_update_rate", "1000", true},
    {"physics", "bullet", ""},
    {"physics", "dart", ""},
    {"physics", "simbody", ""},
    {"solver", "type", "quick"},
    {"solver", "friction_model", "pyramid_model"},
    {"solver", "iters", "50"},
    {"solver", "min_step_size", "0.0001"},
    {"solver", "precon_iters", "0"},
    {"solver", "sor", "1.3"},
    {"solver", "use_dynamic_moi_rescaling", "0"},
    {"constraints", "contact_max_correcting_vel", "100"},
    {"constraints", "contact_surface_layer", "0.001"},
    {"light", "cast_shadows", "0", true},
    {"light", "intensity", "1", true},
    {"light", "light_on", "1", true},
    {"attenuation", "range", "10", true},
    {"spot", "inner_angle", "0", true},
    {"scene", "ambient", "0.4 0.4 0.4 1", true},
    {"scene", "shadows", "1", true},
    {"scene", "sky", "", true},
};

/// Elements whose children are looked at.
constexpr std::string_view kOpened[] = {"atmosphere", "attenuation", "constraints", "light",
                                        "ode",        "physics",     "scene",       "solver",
                                        "spot",       "wind"};

bool is_usual(std::string_view text, std::string_view usual) {
  if (usual.empty()) return false;
  const auto truth = sdf::read_flag(text);
  if (truth && truth == sdf::read_flag(usual)) return true;
  constexpr std::size_t kMost = 4;
  constexpr double kRounding = 5e-7;  // of the magnetic field, T
  const std::vector<double> wanted = sdf::streamed_numbers(usual, kMost);
  const std::vector<double> found = sdf::streamed_numbers(text, kMost);
  if (wanted.empty()) return text == usual;
  // The alpha of a colour may be missing.
  const bool is_colour = wanted.size() == kMost && found.size() + 1 == kMost;
  if (found.size() != wanted.size() && !is_colour) return false;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!(std::fabs(found[i] - wanted[i]) <= kRounding)) return false;
  }
  return true;
}

void collect(View parent, std::vector<LostSetting>& lost) {
  for (const View one : parent) {
    const std::string_view name = one.name();
    for (const WorldSetting& row : kSettings) {
      if (row.name != name || row.parent != parent.name()) continue;
      if (!is_usual(text_of(one), row.usual))
        lost.push_back({one.name_span(), quoted(name), row.is_of_look});
    }
    for (const std::string_view opened : kOpened) {
      if (name == opened) collect(one, lost);
    }
  }
}

}  // namespace

std::vector<LostSetting> lost_settings(View world) {
  std::vector<LostSetting> lost;
  collect(world, lost);
  return lost;
}

}  // namespace smurf::sdformat
