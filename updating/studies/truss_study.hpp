// The plane truss of "Model Updating Using Frequency Response Functions Based
// on Sherman-Morrison Formula", section 4.1: five moduli are off by 10 and
// 20 %, receptances of two grids carry 5 % noise.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/plain_updater.hpp"
#include "updating/studies/property_study.hpp"
#include "updating/studies/truss_sensitivity.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::updating {

inline constexpr double paper_noise = 0.05;

/// Figure 8: one choice of lines, identified by the plain step (eq. 27) and on
/// damped lines of the same frequencies.
struct LineCase {
  std::string lines;
  PlainResult plain;
  double plain_error = 0.0;  ///< largest of a modulus, 1 is 100 %
  bool damped_converged = false;
  double damped_error = 0.0;
};

/// Of how many noise seeds all moduli came out within `within`.
struct SeedCount {
  double within = 0.0085;  ///< the paper's largest error
  int seeds = 0;
  int plain = 0;
  int damped = 0;
  double plain_worst = 0.0;
  double damped_worst = 0.0;
};

class TrussStudy {
 public:
  /// @param folder of the bundle recordings/paper-truss
  explicit TrussStudy(const std::filesystem::path& folder);

  [[nodiscard]] static std::vector<double> truth() {
    return {1.1, 1.2, 1.2, 1.2, 1.1};
  }
  [[nodiscard]] const PropertyStudy& study() const { return study_; }

  /// What the bundle's measured.uff holds: seed 1.
  [[nodiscard]] signal::FrfSet measured(std::uint64_t seed) const;

  /// Tables 1 and 2, at grid 10.
  [[nodiscard]] TrussSensitivity sensitivity() const;
  /// Table 4 and Figure 5: eq. 27 by scatter, lines by the rule of 2.3.
  [[nodiscard]] PlainResult plain(std::uint64_t seed) const;
  [[nodiscard]] std::array<LineCase, 3> cases(std::uint64_t seed) const;
  [[nodiscard]] SeedCount count_seeds(int seeds,
                                      const Progress& progress) const;

 private:
  PropertyStudy study_;
  FrfModel model_;
  Eigen::VectorXd true_hz_;
  Eigen::VectorXd nominal_hz_;
  signal::FrfSet exact_;
  std::array<signal::FrfSet, 2> exact_damped_;  // wide, then narrow
};

/// Largest |identified / true - 1|.
[[nodiscard]] double largest_error(const std::vector<double>& identified,
                                   const std::vector<double>& truth);

}  // namespace tapfit::updating
