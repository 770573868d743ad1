#include "signal/frf_set/frf_set.hpp"

#include <numbers>

namespace tapfit::signal {

Eigen::VectorXd FrfSet::frequency_hz() const {
  return s.imag() / (2.0 * std::numbers::pi);
}

std::string name(const Frf& frf) {
  return tapfit::name(frf.response) + " / " + tapfit::name(frf.reference);
}

}  // namespace tapfit::signal
