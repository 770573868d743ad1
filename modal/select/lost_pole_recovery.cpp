#include "modal/select/lost_pole_recovery.hpp"

#include "modal/select/needed_modes.hpp"
#include "modal/select/out_of_band_modes.hpp"

#include <algorithm>
#include <complex>
#include <utility>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// How far a pole moves that is only refined [rad/s].
double reach(const WeightedFrfs& curves, const Complex& pole) {
  return std::max(-pole.real(), curves.spacing);
}

/// Whether one of the fit's poles is lasting pole r and no other.
bool is_there(const WeightedFrfs& curves,
              const Eigen::VectorXcd& lasting,
              Index r,
              const ModalFit& fit) {
  return std::ranges::any_of(fit.poles, [&](const Complex& pole) {
    Index nearest = 0;
    const double apart = (lasting.array() - pole).abs().minCoeff(&nearest);
    return nearest == r && apart < reach(curves, lasting(r));
  });
}

}  // namespace

ModalFit recover_lost_poles(const WeightedFrfs& curves,
                            const Eigen::VectorXcd& lasting,
                            ModalFit fit,
                            const IdentifyOptions& options) {
  for (Index r = 0; r < lasting.size(); ++r) {
    const Complex pole = lasting(r);
    if (!in_band(curves, pole) || is_there(curves, lasting, r, fit)) continue;
    Eigen::VectorXcd poles(fit.poles.size() + 1);
    poles << fit.poles, pole;
    ModalFit trial = refine_poles(curves, poles, 15);
    const Complex back = trial.poles(trial.poles.size() - 1);
    const bool stayed = std::abs(back - pole) < reach(curves, pole);
    if (stayed && are_needed(curves, trial, options)) fit = std::move(trial);
  }
  return fit;
}

}  // namespace tapfit::modal
