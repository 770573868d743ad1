// Whether each channel that a run uses ever changes, seen piece by piece. One
// that does not is a cable that is off: the converter delivers one value, and
// an FRF of nothing would count as a measurement of nothing.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::acquisition {

class DeadChannels {
 public:
  /// @param bundle, run must outlive it
  DeadChannels(const TestBundle& bundle, const Run& run);

  /// @param samples the next ones [SI], columns as the bundle's channels
  void look_at(const Eigen::Ref<const Eigen::MatrixXd>& samples);

  /// To be asked when all samples have been seen.
  ///
  /// @throws InputError where a channel has had but one value
  void refuse() const;

 private:
  struct Unchanged {
    std::size_t channel = 0;
    double value = 0.0;  ///< [SI]
  };

  const TestBundle& bundle_;
  const Run& run_;
  std::vector<Unchanged> unchanged_;  ///< the hammer first, then the sensors
  Eigen::Index count_ = 0;            ///< of samples seen
};

}  // namespace tapfit::acquisition
