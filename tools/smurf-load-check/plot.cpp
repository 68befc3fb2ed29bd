// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/edits.hpp"
#include "base/numbers.hpp"
#include "base/path.hpp"
#include "smurf-load-check/trace.hpp"

namespace smurf::load_check {
namespace {

// In pixels. Energy is on the left, the gap on the right; each stage is a row.
constexpr double kPanelWidth = 450;
constexpr double kPanelHeight = 190;
constexpr double kLeft = 84;
constexpr double kRight = 16;
constexpr double kTop = 46;
constexpr double kBottom = 28;

std::string pixels(double value) { return format_number(std::round(value * 100) / 100); }

struct Curve {
  std::string_view what;
  std::vector<double> times, values;
  std::optional<double> bound;  ///< none: the stage does not check it
};

/// One panel: a headline with the largest value and its bound, axes, and the curve. The bound is a
/// dashed line if it is in the visible range.
class Panel {
 public:
  Panel(const Curve& curve, double left, double top) : curve_(curve), left_(left), top_(top) {
    low_ = std::min(0.0, *std::min_element(curve.values.begin(), curve.values.end()));
    peak_ = *std::max_element(curve.values.begin(), curve.values.end());
    high_ = std::max(0.0, peak_);
    // Rounding errors must not fill the picture.
    constexpr double kSmallest = 1e-7;  // m
    if (high_ - low_ < kSmallest) high_ = low_ + kSmallest;
    // A bound far above the curve would flatten it.
    constexpr double kSight = 5;
    is_bound_seen_ = curve.bound && *curve.bound <= kSight * high_;
    if (is_bound_seen_) high_ = std::max(high_, *curve.bound);
    end_ = std::max(curve.times.back(), 1e-9);
  }

  std::string draw() const {
    const double right = left_ + kPanelWidth - kRight;
    const double bottom = top_ + kPanelHeight - kBottom;
    std::string out = label(left_ + kLeft, top_ + kTop - 12, "start", curve_.what, kInk);
    out += label(right, top_ + kTop - 12, "end", summary(), is_within() ? kQuiet : kAlarm);
    out += line(left_ + kLeft, top_ + kTop, left_ + kLeft, bottom, kGrid, "");
    for (const double value : {low_, high_}) out += grid(value, right);
    if (low_ < 0 && y(0) - y(high_) > kLabelHeight && y(low_) - y(0) > kLabelHeight) {
      out += grid(0, right);
    } else if (low_ < 0) {
      out += line(left_ + kLeft, y(0), right, y(0), kGrid, "");
    }
    out += label(left_ + kLeft, bottom + 16, "middle", "0", kQuiet);
    out += label(right, bottom + 16, "end", format_rounded(end_, 3) + " s", kQuiet);
    if (is_bound_seen_) {
      out += line(left_ + kLeft, y(*curve_.bound), right, y(*curve_.bound), kAlarm, "6 4");
    }
    out += "<polyline fill=\"none\" stroke=\"#1f6fb4\" stroke-width=\"1.5\" "
           "stroke-linejoin=\"round\" points=\"";
    for (std::size_t i = 0; i < curve_.times.size(); ++i) {
      out += (i > 0 ? " " : "") + pixels(x(curve_.times[i])) + "," + pixels(y(curve_.values[i]));
    }
    return out + "\"/>\n";
  }

 private:
  static constexpr std::string_view kInk = "#222";
  static constexpr std::string_view kQuiet = "#666";
  static constexpr std::string_view kGrid = "#ddd";
  static constexpr std::string_view kAlarm = "#c0392b";
  static constexpr double kLabelHeight = 14;

  bool is_within() const { return !curve_.bound || peak_ <= *curve_.bound; }  // NaN is not

  std::string summary() const {
    const std::string peak = "peak " + format_rounded(std::max(0.0, peak_), 3) + " m";
    return curve_.bound ? peak + ", bound " + format_rounded(*curve_.bound, 3) + " m" : peak;
  }

  double x(double time) const {
    return left_ + kLeft + (kPanelWidth - kLeft - kRight) * time / end_;
  }
  double y(double value) const {
    return top_ + kTop + (kPanelHeight - kTop - kBottom) * (high_ - value) / (high_ - low_);
  }

  std::string grid(double value, double right) const {
    return line(left_ + kLeft, y(value), right, y(value), kGrid, "") +
           label(left_ + kLeft - 8, y(value) + 4, "end", format_rounded(value, 3), kQuiet);
  }

  static std::string line(double x1, double y1, double x2, double y2, std::string_view color,
                          std::string_view dashes) {
    std::string out = "<line x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) + "\" x2=\"" +
                      pixels(x2) + "\" y2=\"" + pixels(y2) + "\" stroke=\"" + std::string(color) +
                      "\"";
    if (!dashes.empty()) out += " stroke-dasharray=\"" + std::string(dashes) + "\"";
    return out + "/>\n";
  }

  static std::string label(double x, double y, std::string_view anchor, std::string_view text,
                           std::string_view color) {
    return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" text-anchor=\"" +
           std::string(anchor) + "\" fill=\"" + std::string(color) + "\">" + escape_xml(text) +
           "</text>\n";
  }

  const Curve& curve_;
  double left_, top_;
  double low_ = 0, high_ = 0, peak_ = 0, end_ = 0;
  bool is_bound_seen_ = false;
};

struct Row {
  Stage stage;
  Curve energy, gap;
};

std::vector<Row> rows_of(const CheckResult& result, const Bounds& bounds) {
  std::vector<Row> rows;
  for (const Stage stage : {Stage::still, Stage::hang, Stage::drop, Stage::anchor}) {
    Row row{stage, {"energy gained", {}, {}, {}}, {"largest gap of a joint", {}, {}, {}}};
    for (const Sample& sample : result.samples) {
      // Values that grow to infinity leave the picture.
      if (sample.stage != stage || !std::isfinite(sample.energy + sample.gap)) continue;
      for (Curve* curve : {&row.energy, &row.gap}) curve->times.push_back(sample.time);
      row.energy.values.push_back(sample.energy);
      row.gap.values.push_back(sample.gap);
    }
    if (row.energy.times.empty()) continue;
    if (stage == Stage::hang) {
      row.energy.bound = bounds["hang-energy"];
      row.gap.bound = bounds["gap"];
    }
    if (stage == Stage::drop) row.energy.bound = bounds["drop-energy"];
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

std::string render_plot(const Checked& checked, const Bounds& bounds) {
  const std::vector<Row> rows = rows_of(checked.result, bounds);
  constexpr double kTitle = 34;
  const double height = kTitle + kPanelHeight * static_cast<double>(rows.size());
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + pixels(2 * kPanelWidth) +
                    "\" height=\"" + pixels(height) +
                    "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                    "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
                    "<text x=\"16\" y=\"24\" font-size=\"15\" font-weight=\"bold\">" +
                    escape_xml(path::file_name(checked.job->path)) + "</text>\n<text x=\"" +
                    pixels(2 * kPanelWidth - kRight) +
                    "\" y=\"24\" text-anchor=\"end\" fill=\"#666\">energy is divided by the "
                    "weight: a height</text>\n";
  double top = kTitle;
  for (const Row& row : rows) {
    out += "<text x=\"16\" y=\"" + pixels(top + kTop - 12) + "\" font-weight=\"bold\">" +
           std::string(to_string(row.stage)) + "</text>\n";
    out += Panel(row.energy, 0, top).draw() + Panel(row.gap, kPanelWidth, top).draw();
    top += kPanelHeight;
  }
  return out + "</svg>\n";
}

}  // namespace smurf::load_check
