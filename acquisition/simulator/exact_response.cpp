#include "acquisition/simulator/exact_response.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace tapfit::acquisition {
namespace {

using Complex = std::complex<double>;

/// x' = A x, with the velocities scaled so that A is well balanced.
struct StateMatrix {
  double scale = 1.0;            ///< w0 in x = [w0 q; q']
  Eigen::MatrixXd A;             ///< 2r x 2r
  Eigen::MatrixXd acceleration;  ///< r x 2r, q'' without force
  Eigen::LLT<Eigen::MatrixXd> mass;
};

StateMatrix state_matrix(const Eigen::MatrixXd& M,
                         const Eigen::MatrixXd& C,
                         const Eigen::MatrixXd& K) {
  const Eigen::Index r = M.rows();
  StateMatrix state;
  state.mass.compute(M);
  const Eigen::MatrixXd stiffness = state.mass.solve(K);
  const double largest = stiffness.cwiseAbs().maxCoeff();
  const double w0 = largest > 0.0 ? std::sqrt(largest) : 1.0;
  state.scale = w0;
  state.acceleration.resize(r, 2 * r);
  state.acceleration.leftCols(r) = -stiffness / w0;
  state.acceleration.rightCols(r) = -state.mass.solve(C);
  state.A = Eigen::MatrixXd::Zero(2 * r, 2 * r);
  state.A.topRightCorner(r, r).diagonal().setConstant(w0);
  state.A.bottomRows(r) = state.acceleration;
  return state;
}

// Series where the closed forms cancel; 6 terms leave 1e-17 at |x| = 1e-2.
Complex phi1(Complex x) {
  if (std::abs(x) > 1e-2) return (std::exp(x) - 1.0) / x;
  return 1.0 +
         x / 2.0 *
             (1.0 +
              x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0 * (1.0 + x / 6.0))));
}

Complex phi2(Complex x) {
  if (std::abs(x) > 1e-2) return (std::exp(x) - 1.0 - x) / (x * x);
  return 0.5 *
         (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0 * (1.0 + x / 6.0))));
}

/// One half of the complex modes; the other half is conjugate.
struct ComplexModes {
  Eigen::ArrayXcd lambda;
  Eigen::ArrayXXcd input;       ///< V^-1 B, modes x forces
  Eigen::MatrixXcd output;      ///< n x modes; conjugate pairs counted twice
  Eigen::RowVectorXcd stretch;  ///< of the cubic spring, likewise
};

/// The hammer's force, and the cubic spring's where there is one.
Eigen::MatrixXd forces_of(const SecondOrderSystem& system) {
  Eigen::MatrixXd b(system.M.rows(), system.hardening ? 2 : 1);
  b.col(0) = system.input;
  if (system.hardening) b.col(1) = system.hardening->place;
  return b;
}

std::optional<ComplexModes> complex_modes(const SecondOrderSystem& system,
                                          const StateMatrix& state) {
  const Eigen::Index r = system.M.rows();
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(state.A);
  if (solver.info() != Eigen::Success) return std::nullopt;
  const Eigen::MatrixXcd V = solver.eigenvectors();
  const Eigen::PartialPivLU<Eigen::MatrixXcd> inverse(V);
  if (!(inverse.rcond() > 1e-7)) return std::nullopt;
  const Eigen::MatrixXd forces = forces_of(system);
  Eigen::MatrixXcd B = Eigen::MatrixXcd::Zero(2 * r, forces.cols());
  B.bottomRows(r) = state.mass.solve(forces).cast<Complex>();
  const Eigen::MatrixXcd g = inverse.solve(B);
  const Eigen::MatrixXcd L =
      (system.output * state.acceleration).cast<Complex>() * V;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < 2 * r; ++k) {
    if (solver.eigenvalues()(k).imag() >= 0.0) kept.push_back(k);
  }
  ComplexModes modes;
  modes.lambda = solver.eigenvalues()(kept).array();
  modes.input = g(kept, Eigen::all).array();
  modes.output = L(Eigen::all, kept);
  modes.stretch = Eigen::RowVectorXcd::Zero(modes.lambda.size());
  if (system.hardening) {
    const Eigen::RowVectorXd place =
        system.hardening->place.transpose() / state.scale;
    modes.stretch = (place.cast<Complex>() * V.topRows(r))(kept);
  }
  for (Eigen::Index k = 0; k < modes.lambda.size(); ++k) {
    if (modes.lambda(k).imag() <= 0.0) continue;
    modes.output.col(k) *= 2.0;
    modes.stretch(k) *= 2.0;
  }
  return modes;
}

