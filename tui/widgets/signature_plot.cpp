#include "tui/widgets/signature_plot.hpp"

#include "updating/localisation/absorber_law.hpp"
#include "updating/localisation/signature.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::tui {
namespace {

using updating::Signature;

/// Re z of the three laws at s = j w: mass -w^2 m, spring k; dashpot Im w c.
Curve law_curve(const std::string& label,
                const Eigen::VectorXd& frequency_hz,
                const Pen& pen,
                double m,
                double k,
                double c) {
  const Eigen::ArrayXd w = 2.0 * std::numbers::pi * frequency_hz.array();
  Curve curve{label, frequency_hz, {}, {}, {}, pen};
  const Eigen::ArrayXd re = k - m * w.square();
  const Eigen::ArrayXd im = c * w;
  curve.y = c != 0.0 ? im.matrix() : re.matrix();
  return curve;
}

/// Re z of the absorber.
Curve absorber_curve(const Signature& s) {
  using namespace std::complex_literals;
  const Eigen::VectorXcd jw = 2.0i * std::numbers::pi * s.frequency_hz;
  return {"absorber law",
          s.frequency_hz,
          updating::absorber_stiffness(s.absorber, jw).real(),
          {},
          {},
          {Colour::Red, Pattern::Dashed, 'a'}};
}

/// The parts of z; stretches whose deviation is beyond the plot's sense are
/// left in, since the eye weighs them by their scatter.
Plot laws_plot(const Signature& s,
               const PlotRange& range,
               bool all_laws,
               bool resonant) {
  Plot plot;
  const Eigen::Index n = s.frequency_hz.size();
  const double lo = n > 1 ? s.frequency_hz[0] : 0.0;
  const double hi = n > 1 ? s.frequency_hz[n - 1] : 1.0;
  const PlotRange shown = resolved(range, lo, hi);
  plot.x = {"f", "Hz", shown.lo, shown.hi, false};
  plot.y = {"missing z", "N/m", 0.0, 0.0, false};
  if (shown.cursor_set) plot.cursor = shown.cursor;
  if (s.z.size() != n || n == 0) return plot;
  Curve real{"Re z", s.frequency_hz, s.z.real(), {}, {}, {Colour::Sky}};
  Curve imaginary{"Im z",
                  s.frequency_hz,
                  s.z.imag(),
                  {},
                  {},
                  {Colour::Purple, Pattern::Dotted, '+'}};
  plot.curves = {real, imaginary};
  const double best = std::min(
      {s.mass_unexplained, s.spring_unexplained, s.dashpot_unexplained});
  const auto wanted = [&](double left) {
    return all_laws || (left == best && !resonant);
  };
  const auto add = [&](const std::string& label,
                       const Pen& pen,
                       double m,
                       double k,
                       double c) {
    plot.curves.push_back(law_curve(label, s.frequency_hz, pen, m, k, c));
  };
  const Pen first{Colour::Orange, Pattern::Dashed, 'o'};
  if (wanted(s.mass_unexplained)) add("mass law", first, s.mass_kg, 0.0, 0.0);
  if (wanted(s.spring_unexplained)) {
    const Pen pen = all_laws ? Pen{Colour::Green, Pattern::Dashed, 'k'} : first;
    add("spring law", pen, 0.0, s.spring_n_per_m, 0.0);
  }
  if (wanted(s.dashpot_unexplained)) {
    const Pen pen =
        all_laws ? Pen{Colour::Yellow, Pattern::Dashed, 'c'} : first;
    add("dashpot law", pen, 0.0, 0.0, s.dashpot_ns_per_m);
  }
  if ((all_laws || resonant) && s.absorber.mass_kg > 0.0) {
    plot.curves.push_back(absorber_curve(s));
  }
  return plot;
}

/// A few wild lines (no response there) must not flatten the rest: the y
/// range holds the inner 90 % of the values.
void hold_inner_range(Plot& plot) {
  std::vector<double> values;
  for (const Curve& curve : plot.curves) {
    for (Eigen::Index i = 0; i < curve.y.size(); ++i) {
      const bool shown = curve.x[i] >= plot.x.lo && curve.x[i] <= plot.x.hi;
      if (shown && std::isfinite(curve.y[i])) values.push_back(curve.y[i]);
    }
  }
  if (values.size() < 20) return;
  std::sort(values.begin(), values.end());
  const double low = values[values.size() / 20];
  const double high = values[values.size() - 1 - values.size() / 20];
  if (!(low < high)) return;
  plot.y.lo = low - 0.25 * (high - low);
  plot.y.hi = high + 0.25 * (high - low);
}

}  // namespace

Plot signature_plot(const Signature& signature,
                    const PlotRange& range,
                    bool all_laws,
                    bool resonant) {
  Plot plot = laws_plot(signature, range, all_laws, resonant);
  hold_inner_range(plot);
  return plot;
}

}  // namespace tapfit::tui
