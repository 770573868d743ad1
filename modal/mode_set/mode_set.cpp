#include "modal/mode_set/mode_set.hpp"

#include "acquisition/foundation/constants.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::modal {

void set_pole(Mode& mode, double frequency_hz, double damping_ratio) {
  const double omega = two_pi * frequency_hz;
  mode.frequency_hz = frequency_hz;
  mode.damping_ratio = damping_ratio;
  mode.pole = {
      -damping_ratio * omega,
      omega * std::sqrt(std::max(0.0, 1.0 - damping_ratio * damping_ratio))};
}

}  // namespace tapfit::modal
