#include "modal/mass_loading/set_up_fit.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "modal/fit/fit_residual.hpp"
#include "modal/fit/pole_covariance.hpp"
#include "modal/fit/shape_uncertainty.hpp"
#include "modal/poles/frf_matrix.hpp"
#include "modal/poles/plscf.hpp"
#include "modal/select/select_from_orders.hpp"

#include <map>
#include <mutex>
#include <string_view>
#include <utility>

namespace tapfit::modal {
namespace {

using Eigen::Index;

SetUpFit fit_set_up(const WeightedFrfs& curves,
                    std::size_t set_up,
                    const std::vector<Index>& frfs,
                    const IdentifyOptions& options,
                    const Progress& progress) {
  SetUpFit result;
  result.set_up = set_up;
  result.frfs = frfs;
  result.curves = select_frfs(curves, frfs);
  const WeightedFrfs& part = result.curves;
  const FrfMatrix matrix = arrange_frfs(part);
  const std::vector<OrderPoles> orders =
      plscf_poles(part, matrix, options.max_order, progress);
  result.tracks =
      stabilise(
          orders, part.s(0).imag(), part.s(part.lines() - 1).imag(), options)
          .tracks;
  result.fit =
      select_from_orders(part, matrix, orders, result.tracks, options, progress)
          .fit;
  return result;
}

}  // namespace

std::vector<SetUpFit> fit_set_ups(const WeightedFrfs& curves,
                                  const IdentifyOptions& options,
                                  const Progress& progress) {
  std::map<std::size_t, std::vector<Index>> frfs;
  for (std::size_t f = 0; f < curves.set_up.size(); ++f) {
    frfs[curves.set_up[f]].push_back(static_cast<Index>(f));
  }
  const std::vector<std::pair<std::size_t, std::vector<Index>>> set_ups(
      frfs.begin(), frfs.end());
  std::vector<SetUpFit> fits(set_ups.size());
  // The stages of set-ups that are at work together are told as set-ups done.
  std::mutex reporting;
  std::size_t done = 0;
  const Progress together{[&](std::string_view, double) {
                            const std::lock_guard lock(reporting);
                            progress("set-ups",
                                     static_cast<double>(done) /
                                         static_cast<double>(set_ups.size()));
                          },
                          progress.stop};
  for_each_parallel(set_ups.size(), [&](std::size_t k) {
    const auto& [set_up, own] = set_ups[k];
    fits[k] = fit_set_up(curves, set_up, own, options, together);
    const std::lock_guard lock(reporting);
    ++done;
  });
  return fits;
}

void estimate_uncertainty(SetUpFit& fit) {
  const Noise noise = weighted_noise(fit.curves, fit.fit, NoiseFrom::AllLines);
  fit.residue_variance = residue_variance(fit.curves, fit.fit, noise);
  fit.pole_covariance = pole_covariance(fit.curves, fit.fit, noise);
}

}  // namespace tapfit::modal
