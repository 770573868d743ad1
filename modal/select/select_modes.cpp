#include "modal/select/select_modes.hpp"

#include "acquisition/samples/statistics.hpp"
#include "modal/fit/fit_residual.hpp"
#include "modal/fit/pole_covariance.hpp"
#include "modal/fit/shapes.hpp"
#include "modal/mode_set/complexity.hpp"
#include "modal/mode_set/mac.hpp"
#include "modal/select/close_modes.hpp"
#include "modal/select/lost_pole_recovery.hpp"
#include "modal/select/needed_modes.hpp"
#include "modal/select/out_of_band_modes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double surely = 1.5;  // of residues in phase, over what is asked

bool lasts(const Track& track, std::size_t orders) {
  const auto least = std::max<std::size_t>(
      4, static_cast<std::size_t>(0.15 * static_cast<double>(orders)));
  return track.poles.size() >= least && track.share > 0.5 &&
         2 * track.stable >= static_cast<int>(track.poles.size());
}

/// Poles of one mode cannot be told apart closer than this [rad/s].
double resolution(const WeightedFrfs& curves, const Complex& pole) {
  return std::max(0.3 * std::abs(pole.real()), 0.05 * curves.spacing);
}

/// Whether two tracks run side by side: then they are two poles, while pieces
/// of one track have hardly an order in common.
bool run_together(const Track& a, const Track& b) {
  std::vector<int> both;
  std::ranges::set_intersection(a.orders, b.orders, std::back_inserter(both));
  return 2 * both.size() >= std::min(a.orders.size(), b.orders.size());
}

}  // namespace

Eigen::VectorXcd lasting_poles(const WeightedFrfs& curves,
                               const std::vector<Track>& tracks,
                               std::size_t orders) {
  std::vector<const Track*> good;
  for (const Track& track : tracks) {
    if (lasts(track, orders)) good.push_back(&track);
  }
  std::ranges::sort(good, std::ranges::greater{}, [](const Track* track) {
    return track->stable;
  });
  std::vector<Complex> poles;
  std::vector<const Track*> taken;
  for (const Track* track : good) {
    const bool repeated = std::ranges::any_of(taken, [&](const Track* other) {
      const double apart = std::abs(track->pole - other->pole);
      const double alike =
          mac(track->participation, other->participation)(0, 0);
      return apart < resolution(curves, track->pole) && alike > 0.8 &&
             !run_together(*track, *other);
    });
    if (repeated) continue;
    taken.push_back(track);
    poles.push_back(track->pole);
  }
  std::ranges::sort(poles, {}, [](const Complex& p) { return std::abs(p); });
  return Eigen::Map<Eigen::VectorXcd>(poles.data(),
                                      static_cast<Index>(poles.size()));
}