ComplexModes chosen(const ComplexModes& all,
                    const std::vector<Eigen::Index>& which) {
  return {all.lambda(which),
          all.input(which, Eigen::all),
          all.output(Eigen::all, which),
          all.stretch(which)};
}

/// Modes that are stepped through time, and those too stiff for it.
class Motion {
 public:
  Motion(ComplexModes moving, ComplexModes stiff, double h)
      : moving_(std::move(moving)), stiff_(std::move(stiff)) {
    const Eigen::ArrayXcd x = moving_.lambda * h;
    decay_ = x.exp();
    next_ = moving_.input.colwise() * (h * x.unaryExpr(&phi2));
    now_ = moving_.input.colwise() * (h * x.unaryExpr(&phi1)) - next_;
  }

  /// Adds the answer of the moving modes to the hammer, and what follows it at
  /// once.
  void run(const Eigen::VectorXd& force, ExactResponse& result) const {
    Eigen::ArrayXcd z = Eigen::ArrayXcd::Zero(decay_.size());
    for (Eigen::Index n = 0; n < force.size(); ++n) {
      if (n > 0) step(force, n, z);
      feel(z, force(n), n, result);
    }
  }

  /// The same with a cubic spring, the second force.
  /// @return the spring's force on the structure
  Eigen::VectorXd run_pulled(const Eigen::VectorXd& force,
                             double cubic,
                             ExactResponse& result) const {
    const double by_force = stretch_of_stiff(0);
    const double by_pull =
        stretch_of_stiff(1) + stretch_of(Eigen::ArrayXcd(next_.col(1)));
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(force.size());
    Eigen::ArrayXcd z = Eigen::ArrayXcd::Zero(decay_.size());
    for (Eigen::Index n = 0; n < force.size(); ++n) {
      if (n > 0) {
        step(force, n, z);
        z += now_.col(1) * pull(n - 1);
        const double x = stretch_of(z) + by_force * force(n);
        pull(n) = -cubic * std::pow(pulled_back(x, by_pull * cubic), 3);
        z += next_.col(1) * pull(n);
      }
      feel(z, force(n), n, result);
    }
    return pull;
  }

