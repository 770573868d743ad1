#include "acquisition/foundation/constants.hpp"
#include "updating/reduction/subspace.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/virtual_test/virtual_structure.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using structure::SparseMatrix;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Of what stands for all higher modes: their answer in the band is static.
constexpr double residual_damping = 0.05;

bool on_sensor(const VirtualEffect& effect, const std::string& channel) {
  return effect.places.empty() ||
         std::find(effect.places.begin(), effect.places.end(), channel) !=
             effect.places.end();
}

SparseMatrix sum(const SparseMatrix& A, const Triplets& parts) {
  SparseMatrix change(A.rows(), A.cols());
  change.setFromTriplets(parts.begin(), parts.end());
  return A + change;
}

/// Of the sensors' masses that of one of them: their own, or one for all.
///
/// @param position of the sensor in its run
double mass_of(const VirtualEffect& effect,
               const std::string& channel,
               std::size_t position) {
  if (effect.values.size() < 2) return effect.values[0];
  const auto own = std::ranges::find(effect.places, channel);
  return effect.values.at(
      effect.places.empty()
          ? position
          : static_cast<std::size_t>(own - effect.places.begin()));
}

/// The structure with one run's sensors on it.
struct Loaded {
  SparseMatrix K;
  SparseMatrix M;
  std::vector<structure::Dashpot> dashpots;
};

Loaded put_on(const VirtualStructure& structure,
              const std::vector<VirtualSensor>& sensors) {
  Triplets stiffness;
  Triplets mass;
  Loaded loaded{{}, {}, structure.dashpots};
  for (std::size_t k = 0; k < sensors.size(); ++k) {
    const VirtualSensor& sensor = sensors[k];
    const int at = structure.dof_index(sensor.dof);
    for (const VirtualEffect& effect : structure.effects) {
      if (!on_sensor(effect, sensor.channel)) continue;
      if (effect.name == "sensor-cable") {
        stiffness.emplace_back(at, at, effect.values[0]);
        loaded.dashpots.push_back({effect.values[1], {{at, 1.0}}});
      }
      if (effect.name != "sensor-mass") continue;
      const int first = at - (sensor.dof.component - 1);
      const double own = mass_of(effect, sensor.channel, k);
      for (int c = 0; c < 3; ++c) {
        mass.emplace_back(first + c, first + c, own);
      }
    }
  }
  loaded.K = sum(structure.K, stiffness);
  loaded.M = sum(structure.M, mass);
  return loaded;
}

/// Unit displacements b of the points, with the sign of each direction, as
/// forces on what is free to move: T' b, free x points; zero where the
/// structure is held.
Eigen::MatrixXd unit_forces(const std::vector<Dof>& points,
                            const VirtualStructure& structure) {
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(
      structure.motions.dofs, static_cast<Eigen::Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    b(structure.dof_index(points[k]), static_cast<Eigen::Index>(k)) =
        points[k].sign;
  }
  return structure.motions.project(b);
}

/// The same for the directions of dashpots.
Eigen::MatrixXd unit_forces(const std::vector<structure::Dashpot>& dashpots,
                            const structure::FreeMotions& motions) {
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(
      motions.dofs, static_cast<Eigen::Index>(dashpots.size()));
  for (std::size_t k = 0; k < dashpots.size(); ++k) {
    for (const auto& [dof, part] : dashpots[k].direction) {
      b(dof, static_cast<Eigen::Index>(k)) = part;
    }
  }
  return motions.project(b);
}

/// Of the spring that hardens; no column where there is none.
Eigen::MatrixXd unit_force(const std::optional<HardeningSpring>& spring,
                           const structure::FreeMotions& motions) {
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(motions.dofs, spring ? 1 : 0);
  if (spring) b(spring->dof, 0) = 1.0;
  return motions.project(b);
}

/// Columns that are not zero.
Eigen::MatrixXd acting(const Eigen::MatrixXd& forces) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < forces.cols(); ++k) {
    if (!forces.col(k).isZero(0.0)) kept.push_back(k);
  }
  return forces(Eigen::all, kept);
}

/// What of the columns lies outside the span of phi, normalised; what the modes
/// span but for rounding is left out.
Eigen::MatrixXd beyond_modes(const SparseMatrix& M,
                             const Eigen::MatrixXd& phi,
                             Eigen::MatrixXd R) {
  constexpr double rounding = 1e-7;
  const auto sizes = [&] {
    return Eigen::VectorXd(
        R.cwiseProduct(M * R).colwise().sum().cwiseMax(0.0).cwiseSqrt());
  };
  const Eigen::VectorXd whole = sizes();
  R -= phi * (phi.transpose() * (M * R));
  Eigen::VectorXd left = sizes();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < R.cols(); ++k) {
    if (left(k) > rounding * whole(k)) kept.push_back(k);
  }
  R = Eigen::MatrixXd(R(Eigen::all, kept));
  left = Eigen::VectorXd(left(kept));
  R *= left.cwiseInverse().asDiagonal();
  R -= phi * (phi.transpose() * (M * R));
  return R * sizes().cwiseInverse().asDiagonal();
}

