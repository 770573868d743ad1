#include "updating/prediction/predicted_modes.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "modal/mode_set/pairing.hpp"
#include "updating/prediction/damping_with.hpp"
#include "updating/prediction/form_shift.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of a logarithm: the error of a central difference is a millionth.
constexpr double small_step = 1e-3;

/// The first modes before and after the change.
struct BothModes {
  BaseModes now;
  BaseModes after;
  std::vector<Index> becomes;  ///< of each mode now the one after
  MatrixXd u;                  ///< modes after in those now, n_now x count
  MatrixXd of_now;             ///< modes now in those after, count x n_now
};

// Columns with what sits on springs of its own, below the base's coordinates.
MatrixXd with_own(const BaseModes& modes) {
  MatrixXd all(modes.phi.rows() + modes.own.rows(), modes.phi.cols());
  all << modes.phi, modes.own;
  return all;
}

// What a change of the same coordinates makes of no mode: one that raises all
// frequencies, each of its order, lowers none, and one that lowers all raises
// none, whichever shapes look alike: the second mode of a beam whose tip is held
// is likest to the third of the free one.
//
// Source: J. W. S. Rayleigh, "The Theory of Sound", 2nd ed., 1894, section 88.
void forbid_other_side(const VectorXd& now,
                       const VectorXd& after,
                       MatrixXd& cost) {
  constexpr double forbidden = 1e3;  // beside shares of one at most
  const Index modes = cost.rows();
  if (modes == 0) return;
  const double rounding = 1e-6 * now(modes - 1);
  const auto change = (after.head(modes) - now.head(modes)).array();
  const bool raises = (change > -rounding).all();
  const bool lowers = (change < rounding).all();
  for (Index i = 0; i < modes; ++i) {
    for (Index k = 0; k < cost.cols(); ++k) {
      const double moved = after(k) - now(i);
      if ((raises && moved < -rounding) || (lowers && moved > rounding)) {
        cost(i, k) = forbidden;
      }
    }
  }
}

// By shape: of modes that change places each keeps its own. What the change
// brings on springs of its own is at rest in the modes now.
BothModes both_modes(const ChangedModel& model) {
  BothModes both{model.now->full_modes(model.state),
                 model.after->full_modes(model.changed()),
                 {},
                 {},
                 {}};
  const double top = two_pi * 1.5 * model.now->context().high_hz;
  const MatrixXd now = with_own(both.now);
  const MatrixXd after = with_own(both.after);
  const Index r = now.rows();
  const Index first = (both.now.omega.array() < top).count();
  const Index all = std::min(
      after.rows(),
      std::max<Index>(first, (both.after.omega.array() < top).count()) + 3);
  both.u = now.partialPivLu().solve(after.topLeftCorner(r, all));
  MatrixXd at_rest = MatrixXd::Zero(after.rows(), r);
  at_rest.topRows(r) = now;
  both.of_now = after.partialPivLu().solve(at_rest).topRows(all);
  // By the share of a mode's energy: an absorber's own mode has little of any.
  MatrixXd cost = -both.u.topRows(first).cwiseAbs2();
  if (after.rows() == r) {
    forbid_other_side(both.now.omega, both.after.omega, cost);
  }
  if (first > 0) both.becomes = modal::assign(cost);
  return both;
}

/// d ln f / d theta of the first modes, by frequency.
struct Slopes {
  MatrixXd now;    ///< modes x theta
  MatrixXd after;  ///< modes x theta
};

