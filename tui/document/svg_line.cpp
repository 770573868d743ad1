#include "tui/document/svg_line.hpp"

#include "tui/document/svg_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tapfit::tui {
namespace {

using Point = std::pair<double, double>;

/// Appends a run of points, of each pixel column the lowest and the highest.
void append_run(std::string& d, const std::vector<Point>& run, double column) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < run.size();) {
    std::size_t low = i;
    std::size_t high = i;
    std::size_t end = i;
    const double cell = std::floor(run[i].first / column);
    while (end < run.size() && std::floor(run[end].first / column) == cell) {
      if (run[end].second < run[low].second) low = end;
      if (run[end].second > run[high].second) high = end;
      ++end;
    }
    kept.push_back(run[std::min(low, high)]);
    if (low != high) kept.push_back(run[std::max(low, high)]);
    if (end == run.size() && std::max(low, high) != end - 1) {
      kept.push_back(run[end - 1]);
    }
    i = end;
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    d += (i == 0   ? "M"
          : i == 1 ? "L"
                   : " ") +
         coordinate(kept[i].first) + " " + coordinate(kept[i].second);
  }
}

/// A line as it grows, cut at the upper and the lower edge.
class CutLine {
 public:
  explicit CutLine(const Frame& frame) : frame_(frame) {}

  void to(const Point& next) {
    const bool in = holds(next.second);
    if (last_ && side(last_->second) != side(next.second)) {
      // From one side to the other it crosses both edges.
      if (!holds(last_->second)) run_.push_back(crossing(last_->second, next));
      if (!in) run_.push_back(crossing(next.second, next));
    }
    if (in) run_.push_back(next);
    if (!in) end();
    last_ = next;
  }

  void gap() {
    end();
    last_.reset();
  }

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  [[nodiscard]] bool holds(double y) const { return side(y) == 0; }
  [[nodiscard]] int side(double y) const {
    return y < frame_.top ? -1 : y > frame_.bottom ? 1 : 0;
  }
  /// Where the line to the next point meets the edge that `beyond` lies behind.
  [[nodiscard]] Point crossing(double beyond, const Point& next) const {
    const double edge = beyond < frame_.top ? frame_.top : frame_.bottom;
    const double share = (edge - last_->second) / (next.second - last_->second);
    return {last_->first + share * (next.first - last_->first), edge};
  }
  void end() {
    if (!run_.empty()) append_run(path_, run_, 1.0);
    run_.clear();
  }

  const Frame& frame_;
  std::optional<Point> last_;
  std::vector<Point> run_;
  std::string path_;
};

bool holds_across(const Frame& f, double x) {
  return x >= f.left - 0.5 && x <= f.right + 0.5;
}

}  // namespace

Scale::Scale(const Axis& axis, double at_low, double at_high)
    : log_(axis.log),
      low_(shown(axis.lo)),
      high_(shown(axis.hi)),
      at_low_(at_low),
      at_high_(at_high) {}

std::optional<double> Scale::operator()(double value) const {
  if (!std::isfinite(value) || (log_ && value <= 0.0)) return std::nullopt;
  return at_low_ +
         (shown(value) - low_) / (high_ - low_) * (at_high_ - at_low_);
}

double Scale::shown(double value) const {
  return log_ ? std::log10(value) : value;
}

std::string line_path(const Frame& frame,
                      const Scale& to_x,
                      const Scale& to_y,
                      const Eigen::VectorXd& x,
                      const Eigen::VectorXd& y) {
  CutLine line(frame);
  for (Eigen::Index k = 0; k < std::min(x.size(), y.size()); ++k) {
    const auto px = to_x(x(k));
    const auto py = to_y(y(k));
    if (px && py && holds_across(frame, *px)) {
      line.to({*px, *py});
    } else {
      line.gap();
    }
  }
  line.gap();
  return line.path();
}

std::string dotted_path(const Frame& frame,
                        const Scale& to_x,
                        const Scale& to_y,
                        const Eigen::VectorXd& x,
                        const Eigen::VectorXd& y) {
  std::string d;
  for (Eigen::Index k = 0; k < std::min(x.size(), y.size()); ++k) {
    const auto px = to_x(x(k));
    const auto py = to_y(y(k));
    if (!px || !py || !holds_across(frame, *px)) continue;
    if (*py < frame.top || *py > frame.bottom) continue;
    d += fmt::format("M{} {}h0", coordinate(*px), coordinate(*py));
  }
  return d;
}

}  // namespace tapfit::tui
