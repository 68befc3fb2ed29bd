// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "smurf-load-check/trace.hpp"

namespace smurf::load_check {
namespace {

constexpr double kWidth = 720;
constexpr double kHeight = 200;  // of a panel
constexpr double kLeft = 90;
constexpr double kRight = 20;
constexpr double kTop = 34;
constexpr double kBottom = 30;

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else
      out += c;
  }
  return out;
}

std::string pixels(double value) { return format_number(std::round(value * 100) / 100); }

struct Curve {
  std::string title;
  std::vector<double> times, values;
  double bound = 0;
};

/// One panel: axes, the bound as a dashed line when it is in range, and the curve.
class Panel {
 public:
  Panel(const Curve& curve, double top) : curve_(curve), top_(top) {
    low_ = std::min(0.0, *std::min_element(curve.values.begin(), curve.values.end()));
    high_ = std::max(0.0, *std::max_element(curve.values.begin(), curve.values.end()));
    // A bound that is far above would flatten the curve.
    has_bound_ = curve.bound <= 5 * high_;
    if (has_bound_) high_ = std::max(high_, curve.bound);
    if (high_ - low_ <= 0) high_ = low_ + 1e-12;
    end_ = std::max(curve.times.back(), 1e-9);
  }

  std::string draw() const {
    const double bottom = top_ + kHeight - kBottom;
    std::string out = label(kLeft, top_ + kTop - 12, "start", curve_.title);
    for (const double value : {low_, high_}) {
      out += line(kLeft, y(value), kWidth - kRight, y(value), "#ccc", "");
      out += label(kLeft - 8, y(value) + 4, "end", format_rounded(value, 3));
    }
    if (low_ < 0) out += line(kLeft, y(0), kWidth - kRight, y(0), "#ccc", "");
    out += label(kLeft, bottom + 18, "middle", "0 s");
    out += label(kWidth - kRight, bottom + 18, "end", format_rounded(end_, 3) + " s");
    if (has_bound_) {
      out += line(kLeft, y(curve_.bound), kWidth - kRight, y(curve_.bound), "#c0392b", "6 4");
      out += label(kWidth - kRight, y(curve_.bound) - 5, "end",
                   "bound " + format_rounded(curve_.bound, 3));
    }
    out += "<polyline fill=\"none\" stroke=\"#1f6fb4\" stroke-width=\"1.5\" points=\"";
    for (std::size_t i = 0; i < curve_.times.size(); ++i) {
      out += pixels(x(curve_.times[i])) + "," + pixels(y(curve_.values[i])) + " ";
    }
    return out + "\"/>\n";
  }

 private:
  double x(double time) const { return kLeft + (kWidth - kLeft - kRight) * time / end_; }
  double y(double value) const {
    return top_ + kTop + (kHeight - kTop - kBottom) * (high_ - value) / (high_ - low_);
  }

  static std::string line(double x1, double y1, double x2, double y2, std::string_view color,
                          std::string_view dashes) {
    std::string out = "<line x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) + "\" x2=\"" +
                      pixels(x2) + "\" y2=\"" + pixels(y2) + "\" stroke=\"" + std::string(color) +
                      "\"";
    if (!dashes.empty()) out += " stroke-dasharray=\"" + std::string(dashes) + "\"";
    return out + "/>\n";
  }

  static std::string label(double x, double y, std::string_view anchor, std::string_view text) {
    return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" text-anchor=\"" +
           std::string(anchor) + "\">" + escaped(text) + "</text>\n";
  }

  const Curve& curve_;
  double top_;
  double low_ = 0, high_ = 0, end_ = 0;
  bool has_bound_ = false;
};

std::vector<Curve> curves_of(const CheckResult& result, const Bounds& bounds) {
  std::vector<Curve> curves;
  for (const Stage stage : {Stage::still, Stage::hang, Stage::drop, Stage::anchor}) {
    Curve energy;
    Curve gap;
    for (const Sample& sample : result.samples) {
      if (sample.stage != stage) continue;
      for (Curve* curve : {&energy, &gap}) curve->times.push_back(sample.time);
      energy.values.push_back(sample.energy);
      gap.values.push_back(sample.gap);
    }
    if (energy.times.empty()) continue;
    const std::string name(to_string(stage));
    energy.title = name + ": energy gained, in metres of height";
    energy.bound = bounds[stage == Stage::drop ? "drop-energy" : "hang-energy"];
    gap.title = name + ": largest gap of a joint, m";
    gap.bound = bounds["gap"];
    curves.push_back(std::move(energy));
    curves.push_back(std::move(gap));
  }
  return curves;
}

}  // namespace

std::string render_plot(const Checked& checked, const Bounds& bounds) {
  const std::vector<Curve> curves = curves_of(checked.result, bounds);
  constexpr double kTitle = 30;
  const double height = kTitle + kHeight * static_cast<double>(curves.size());
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + pixels(kWidth) +
                    "\" height=\"" + pixels(height) +
                    "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                    "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
                    "<text x=\"10\" y=\"20\" font-size=\"14\" font-weight=\"bold\">" +
                    escaped(checked.job->path) + "</text>\n";
  double top = kTitle;
  for (const Curve& curve : curves) {
    out += Panel(curve, top).draw();
    top += kHeight;
  }
  return out + "</svg>\n";
}

}  // namespace smurf::load_check