// Damping moves no undamped frequency.
Slopes slopes(const ChangedModel& model, const BothModes& both) {
  const VectorXd theta = pack(model.state);
  const auto first_zeta = static_cast<Index>(model.state.factor.size());
  const Index last_zeta = first_zeta + model.state.zeta.size();
  const auto modes = static_cast<Index>(both.becomes.size());
  Slopes result{MatrixXd::Zero(modes, theta.size()),
                MatrixXd::Zero(both.u.cols(), theta.size())};
  const auto slope = [](const VectorXd& up,
                        const VectorXd& down,
                        const VectorXd& at,
                        Eigen::Ref<VectorXd> to) {
    for (Index i = 0; i < to.size(); ++i) {
      if (at(i) > 0.0) to(i) = (up(i) - down(i)) / (2.0 * small_step * at(i));
    }
  };
  for_each_parallel(static_cast<std::size_t>(theta.size()), [&](std::size_t k) {
    const auto own = static_cast<Index>(k);
    if (own >= first_zeta && own < last_zeta) return;
    VectorXd up = theta;
    VectorXd down = theta;
    up(own) += small_step;
    down(own) -= small_step;
    slope(model.now->full_modes(unpack(model.state, up)).omega,
          model.now->full_modes(unpack(model.state, down)).omega,
          both.now.omega,
          result.now.col(own));
    slope(model.after->full_modes(model.changed(up)).omega,
          model.after->full_modes(model.changed(down)).omega,
          both.after.omega,
          result.after.col(own));
  });
  return result;
}

Estimate of_logarithm(const char* name, double value, double variance) {
  const double sd = std::sqrt(std::max(variance, 0.0));
  return {name,
          value,
          value * sd,
          value * std::exp(-1.96 * sd),
          value * std::exp(1.96 * sd)};
}

/// Variances of ln f now and after, and their covariance.
struct Spread {
  double now = 0.0;
  double after = 0.0;
  double both = 0.0;

  [[nodiscard]] double of_ratio() const { return now + after - 2.0 * both; }
};

void set_change(const Spread& spread, PredictedMode& mode) {
  const double n = mode.model_hz;
  const double a = mode.model_after_hz;
  Estimate& hz = mode.change_hz;
  hz = {"change_hz", a - n};
  hz.sd = std::sqrt(std::max(
      0.0,
      a * a * spread.after + n * n * spread.now - 2.0 * a * n * spread.both));
  hz.lo95 = hz.value - 1.96 * hz.sd;
  hz.hi95 = hz.value + 1.96 * hz.sd;
  const Estimate ratio = of_logarithm("", a / n, spread.of_ratio());
  mode.change_percent = {"change_percent",
                         100.0 * (ratio.value - 1.0),
                         100.0 * ratio.sd,
                         100.0 * (ratio.lo95 - 1.0),
                         100.0 * (ratio.hi95 - 1.0)};
}

// The best linear estimate, see the head.
void set_frequency(const Spread& spread, PredictedMode& mode) {
  double log = std::log(mode.model_after_hz);
  double variance = spread.after;
  if (mode.measured) {
    const double off = std::log(mode.measured_hz / mode.model_hz);
    const double all =
        spread.now + std::pow(mode.measured_sd_hz / mode.measured_hz, 2);
    const double gain = all > 0.0 ? spread.both / all : 0.0;
    if (all > 0.0) mode.misfit_sd = off / std::sqrt(all);
    log += gain * off;
    variance -= gain * spread.both;
  }
  mode.frequency_hz = of_logarithm("frequency_hz", std::exp(log), variance);
}

// A mode's ratio without dampers stays the mode's own.
void set_damping(const ChangedModel& model,
                 const BothModes& both,
                 const KnownNow& known,
                 PredictedMode& mode) {
  const Index i = mode.model;
  const Index k = both.becomes[static_cast<std::size_t>(i)];
  const bool fitted =
      model.state.damping_law() != nullptr || i < model.state.zeta.size();
  const modal::Mode* seen =
      mode.measured
          ? &known.measured.modes[static_cast<std::size_t>(*mode.measured)]
          : nullptr;
  if (!fitted && (seen == nullptr || !(seen->damping_ratio > 0.0))) return;
  const auto own = [&](const ModelState& state, double omega) {
    if (!fitted) return seen->damping_ratio;
    return state.damping_law() != nullptr ? state.zeta_at(omega)
                                          : state.zeta(i);
  };
  const double added_now = added_damping(*model.now,
                                         model.state,
                                         both.now.phi.col(i),
                                         both.now.omega(i),
                                         known.runs);
  const auto after = [&](const VectorXd& theta) {
    const ModelState state = model.changed(theta);
    const double w = both.after.omega(k);
    // What dampers add is in a measured ratio already.
    return own(state, w) - (fitted ? 0.0 : added_now) +
           added_damping(
               *model.after, state, both.after.phi.col(k), w, known.runs);
  };
  const VectorXd theta = pack(model.state);
  VectorXd slope = VectorXd::Zero(theta.size());
  for (auto p = static_cast<Index>(model.state.factor.size()); p < theta.size();
       ++p) {
    VectorXd up = theta;
    VectorXd down = theta;
    up(p) += small_step;
    down(p) -= small_step;
    slope(p) = (after(up) - after(down)) / (2.0 * small_step);
  }
  const double value = after(theta);
  if (!(value > 0.0)) return;
  double variance = slope.dot(known.covariance * slope);
  if (!fitted) variance += seen->damping_sd * seen->damping_sd;
  mode.damping_now =
      own(model.state, both.now.omega(i)) + (fitted ? added_now : 0.0);
  mode.damping_ratio =
      of_logarithm("damping_ratio", value, variance / (value * value));
}

