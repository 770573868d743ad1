// Which poles return from one model order to the next.
//
// A pole of the structure appears at every order that is high enough; a pole of
// the noise does not. Poles are linked over the orders into tracks, each track
// with at most one pole per order, so that two close modes make two tracks.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "modal/poles/identify_options.hpp"
#include "modal/poles/plscf.hpp"

#include <complex>
#include <vector>

namespace tapfit::modal {

/// One pole followed over the model orders.
struct Track {
  std::vector<int> orders;
  std::vector<std::complex<double>> poles;  ///< [rad/s], one per order
  Eigen::VectorXcd participation;           ///< of the last pole
  std::complex<double> pole;                ///< the one nearest to all others
  int stable = 0;      ///< poles that agree with the order before
  double share = 0.0;  ///< of the orders since the first that have the pole
};

struct Stabilisation {
  std::vector<DiagramPole> diagram;  ///< poles in the band, damped
  std::vector<Track> tracks;         ///< by frequency; a little wider than band
};

/// Links poles over orders and marks each with its letter.
///
/// @param low, high the band [rad/s]; tracks within 5 % of its width beyond
///   the ends are kept too, because their modes disturb those inside
[[nodiscard]] Stabilisation stabilise(const std::vector<OrderPoles>& orders,
                                      double low,
                                      double high,
                                      const IdentifyOptions& options);

}  // namespace tapfit::modal
