#include "tui/widgets/signature_plot.hpp"

#include "updating/localisation/signature_laws.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

using updating::Signature;
using updating::SignatureLaw;

/// A glyph and a colour of its own where several are shown.
Pen pen_of(const SignatureLaw& law, bool all_laws) {
  if (law.effect == "absorber") return {Colour::Red, Pattern::Dashed, 'a'};
  if (all_laws && law.effect == "spring") {
    return {Colour::Green, Pattern::Dashed, 'k'};
  }
  if (all_laws && law.effect == "dashpot") {
    return {Colour::Yellow, Pattern::Dashed, 'c'};
  }
  return {Colour::Orange, Pattern::Dashed, 'o'};
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
  const auto add = [&](const std::string& label,
                       const Eigen::VectorXd& values,
                       const Pen& pen) {
    plot.curves.push_back({label, s.frequency_hz, values, {}, {}, pen});
  };
  add("Re z", s.z.real(), {Colour::Sky});
  add("Im z", s.z.imag(), {Colour::Purple, Pattern::Dotted, '+'});
  const std::vector<SignatureLaw> laws =
      all_laws ? updating::signature_laws(s)
               : std::vector{updating::best_law(s, resonant)};
  for (const SignatureLaw& law : laws) {
    add(law.effect + " law", law.shown(), pen_of(law, all_laws));
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
