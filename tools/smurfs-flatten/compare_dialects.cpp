// SPDX-License-Identifier: BSD-3-Clause
#include "smurfs-flatten/compare_dialects.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/numbers/numbers.hpp"
#include "render/printable.hpp"
#include "render/wrap.hpp"
#include "write/text/json_text.hpp"

namespace smurf::tools {
namespace {

constexpr std::size_t kColumns = 80;

std::string cell(std::string text, std::size_t width) {
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return text;
}

/// Four decimal places if they fit; the note states the distance between the poses.
std::string short_number(double value) {
  if (std::fabs(value) >= 1e5) return format_rounded(value, 4);
  const double rounded = std::round(value * 1e4) / 1e4;
  return format_rounded(rounded == 0 ? 0 : rounded, 9);
}

std::string row(const std::string& label, const std::optional<Pose>& pose) {
  std::string text = "  " + label;
  constexpr std::size_t kLabel = 20;
  text.resize(std::max(text.size(), kLabel), ' ');
  if (!pose) return text + "  not loaded\n";
  for (const double component : pose->position) text += cell(short_number(component), 11);
  for (const double angle : to_rpy(pose->orientation)) {
    // More digits of an angle do not fit.
    const double degrees = std::round(angle * 180 / std::numbers::pi * 1e3) / 1e3;
    text += cell(format_rounded(degrees == 0 ? 0 : degrees, 9), 9);
  }
  return text + "\n";
}

std::string distance(const Pose& a, const Pose& b) {
  const double metres = norm({0, a.position[0] - b.position[0], a.position[1] - b.position[1],
                              a.position[2] - b.position[2]});
  const double degrees = angle_between(a.orientation, b.orientation) * 180 / std::numbers::pi;
  std::string text;
  if (metres > 1e-9) text += format_rounded(metres, 3) + " m";
  if (degrees > 1e-7) text += (text.empty() ? "" : " and ") + format_rounded(degrees, 3) + " deg";
  return text + " away";
}

class Comparison {
 public:
  Comparison(const LinkedScene& scene, const SourceMap& sources)
      : scene_(scene), sources_(sources) {
    for (const Dialect* dialect : dialects()) readings_.push_back(dialect->read(scene));
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      if (differs(i)) different_.push_back(i);
    }
  }

  std::string table() const {
    std::string text;
    if (!different_.empty()) {
      text = "entity              ";
      for (const char* name : {"x", "y", "z"}) text += cell(name, 11);
      for (const char* name : {"roll", "pitch", "yaw"}) text += cell(name, 9);
      text += "\n";
    }
    for (const std::size_t i : different_) add_rows(text, i);
    const std::size_t all = scene_.instances.size();
    if (different_.empty()) return "all dialects give every entity the same pose\n";
    return text + std::to_string(different_.size()) + " of " + std::to_string(all) +
           (all == 1 ? " entity differs" : " entities differ") +
           " between dialects (m, deg, in the world)\n";
  }

  std::string json() const {
    std::string out =
        "{\"schema_version\": \"1.0\", \"entities\": " + std::to_string(scene_.instances.size()) +
        ", \"different\": [";
    bool is_first = true;
    for (const std::size_t i : different_) {
      out += is_first ? "\n  " : ",\n  ";
      is_first = false;
      add_object(out, i);
    }
    return out + (is_first ? "]}\n" : "\n]}\n");
  }

 private:
  const EntityReading& reading(std::size_t dialect, std::size_t i) const {
    return readings_[dialect].entities[i];
  }

  bool differs(std::size_t i) const {
    for (std::size_t d = 1; d < readings_.size(); ++d) {
      if (!is_same_pose(reading(d, i).X_WE, reading(0, i).X_WE)) return true;
    }
    return false;
  }

  /// Readers that agree share a row.
  void add_rows(std::string& text, std::size_t i) const {
    text += render::escape(scene_.instances[i].path) + "\n";
    std::vector<bool> is_shown(readings_.size(), false);
    for (std::size_t d = 0; d < readings_.size(); ++d) {
      if (is_shown[d]) continue;
      const EntityReading& first = reading(d, i);
      std::string names;
      for (std::size_t other = d; other < readings_.size(); ++other) {
        const EntityReading& candidate = reading(other, i);
        const bool is_same = first.X_WE || first.note == candidate.note;
        if (is_shown[other] || !is_same || !is_same_pose(first.X_WE, candidate.X_WE)) continue;
        is_shown[other] = true;
        names += (names.empty() ? "" : ", ") + std::string(dialects()[other]->name);
      }
      text += row(names, first.X_WE);
      std::string note;
      const EntityReading& meant = reading(0, i);
      if (d > 0 && first.X_WE && meant.X_WE) note = distance(*first.X_WE, *meant.X_WE);
      if (d > 0 && !first.note.empty()) note += (note.empty() ? "" : ": ") + first.note;
      if (!note.empty()) text += render::wrap(render::escape(note), 6, kColumns);
    }
  }

  void add_object(std::string& out, std::size_t i) const {
    const Span place = written_at(scene_.entity(scene_.instances[i]));
    out += '{';
    append_key(out, "path", true);
    append_json(out, scene_.instances[i].path);
    append_key(out, "source");
    out += '{';
    append_key(out, "file", true);
    append_json(out, sources_.path(place.source));
    append_key(out, "line");
    out += std::to_string(sources_.line_of(place.source, place.begin)) + "}";
    append_key(out, "readings");
    out += '{';
    for (std::size_t d = 0; d < readings_.size(); ++d) {
      append_key(out, dialects()[d]->name, d == 0);
      add_reading(out, reading(d, i));
    }
    out += "}}";
  }

  static void add_reading(std::string& out, const EntityReading& reading) {
    out += '{';
    append_key(out, "is_loaded", true);
    out += reading.X_WE ? "true" : "false";
    if (reading.X_WE) {
      append_key(out, "position");
      append_json(out, reading.X_WE->position);
      append_key(out, "orientation");
      append_json(out, reading.X_WE->orientation);
    }
    if (!reading.note.empty()) {
      append_key(out, "note");
      append_json(out, reading.note);
    }
    out += '}';
  }

  const LinkedScene& scene_;
  const SourceMap& sources_;
  std::vector<SceneReading> readings_;  ///< by dialect
  std::vector<std::size_t> different_;
};

}  // namespace

std::string compare_dialects(const LinkedScene& scene, const SourceMap& sources, bool as_json) {
  const Comparison comparison(scene, sources);
  return as_json ? comparison.json() : comparison.table();
}

}  // namespace smurf::tools