namespace {

/// Residual power per line over what is usual, averaged over the half
/// bandwidth that a line's neighbours share.
Eigen::VectorXd left_over(const WeightedFrfs& curves, const ModalFit& fit) {
  const Eigen::VectorXd power =
      left_per_line(curves, fit, {{0, curves.lines()}});
  Eigen::VectorXd smooth(power.size());
  for (Index k = 0; k < power.size(); ++k) {
    const Index begin = std::max<Index>(0, k - 2);
    const Index n = std::min(power.size(), k + 3) - begin;
    smooth(k) = power.segment(begin, n).mean();
  }
  return smooth / std::max(acquisition::median(smooth), 1e-300);
}

/// Damping over its standard deviation, per mode.
Eigen::VectorXd resolved(const WeightedFrfs& curves, const ModalFit& fit) {
  const Eigen::MatrixXd covariance = pole_covariance(curves, fit);
  Eigen::VectorXd result(fit.poles.size());
  for (Index r = 0; r < fit.poles.size(); ++r) {
    const double sd = std::sqrt(std::max(0.0, covariance(2 * r, 2 * r)));
    result(r) = -fit.poles(r).real() / std::max(sd, 1e-300);
  }
  return result;
}

/// Whether a pole that no track speaks for is a mode: well resolved, in phase,
/// a good part of the FRFs at its frequency, damped like the others and not
/// beside one of them, where it could only mend that one's misfit.
bool is_convincing(const WeightedFrfs& curves, const ModalFit& fit, Index r) {
  const Complex pole = fit.poles(r);
  const double zeta = -pole.real() / std::abs(pole);
  if (!in_band(curves, pole) || fit.contribution(r) < 0.25) return false;
  if (zeta > 4.0 * usual_damping(curves, fit)) return false;
  if (curves.count() > 2 && phase_collinearity(fit.residues.col(r)) < 0.6) {
    return false;
  }
  for (Index q = 0; q < fit.poles.size(); ++q) {
    const double width = std::max(-pole.real(), -fit.poles(q).real());
    if (q != r && std::abs(fit.poles(q) - pole) < 3.0 * width) return false;
  }
  return resolved(curves, fit)(r) > 10.0;
}

/// Looks for modes that no track told of where the residual has a peak, for
/// example one that hardly moves the references.
ModalFit recover_missed(const WeightedFrfs& curves,
                        ModalFit fit,
                        const IdentifyOptions& options,
                        const Progress& progress) {
  constexpr double peak = 1.5;
  constexpr int in_vain = 6;
  Eigen::VectorXd open = Eigen::VectorXd::Ones(curves.lines());
  int failures = 0;
  while (failures < in_vain) {
    progress("missed modes", static_cast<double>(failures) / in_vain);
    Index line = 0;
    if (left_over(curves, fit).cwiseProduct(open).maxCoeff(&line) < peak) {
      break;
    }
    const double omega = curves.s(line).imag();
    Eigen::VectorXcd poles(fit.poles.size() + 1);
    poles << fit.poles, Complex(-usual_damping(curves, fit) * omega, omega);
    ModalFit trial = refine_poles(curves, poles, 12);
    const Index last = trial.poles.size() - 1;
    if (are_needed(curves, trial, options) &&
        is_convincing(curves, trial, last)) {
      fit = std::move(trial);
    } else {
      ++failures;
    }
    const Index begin = std::max<Index>(0, line - 8);
    open.segment(begin, std::min(curves.lines(), line + 9) - begin).setZero();
  }
  return fit;
}

/// Takes out modes until all that stay are needed.
ModalFit drop_weak(const WeightedFrfs& curves,
                   ModalFit fit,
                   const IdentifyOptions& options,
                   const Progress& progress) {
  const auto total = static_cast<double>(fit.poles.size() + 1);
  while (fit.poles.size() > 0) {
    progress("residues", 1.0 - static_cast<double>(fit.poles.size()) / total);
    const Index worst = weakest_mode(curves, fit, options);
    if (worst < 0) break;
    fit = refine_in_reach(curves, without(fit.poles, worst), 4);
  }
  return fit;
}

/// Takes out what has no damping to speak of (hum) or neither a clear damping
/// nor points that move in phase (noise).
void drop_unresolved(const WeightedFrfs& curves, Selection& selection) {
  ModalFit& fit = selection.fit;
  while (fit.poles.size() > 0) {
    const Eigen::VectorXd certainty = resolved(curves, fit);
    Index worst = -1;
    double least = 1.0;
    for (Index r = 0; r < fit.poles.size(); ++r) {
      if (far_outside(curves, fit.poles(r))) continue;
      const bool in_phase = phase_collinearity(fit.residues.col(r)) > 0.8;
      const double worth = certainty(r) / (in_phase ? 3.0 : 8.0);
      if (worth >= least) continue;
      least = worth;
      worst = r;
    }
    if (worst < 0) return;
    if (in_band(curves, fit.poles(worst))) {
      selection.unresolved.push_back(fit.poles(worst));
    }
    fit = refine_in_reach(curves, without(fit.poles, worst), 6);
  }
}

/// 1 or more where a shape's points move in phase as the options ask.
double in_phase(const Eigen::VectorXcd& shape, const IdentifyOptions& options) {
  const double mpc = phase_collinearity(shape);
  const double mpd = mean_phase_deviation(shape);
  return std::min(
      options.least_mpc > 0.0 ? mpc / options.least_mpc : 1.0,
      mpd > options.largest_mpd_deg ? options.largest_mpd_deg / mpd : 1.0);
}

/// Takes out, most complex first, what does not move in phase.
void drop_complex(const WeightedFrfs& curves,
                  const IdentifyOptions& options,
                  Selection& selection) {
  ModalFit& fit = selection.fit;
  std::vector<std::string> said;  // by whoever asked for the shapes
  const ShapeGraph graph = shape_graph(curves, said);
  while (curves.count() > 2 && fit.poles.size() > 0) {
    Index worst = -1;
    double least = 1.0;
    for (Index r = 0; r < fit.poles.size(); ++r) {
      if (!in_band(curves, fit.poles(r)) || is_crowded(fit, r)) continue;
      // Residues are products of two values of the shape: hardly ever are they
      // more in phase than it is, and they are at hand.
      if (in_phase(fit.residues.col(r), options) >= surely) continue;
      const double worth = in_phase(mode_shapes(graph,
                                                fit.residues.col(r),
                                                fit.poles.segment(r, 1),
                                                fit.frf_weight),
                                    options);
      if (worth >= least) continue;
      least = worth;
      worst = r;
    }
    if (worst < 0) return;
    selection.out_of_phase.push_back(fit.poles(worst));
    fit = refine_in_reach(curves, without(fit.poles, worst), 6);
  }
}

}  // namespace

Selection select_modes(const WeightedFrfs& curves,
                       const Eigen::VectorXcd& lasting,
                       const IdentifyOptions& options,
                       const Progress& progress) {
  Selection selection;
  ModalFit& fit = selection.fit;
  fit = refine_in_reach(curves, lasting, 6);
  fit = drop_weak(curves, std::move(fit), options, progress);
  if (fit.poles.size() > 0) {
    add_out_of_band_modes(curves, fit);
    fit = refine_in_reach(curves, fit.poles, 20);
    fit = drop_weak(curves, std::move(fit), options, progress);
    fit = recover_lost_poles(curves, lasting, std::move(fit), options);
    drop_unresolved(curves, selection);
  }
  const std::vector<Complex> told = selection.unresolved;
  fit = recover_missed(curves, std::move(fit), options, progress);
  drop_unresolved(curves, selection);
  // What was only tried is not worth telling.
  selection.unresolved = told;
  fit = at_rest_by_one_reference(curves, std::move(fit));
  drop_complex(curves, options, selection);
  fit = merge_unresolved_poles(curves, std::move(fit), selection.shifting);
  const Index before = fit.poles.size();
  fit = separate_close(curves, std::move(fit), options);
  // What stood for the modes that were hidden is needed no more.
  if (fit.poles.size() > before) {
    fit = drop_weak(curves, std::move(fit), options, progress);
  }
  fit = merge_unresolved_poles(curves, std::move(fit), selection.shifting);
  // One that a mode stands for now was not left out.
  std::erase_if(selection.unresolved, [&fit](const Complex& left_out) {
    return std::ranges::any_of(fit.poles, [&](const Complex& pole) {
      return std::abs(pole - left_out) < -pole.real();
    });
  });
  if (fit.poles.size() > 0) fit = by_frequency(curves, fit);
  return selection;
}

}  // namespace tapfit::modal
