#include "modal/select/needed_modes.hpp"

#include "acquisition/samples/statistics.hpp"
#include "modal/poles/frf_matrix.hpp"
#include "modal/select/out_of_band_modes.hpp"
#include "modal/select/pole_validation.hpp"
#include "modal/select/split_poles.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double least_significance_of_mode =
    4.0;  // F that a mode's residues must earn
constexpr double least_contribution = 0.02;  // of |H| at the mode's frequency
// A weaker mode counts where it is surely there.
constexpr double faintest_contribution = 0.0003;  // 70 dB below the others

}  // namespace

Index weakest_mode(const WeightedFrfs& curves,
                   const ModalFit& fit,
                   const IdentifyOptions& options) {
  const FrfMatrix matrix = arrange_frfs(curves);
  Index worst = -1;
  double least = 1.0;
  for (Index r = 0; r < fit.poles.size(); ++r) {
    if (far_outside(curves, fit.poles(r))) continue;
    const double faint = std::min(fit.significance(r) / surely_there,
                                  fit.contribution(r) / faintest_contribution);
    double worth =
        std::min(fit.significance(r) / least_significance_of_mode,
                 std::max(fit.contribution(r) / least_contribution, faint));
    if (is_impossible(fit.poles(r), options)) worth = 0.0;
    if (is_split(matrix, fit, r)) worth = std::min(worth, 0.5);
    if (worth >= least) continue;
    least = worth;
    worst = r;
  }
  return worst;
}

double usual_damping(const WeightedFrfs& curves, const ModalFit& fit) {
  std::vector<double> ratios;
  for (const Complex& pole : fit.poles) {
    if (!in_band(curves, pole)) continue;
    ratios.push_back(-pole.real() / std::abs(pole));
  }
  return ratios.empty() ? 0.005 : acquisition::median(ratios);
}

bool are_needed(const WeightedFrfs& curves,
                const ModalFit& fit,
                const IdentifyOptions& options) {
  return weakest_mode(curves, fit, options) < 0;
}

}  // namespace tapfit::modal