  // l g / (s - lambda) = -l g (1 / lambda + s / lambda^2 + s^2 / lambda^3 ...):
  // the first term takes the stiff modes' share off what follows the force at
  // once, the others act on its slope and curvature.
  Eigen::MatrixXd still(Eigen::Index which,
                        const Eigen::VectorXd& force,
                        double rate_hz,
                        Eigen::VectorXd& direct) const {
    const auto order = [&](int power) -> Eigen::VectorXd {
      const Eigen::ArrayXcd share =
          stiff_.input.col(which) / stiff_.lambda.pow(power);
      return -(stiff_.output * share.matrix()).real();
    };
    direct += order(1);
    const Eigen::Index n = force.size();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, direct.size());
    const Eigen::RowVectorXd slope = 0.5 * rate_hz * order(2).transpose();
    const Eigen::RowVectorXd curve = rate_hz * rate_hz * order(3).transpose();
    for (Eigen::Index k = 1; k + 1 < n; ++k) {
      result.row(k) = (force(k + 1) - force(k - 1)) * slope +
                      (force(k + 1) - 2.0 * force(k) + force(k - 1)) * curve;
    }
    return result;
  }

 private:
  void step(const Eigen::VectorXd& force,
            Eigen::Index n,
            Eigen::ArrayXcd& z) const {
    z *= decay_;
    if (force(n - 1) == 0.0 && force(n) == 0.0) return;
    z += now_.col(0) * force(n - 1) + next_.col(0) * force(n);
  }

  void feel(const Eigen::ArrayXcd& z,
            double force,
            Eigen::Index n,
            ExactResponse& result) const {
    result.acceleration.row(n) +=
        (moving_.output * z.matrix()).real() + result.direct * force;
  }

  [[nodiscard]] double stretch_of(const Eigen::ArrayXcd& z) const {
    return (moving_.stretch * z.matrix())(0).real();
  }

  // Static stretch of the stiff modes to a unit of a force.
  [[nodiscard]] double stretch_of_stiff(Eigen::Index which) const {
    const Eigen::ArrayXcd share = stiff_.input.col(which) / stiff_.lambda;
    return -(stiff_.stretch * share.matrix())(0).real();
  }

  // x of x + c x^3 = free, which rises with x: Newton's steps.
  static double pulled_back(double free, double c) {
    double x = free;
    for (int k = 0; k < 20; ++k) {
      const double off = x + c * x * x * x - free;
      x -= off / (1.0 + 3.0 * c * x * x);
      if (std::abs(off) <= 1e-14 * std::abs(free)) break;
    }
    return x;
  }

  ComplexModes moving_;
  ComplexModes stiff_;
  Eigen::ArrayXcd decay_;
  Eigen::ArrayXXcd now_;
  Eigen::ArrayXXcd next_;
};

}  // namespace

std::optional<ExactResponse> exact_response(const SecondOrderSystem& system,
                                            const Eigen::VectorXd& force,
                                            double rate_hz,
                                            double static_hz) {
  const StateMatrix state = state_matrix(system.M, system.C, system.K);
  const std::optional<ComplexModes> all = complex_modes(system, state);
  if (!all) return std::nullopt;
  ExactResponse result;
  result.direct = system.output * state.mass.solve(system.input);
  std::vector<Eigen::Index> moving;
  std::vector<Eigen::Index> stiff;
  for (Eigen::Index k = 0; k < all->lambda.size(); ++k) {
    const double hz = std::abs(all->lambda(k)) / (2.0 * std::numbers::pi);
    (static_hz > 0.0 && hz > static_hz ? stiff : moving).push_back(k);
  }
  const Motion motion(chosen(*all, moving), chosen(*all, stiff), 1.0 / rate_hz);
  result.acceleration = motion.still(0, force, rate_hz, result.direct);
  if (!system.hardening) {
    motion.run(force, result);
    return result;
  }
  Eigen::VectorXd at_once =
      system.output * state.mass.solve(system.hardening->place);
  const Eigen::VectorXd pull =
      motion.run_pulled(force, system.hardening->stiffness, result);
  result.acceleration += motion.still(1, pull, rate_hz, at_once);
  result.acceleration += pull * at_once.transpose();
  return result;
}

DampedPoles damped_poles(const Eigen::MatrixXd& M,
                         const Eigen::MatrixXd& C,
                         const Eigen::MatrixXd& K) {
  const StateMatrix state = state_matrix(M, C, K);
  const Eigen::VectorXcd lambda = state.A.eigenvalues();
  std::vector<Complex> poles;
  for (const Complex& pole : lambda) {
    if (pole.imag() > 0.0) poles.push_back(pole);
  }
  std::sort(poles.begin(), poles.end(), [](const Complex& a, const Complex& b) {
    return std::abs(a) < std::abs(b);
  });
  const auto count = static_cast<Eigen::Index>(poles.size());
  DampedPoles result{Eigen::VectorXd(count), Eigen::VectorXd(count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const Complex& pole = poles[static_cast<std::size_t>(k)];
    result.frequency_hz(k) = std::abs(pole) / (2.0 * std::numbers::pi);
    result.damping_ratio(k) = -pole.real() / std::abs(pole);
  }
  return result;
}

}  // namespace tapfit::acquisition
