#include "modal/poles/lines_in_band.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <vector>

namespace tapfit::modal {

using Eigen::Index;

signal::FrfSet lines_in_band(const signal::FrfSet& frfs,
                             const std::array<double, 2>& band_hz) {
  const Eigen::VectorXd f = frfs.frequency_hz();
  std::vector<Index> lines;
  for (Index k = 0; k < f.size(); ++k) {
    if (f(k) >= band_hz[0] && f(k) <= band_hz[1]) lines.push_back(k);
  }
  if (lines.size() < 8) {
    throw InputError(
        fmt::format("only {} frequency lines from {:.6g} to {:.6g} Hz",
                    lines.size(),
                    band_hz[0],
                    band_hz[1]),
        "band",
        f.size() > 0 ? fmt::format("the FRFs have {} lines from {:.6g} to "
                                   "{:.6g} Hz; 8 are needed",
                                   f.size(),
                                   f.minCoeff(),
                                   f.maxCoeff())
                     : std::string("there are no FRFs"));
  }
  signal::FrfSet part = frfs;
  part.s = frfs.s(lines);
  for (signal::Frf& frf : part.frfs) {
    if (frf.H.size() != f.size()) continue;
    frf.H = Eigen::VectorXcd(frf.H(lines));
    if (frf.coherence.size() == f.size()) {
      frf.coherence = Eigen::VectorXd(frf.coherence(lines));
    }
    if (frf.variance.size() == f.size()) {
      frf.variance = Eigen::VectorXd(frf.variance(lines));
    }
  }
  return part;
}

}  // namespace tapfit::modal
