#include "modal/select/edit_poles.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "modal/fit/pole_covariance.hpp"
#include "modal/select/close_modes.hpp"
#include "modal/select/out_of_band_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double least_share = 1e-4;          // of |H| at an added pole
constexpr double near = 0.02;                 // relative
constexpr double usual_damping_ratio = 0.01;  // where the diagram tells of none

/// The pole of the steadiest track near a frequency that is no mode yet.
Complex start_near(const std::vector<Track>& tracks,
                   const ModalFit& fit,
                   double omega) {
  Complex start(-usual_damping_ratio * omega, omega);
  int most = 0;
  for (const Track& track : tracks) {
    if (std::abs(std::abs(track.pole) - omega) > 0.25 * near * omega) continue;
    const bool taken =
        fit.poles.size() > 0 &&
        (fit.poles.array() - track.pole).abs().minCoeff() < 1e-4 * omega;
    if (taken || static_cast<int>(track.poles.size()) <= most) continue;
    most = static_cast<int>(track.poles.size());
    start = track.pole;
  }
  return start;
}

/// Frequency [Hz] of the pole within a bandwidth that the last one of a fit is
/// not told apart from.
std::optional<double> untold_from(const WeightedFrfs& curves,
                                  const ModalFit& fit) {
  const Eigen::MatrixXd covariance = pole_covariance(curves, fit);
  const Index last = fit.poles.size() - 1;
  for (Index r = 0; r < last; ++r) {
    const double width = -std::min(fit.poles(r).real(), fit.poles(last).real());
    if (std::abs(fit.poles(r) - fit.poles(last)) > width) continue;
    if (are_told_apart(covariance, fit, r, last)) continue;
    return std::abs(fit.poles(r)) / two_pi;
  }
  return {};
}

}  // namespace

Index mode_to_drop(const Eigen::ArrayXd& omega, double hz) {
  const double wanted = two_pi * hz;
  Index nearest = 0;
  const bool any = omega.size() > 0;
  if (any) (omega - wanted).abs().minCoeff(&nearest);
  if (!any || std::abs(omega(nearest) - wanted) > near * wanted) {
    throw InputError(fmt::format("no mode within 2 % of {:.6g} Hz to drop", hz),
                     "modes",
                     any ? fmt::format("the nearest is at {:.6g} Hz",
                                       omega(nearest) / two_pi)
                         : std::string("no mode was found at all"));
  }
  return nearest;
}

void drop_pole(const WeightedFrfs& curves, Index pole, ModalFit& fit) {
  Eigen::VectorXcd rest(fit.poles.size() - 1);
  rest << fit.poles.head(pole), fit.poles.tail(rest.size() - pole);
  fit = fit_residues(curves, rest);
  if (rest.size() == 0) return;
  ModalFit refined = refine_poles(curves, rest, 10);
  // A pole that goes where one was taken out would bring it back.
  const Eigen::ArrayXd moved = (refined.poles - rest).array().abs();
  if ((moved <= near * rest.array().abs()).all()) fit = std::move(refined);
}

void add_pole(const WeightedFrfs& curves,
              const std::vector<Track>& tracks,
              double hz,
              ModalFit& fit) {
  const double omega = two_pi * hz;
  if (!in_band(curves, omega)) {
    throw InputError(fmt::format("no mode can be put in at {:.6g} Hz", hz),
                     "modes",
                     fmt::format("the lines go from {:.6g} to {:.6g} Hz",
                                 curves.s(0).imag() / two_pi,
                                 curves.s(curves.lines() - 1).imag() / two_pi));
  }
  Eigen::VectorXcd poles(fit.poles.size() + 1);
  poles << fit.poles, start_near(tracks, fit, omega);
  ModalFit trial = refine_poles(curves, poles, 20);
  const Complex last = trial.poles(trial.poles.size() - 1);
  if (last.real() >= 0.0 || std::abs(std::abs(last) - omega) > near * omega) {
    throw InputError(
        fmt::format("no pole can be fitted at {:.6g} Hz: it goes to {:.6g} Hz, "
                    "damping {:.2g}",
                    hz,
                    std::abs(last) / two_pi,
                    -last.real() / std::abs(last)),
        "modes",
        "choose a frequency at which the stabilisation diagram has poles");
  }
  const double share = trial.contribution(trial.poles.size() - 1);
  if (share < least_share) {
    throw InputError(
        fmt::format("a pole put in at {:.6g} Hz carries {:.1g} of the FRFs "
                    "there: nothing is left to fit",
                    hz,
                    share),
        "modes",
        "choose a frequency at which the fit leaves something");
  }
  if (const std::optional<double> beside = untold_from(curves, trial)) {
    throw InputError(
        fmt::format("the pole put in at {:.6g} Hz cannot be told from the mode "
                    "that is at {:.6g} Hz already",
                    hz,
                    *beside),
        "modes",
        "drop that one first, or choose another frequency");
  }
  fit = std::move(trial);
}

void edit_poles(const WeightedFrfs& curves,
                const std::vector<Track>& tracks,
                const std::vector<PoleEdit>& edits,
                ModalFit& fit) {
  for (const PoleEdit& edit : edits) {
    if (edit.what == PoleEdit::What::Drop) {
      drop_pole(curves, mode_to_drop(fit.poles.array().abs(), edit.hz), fit);
    } else {
      add_pole(curves, tracks, edit.hz, fit);
    }
  }
  if (fit.poles.size() > 0) fit = by_frequency(curves, fit);
}

}  // namespace tapfit::modal
