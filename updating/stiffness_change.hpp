// A change of the stiffness matrix that an effect makes and that is too wide
// for a few degrees of freedom: a support that gives, a joint that gives,
// elements that have lost stiffness. It is told on the deck's own grids and
// elements; the base builds its matrix on the mesh that it solves.
#pragma once

#include "updating/diagnosis.hpp"

#include <Eigen/Core>

#include <cstddef>

namespace tapfit::updating {

enum class ChangeKind {
  Support,   ///< held degrees of freedom are released and held by springs
  Joint,     ///< elements beside a line turn against the rest, on springs
  Elements,  ///< the stiffness of elements times a factor
};

struct StiffnessChange {
  ChangeKind kind = ChangeKind::Elements;
  EffectRef of;       ///< whose it is
  int component = 3;  ///< 1..3, the direction measured
};

/// The change seen through a base: K(p) = K + (p - included) S; one term for
/// each parameter of the effect.
struct StiffnessTerm {
  EffectRef of;
  std::size_t parameter = 0;  ///< which of the effect's parameters p is
  Eigen::MatrixXd S;          ///< r x r, d K / d p
  double included = 0.0;      ///< value of p that the base's K holds
  double absent = 0.0;  ///< value of p where the effect is not in the model
  double lower = 0.0;   ///< range of p that the basis is good for
  double start = 0.0;   ///< lowers the most affected mode a few percent
  double upper = 0.0;
};

}  // namespace tapfit::updating