/// Static answers to unit forces, M-orthogonal to the modes and to each other,
/// diagonal in K. None where the modes are all that the structure has.
structure::Eigenmodes residual_modes(const SparseMatrix& K,
                                     const SparseMatrix& M,
                                     const Eigen::MatrixXd& phi,
                                     const Eigen::MatrixXd& forces) {
  const Eigen::MatrixXd R =
      beyond_modes(M, phi, structure::Factor(K).solve(forces));
  if (R.cols() == 0) return {Eigen::VectorXd(0), R};
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(R.transpose() *
                                                            (M * R));
  const Eigen::VectorXd& size = gram.eigenvalues();
  const Eigen::Index kept = (size.array() > 1e-8).count();
  const Eigen::MatrixXd basis =
      R * gram.eigenvectors().rightCols(kept) *
      size.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(basis.transpose() *
                                                            (K * basis));
  return {ritz.eigenvalues().cwiseSqrt() / two_pi, basis * ritz.eigenvectors()};
}

Eigen::VectorXd modal_damping(const Eigen::VectorXd& frequency_hz,
                              Eigen::Index elastic_end,
                              double suspension_hz,
                              const VirtualDamping& damping) {
  acquisition::SeededRandom random(damping.seed, "modal damping");
  Eigen::VectorXd zeta(frequency_hz.size());
  for (Eigen::Index k = 0; k < zeta.size(); ++k) {
    const double elastic = damping.mean * random.scatter(damping.scatter);
    const bool rigid = frequency_hz(k) < 2.0 * suspension_hz;
    zeta(k) = k >= elastic_end ? residual_damping
              : rigid          ? damping.suspension
                               : elastic;
  }
  return zeta;
}

Eigen::MatrixXd damping_matrix(
    const Eigen::VectorXd& frequency_hz,
    const Eigen::VectorXd& zeta,
    const Eigen::MatrixXd& shapes,
    const std::vector<structure::Dashpot>& dashpots) {
  Eigen::MatrixXd C =
      (2.0 * two_pi * zeta.cwiseProduct(frequency_hz)).asDiagonal();
  for (std::size_t k = 0; k < dashpots.size(); ++k) {
    const Eigen::RowVectorXd shape = shapes.row(static_cast<Eigen::Index>(k));
    C += dashpots[k].damping * shape.transpose() * shape;
  }
  return C;
}

/// The generalised coordinates: modes, then what stands for all others.
struct Coordinates {
  Eigen::MatrixXd phi;
  Eigen::VectorXd frequency_hz;
  Eigen::Index elastic = 0;  ///< number of true modes
};

Coordinates coordinates(const SparseMatrix& K,
                        const SparseMatrix& M,
                        const Eigen::MatrixXd& forces,
                        double max_hz) {
  const structure::Eigenmodes modes = structure::eigenmodes_up_to(K, M, max_hz);
  const structure::Eigenmodes rest =
      residual_modes(K, M, modes.phi, acting(forces));
  Coordinates q;
  q.elastic = modes.phi.cols();
  q.phi.resize(K.rows(), q.elastic + rest.phi.cols());
  q.phi << modes.phi, rest.phi;
  q.frequency_hz.resize(q.phi.cols());
  q.frequency_hz << modes.frequency_hz, rest.frequency_hz;
  return q;
}

}  // namespace

ReducedTruth reduce_truth(const VirtualStructure& structure,
                          const std::vector<VirtualSensor>& sensors,
                          const std::vector<Dof>& hammers,
                          double max_hz,
                          const VirtualDamping& damping) {
  const Loaded loaded = put_on(structure, sensors);
  std::vector<Dof> felt;
  for (const VirtualSensor& sensor : sensors) felt.push_back(sensor.dof);
  const Eigen::MatrixXd hit = unit_forces(hammers, structure);
  const Eigen::MatrixXd seen = unit_forces(felt, structure);
  const Eigen::MatrixXd damped =
      unit_forces(loaded.dashpots, structure.motions);
  const Eigen::MatrixXd pulled =
      unit_force(structure.hardening, structure.motions);
  const Coordinates q = coordinates(structure.motions.reduce(loaded.K),
                                    structure.motions.reduce(loaded.M),
                                    join({hit, seen, damped, pulled}),
                                    max_hz);
  const Eigen::VectorXd zeta = modal_damping(
      q.frequency_hz, q.elastic, structure.suspension_hz, damping);

  ReducedTruth truth;
  const Eigen::Index r = q.phi.cols();
  truth.system.M = Eigen::MatrixXd::Identity(r, r);
  truth.system.K = (two_pi * q.frequency_hz).cwiseAbs2().asDiagonal();
  truth.system.C = damping_matrix(
      q.frequency_hz, zeta, damped.transpose() * q.phi, loaded.dashpots);
  truth.hammers = q.phi.transpose() * hit;
  truth.system.input = truth.hammers.col(0);
  truth.system.output = seen.transpose() * q.phi;
  if (structure.hardening) {
    truth.system.hardening = acquisition::CubicSpring{
        q.phi.transpose() * pulled, structure.hardening->stiffness};
  }
  const acquisition::DampedPoles poles =
      acquisition::damped_poles(truth.system.M, truth.system.C, truth.system.K);
  const Eigen::Index shown = (poles.frequency_hz.array() <= max_hz).count();
  truth.frequency_hz = poles.frequency_hz.head(shown);
  truth.damping_ratio = poles.damping_ratio.head(shown);
  return truth;
}

}  // namespace tapfit::updating
