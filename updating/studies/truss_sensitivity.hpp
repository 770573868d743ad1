// Tables 1 and 2 of "Model Updating Using Frequency Response Functions Based
// on Sherman-Morrison Formula": the finite sensitivity of a truss's FRF to its
// moduli against the analytic one, in error (eq. 31) and in time.
//
// A rod enters with rank one, and the finite sensitivity is the analytic one
// over 1 + p z, with p the perturbation and z the rod's stiffness times its
// flexibility. In a statically determinate truss z is 1 for every rod at low
// frequency: one-sided, the error cannot be less than about p there.
#pragma once

#include "updating/studies/property_study.hpp"

#include <vector>

namespace tapfit::updating {

/// Mean over the uncertain moduli and the lines off the resonances.
struct SensitivityRow {
  double perturbation = 0.0;  ///< of E over E
  double one_sided = 0.0;     ///< eq. 16; 1 is 100 %
  double centred = 0.0;       ///< eq. 16 from -1/2 to +1/2 of it
};

/// For all lines and one modulus [s].
struct SensitivityTime {
  double analytic = 0.0;
  double finite = 0.0;
};

/// The whole model of a study at its nominal properties.
class TrussSensitivity {
 public:
  /// @param point of the FRF looked at
  /// @param s lines [rad/s], none of them at a resonance
  TrussSensitivity(const PropertyStudy& study,
                   const Dof& point,
                   const Eigen::VectorXcd& s);

  [[nodiscard]] SensitivityRow compare(double perturbation) const;
  [[nodiscard]] SensitivityTime time() const;

 private:
  [[nodiscard]] Eigen::VectorXcd analytic(const Eigen::MatrixXcd& dK) const;
  [[nodiscard]] Eigen::VectorXcd finite(const Eigen::MatrixXcd& dK,
                                        double from,
                                        double to) const;

  std::vector<Eigen::MatrixXcd> H_;   // per line
  std::vector<Eigen::MatrixXcd> dK_;  // d K / d f of each modulus
  Eigen::Index point_ = 0;
};

}  // namespace tapfit::updating