void set_measured(const KnownNow& known, PredictedMode& mode) {
  const auto pair =
      std::ranges::find(known.pairs, mode.model, &ModePair::model);
  if (pair == known.pairs.end()) return;
  mode.measured = pair->measured;
  const modal::Mode& seen =
      known.measured.modes[static_cast<std::size_t>(pair->measured)];
  mode.measured_hz = seen.frequency_hz;
  mode.measured_sd_hz = seen.frequency_sd_hz;
}

Spread spread_of(Index i,
                 const BothModes& both,
                 const Slopes& d,
                 const KnownNow& known) {
  const Index k = both.becomes[static_cast<std::size_t>(i)];
  const VectorXd now = d.now.row(i).transpose();
  const VectorXd after = d.after.row(k).transpose();
  const VectorXd spread = known.covariance * after;
  const FormShift form =
      form_shift(both.now.omega,
                 {both.u.col(k), both.after.omega(k), both.of_now(k, i)},
                 i);
  const double v = known.form_variance;
  return {now.dot(known.covariance * now) + v * form.now,
          after.dot(spread) + v * form.after,
          now.dot(spread) + v * form.both};
}

}  // namespace

std::vector<PredictedMode> predicted_modes(const ChangedModel& model,
                                           const KnownNow& known) {
  const BothModes both = both_modes(model);
  const Slopes d = slopes(model, both);
  const effects::TestContext& context = model.now->context();
  const auto in_band = [&context](double hz) {
    return context.low_hz <= hz && hz <= context.high_hz;
  };
  std::vector<PredictedMode> modes;
  for (std::size_t m = 0; m < both.becomes.size(); ++m) {
    const auto i = static_cast<Index>(m);
    const Index k = both.becomes[m];
    PredictedMode mode;
    mode.model = static_cast<int>(m);
    mode.model_hz = both.now.omega(i) / two_pi;
    mode.model_after_hz = both.after.omega(k) / two_pi;
    set_measured(known, mode);
    const bool shows = mode.measured.has_value() || in_band(mode.model_hz) ||
                       in_band(mode.model_after_hz);
    // What is as good as rigid has no ratio of frequencies.
    if (!shows || !(mode.model_hz > 0.0 && mode.model_after_hz > 0.0)) continue;
    mode.mac = both.u(i, k) * both.u(i, k) / both.u.col(k).squaredNorm();
    mode.phi = both.after.phi.col(k);
    const Spread spread = spread_of(i, both, d, known);
    set_frequency(spread, mode);
    set_change(spread, mode);
    set_damping(model, both, known, mode);
    modes.push_back(std::move(mode));
  }
  return modes;
}

std::vector<double> new_frequencies(const ChangedModel& model) {
  const BothModes both = both_modes(model);
  if (both.after.own.rows() == both.now.own.rows()) return {};
  const effects::TestContext& context = model.now->context();
  std::vector<double> fresh;
  for (Index k = 0; k < both.u.cols(); ++k) {
    const double hz = both.after.omega(k) / two_pi;
    const bool known = std::ranges::find(both.becomes, k) != both.becomes.end();
    if (!known && hz >= context.low_hz && hz <= context.high_hz) {
      fresh.push_back(hz);
    }
  }
  return fresh;
}

}  // namespace tapfit::updating
