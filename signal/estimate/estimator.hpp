// FRF and coherence from the spectra of several hits.
//
//   Gff = sum |F|^2,  Gyy = sum |Y|^2,  Gyf = sum Y conj(F)
//   H1 = Gyf / Gff,  H2 = Gyy / conj(Gyf),
//   Hv = sqrt(Gyy / Gff) exp(j arg Gyf),  coherence = |Gyf|^2 / (Gff Gyy)
//
// Source: J. S. Bendat, A. G. Piersol, "Random Data", 4th ed., Wiley 2010,
// ch. 6; Hv as the geometric mean of H1 and H2.
#pragma once


#include <Eigen/Core>

namespace tapfit::signal {

enum class Estimator { H1, H2, Hv };

struct Estimate {
  Eigen::VectorXcd H;         ///< per line, response / force
  Eigen::VectorXd coherence;  ///< per line, 0..1; ones for a single hit
};

/// Sums over hits, per line: all that the estimators need, however many hits
/// there were.
struct CrossPowers {
  Eigen::Index hits = 0;
  Eigen::VectorXd Gff;   ///< sum |F|^2
  Eigen::VectorXd Gyy;   ///< sum |Y|^2
  Eigen::VectorXcd Gyf;  ///< sum Y conj(F)

  /// Adds the sums of other hits on the same lines; to no hits at all, too.
  CrossPowers& operator+=(const CrossPowers& other);
};

/// @param force, response lines x hits
[[nodiscard]] CrossPowers cross_powers(const Eigen::MatrixXcd& force,
                                       const Eigen::MatrixXcd& response);

[[nodiscard]] Estimate estimate(const CrossPowers& powers, Estimator estimator);

}  // namespace tapfit::signal
