#include "modal/select/unrefined_fit.hpp"

#include "modal/fit/fit_residual.hpp"
#include "modal/fit/modal_fit.hpp"
#include "modal/poles/pole_clusters.hpp"

#include <algorithm>
#include <complex>
#include <optional>

namespace tapfit::modal {

Eigen::MatrixXcd unrefined_fit(const WeightedFrfs& curves,
                               const std::vector<Track>& tracks,
                               const Eigen::VectorXcd& poles) {
  std::vector<std::size_t> taken;
  std::vector<std::complex<double>> found;
  for (const std::complex<double>& pole : poles) {
    const std::optional<std::size_t> track = nearest_track(tracks, pole);
    // No two poles may coincide.
    if (!track || std::ranges::find(taken, *track) != taken.end()) continue;
    taken.push_back(*track);
    found.push_back(tracks[*track].pole);
  }
  const auto count = static_cast<Eigen::Index>(found.size());
  return fitted_accelerance(
      curves,
      fit_residues(curves, Eigen::Map<Eigen::VectorXcd>(found.data(), count)));
}

}  // namespace tapfit::modal
