#include "modal/checks/frfs_by_run.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::modal {

using Eigen::Index;
using Eigen::VectorXcd;
using signal::FrfSet;

FrfsByRun frfs_by_run(const FrfSet& set) {
  FrfsByRun runs;
  for (std::size_t f = 0; f < set.frfs.size(); ++f) {
    runs[set.frfs[f].run].push_back(f);
  }
  return runs;
}

FrfSet part_of(const FrfSet& set, const std::vector<std::size_t>& frfs) {
  FrfSet part;
  part.s = set.s;
  for (const std::size_t f : frfs) part.frfs.push_back(set.frfs[f]);
  return part;
}

bool is_clear(const ModalConstants& of, Index pole) {
  constexpr double deviations = 10.0;
  return std::abs(of.z(pole)) > deviations * of.sd(pole);
}

VectorXcd shown_by_others(const FrfsByRun& runs,
                          std::size_t run,
                          const std::vector<ModalConstants>& all,
                          const VectorXcd& poles,
                          double share) {
  const double least =
      std::max(2.0, share * static_cast<double>(runs.size() - 1));
  std::vector<std::complex<double>> kept;
  for (Index k = 0; k < poles.size(); ++k) {
    int showing = 0;
    for (const auto& [other, frfs] : runs) {
      if (other == run) continue;
      showing += std::ranges::any_of(
          frfs, [&](std::size_t f) { return is_clear(all[f], k); });
    }
    if (showing >= least) kept.push_back(poles(k));
  }
  return VectorXcd::Map(kept.data(), static_cast<Index>(kept.size()));
}

double left_by(const VectorXcd& poles, const FrfSet& of) {
  double sum = 0.0;
  for (const ModalConstants& one : modal_constants(of, poles, false)) {
    sum += one.left * one.left;
  }
  return std::sqrt(sum / static_cast<double>(of.frfs.size()));
}

}  // namespace tapfit::modal
