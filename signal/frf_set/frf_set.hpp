// The room signal/frf_set. FRFs as everything further on takes them.
// Out: FrfSet: accelerances on lines of the s-plane with variance and
//      coherence; which of them belong to one set-up.
// May include: its row in CONTRIBUTING.md.
//
// A set of measured frequency response functions on lines of the s-plane.
#pragma once

#include "acquisition/foundation/dof.hpp"
#include "acquisition/foundation/finding.hpp"
#include "signal/frf_set/linearity_finding.hpp"

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

namespace tapfit::signal {

/// One accelerance H1 = response acceleration / reference force.
struct Frf {
  Dof response;
  Dof reference;
  std::size_t run = 0;        ///< first of its placement in TestBundle::runs
  std::size_t channel = 0;    ///< response channel, index into channels
  Eigen::VectorXcd H;         ///< accelerance per line [(m/s^2)/N]
  Eigen::VectorXd coherence;  ///< 0..1 per line; ones for a single hit
  Eigen::VectorXd variance;   ///< of H: E|dH|^2 per line [((m/s^2)/N)^2]
  /// Degrees of freedom of that estimate, see confidence_band.hpp.
  double variance_freedom = std::numeric_limits<double>::infinity();
  int hits = 0;  ///< accepted hits behind it
  /// Of H from the weakest hit to the strongest, per line; empty where the
  /// hits' forces do not tell.
  Eigen::VectorXcd change_with_level = {};
};

/// FRFs that share their lines s = sigma + j omega. An exponential window
/// exp(-sigma t) on force and response makes the estimate the transfer
/// function at s exactly, so sigma is kept here and not corrected for later.
struct FrfSet {
  Eigen::VectorXcd s;  ///< complex angular frequency of each line [rad/s]
  std::vector<Frf> frfs;
  std::vector<std::string> statements;  ///< runs left out, poor FRFs
  LinearityFinding level = {};          ///< whether they follow the hits' force
  std::vector<Finding> findings = {};   ///< runs that disagree

  [[nodiscard]] Eigen::Index lines() const { return s.size(); }
  [[nodiscard]] Eigen::VectorXd frequency_hz() const;
};

/// "12Z+ / 3Z+": response over reference.
[[nodiscard]] std::string name(const Frf& frf);

}  // namespace tapfit::signal
