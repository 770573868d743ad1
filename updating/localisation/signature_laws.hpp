// The laws of frequency that a missing dynamic stiffness is compared with: a
// mass, a spring, a dashpot, an absorber.
#pragma once

#include "updating/localisation/signature.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::updating {

struct SignatureLaw {
  std::string effect;        ///< "mass", "spring", "dashpot", "absorber"
  std::string parameter;     ///< result field, ends in its unit
  double size = 0.0;         ///< of the parameter
  double unexplained = 1.0;  ///< share of the missing stiffness that it leaves
  Eigen::VectorXcd z;        ///< [N/m], on the signature's lines

  /// What of z says most: a dashpot's imaginary part, the others' real one.
  [[nodiscard]] Eigen::VectorXd shown() const;
  [[nodiscard]] bool is_imaginary() const { return effect == "dashpot"; }
};

/// Mass: z = s^2 m; spring: z = k; dashpot: z = s c; where one resonates on the
/// lines, an absorber: absorber_stiffness().
[[nodiscard]] std::vector<SignatureLaw> signature_laws(
    const Signature& signature);

/// The one that leaves least. An absorber has three parameters: it is taken
/// only, and then always, where one is suspected.
/// @param resonant an absorber is suspected
[[nodiscard]] SignatureLaw best_law(const Signature& signature, bool resonant);

}  // namespace tapfit::updating
