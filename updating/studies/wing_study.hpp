// A solar wing after "Model Updating Using Frequency Response Functions Based
// on Sherman-Morrison Formula", section 4.2: modulus, density and area of the
// beams and the modulus of the plates are off by 15 to 30 %, FRFs of two grids
// carry 5 % noise, damping is Rayleigh's with a = 0.2, b = 0.0005.
//
// The paper gives no dimensions; those of the bundle come near its Table 5.
// The beams' density and area move bending FRFs only as their product, the
// mass per metre. Area alone shows where beams are stretched, so the FRFs are
// taken in all three directions.
#pragma once

#include "updating/fit/plain_updater.hpp"
#include "updating/studies/property_study.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tapfit::updating {

struct WingResult {
  std::vector<double> factor;  ///< identified over nominal
  PlainResult last;            ///< of the last round
  Eigen::MatrixXd history;     ///< of all rounds, property over nominal
};

class WingStudy {
 public:
  /// @param folder of the bundle recordings/paper-solar-wing
  explicit WingStudy(const std::filesystem::path& folder);

  /// E of the beams, E of the plates, rho and A of the beams.
  [[nodiscard]] static std::vector<double> truth() {
    return {1.3, 1.2, 1.15, 1.2};
  }
  [[nodiscard]] const PropertyStudy& study() const { return study_; }

  /// What the bundle's measured.uff holds: seed 1.
  [[nodiscard]] signal::FrfSet measured(std::uint64_t seed) const;

  /// The plain step of eq. 27 with lambda from the L-curve and lines by the
  /// rule of 2.3, in rounds: the reduced base is solved anew at what the last
  /// round found, because it is exact only near there.
  [[nodiscard]] WingResult identify(std::uint64_t seed) const;

 private:
  PropertyStudy study_;
  signal::FrfSet exact_;
};

}  // namespace tapfit::updating
