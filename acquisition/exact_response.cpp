#include "acquisition/exact_response.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <vector>

namespace tapfit::acquisition {
namespace {

using Complex = std::complex<double>;

/// x' = A x, with the velocities scaled so that A is well balanced.
struct StateMatrix {
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
  Eigen::ArrayXcd input;    ///< V^-1 B
  Eigen::MatrixXcd output;  ///< n x modes; conjugate pairs counted twice
};

std::optional<ComplexModes> complex_modes(const SecondOrderSystem& system,
                                          const StateMatrix& state) {
  const Eigen::Index r = system.M.rows();
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(state.A);
  if (solver.info() != Eigen::Success) return std::nullopt;
  const Eigen::MatrixXcd V = solver.eigenvectors();
  const Eigen::PartialPivLU<Eigen::MatrixXcd> inverse(V);
  if (!(inverse.rcond() > 1e-7)) return std::nullopt;
  Eigen::VectorXcd B = Eigen::VectorXcd::Zero(2 * r);
  B.tail(r) = state.mass.solve(system.input).cast<Complex>();
  const Eigen::VectorXcd g = inverse.solve(B);
  const Eigen::MatrixXcd L =
      (system.output * state.acceleration).cast<Complex>() * V;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < 2 * r; ++k) {
    if (solver.eigenvalues()(k).imag() >= 0.0) kept.push_back(k);
  }
  ComplexModes modes;
  modes.lambda = solver.eigenvalues()(kept).array();
  modes.input = g(kept).array();
  modes.output = L(Eigen::all, kept);
  for (Eigen::Index k = 0; k < modes.lambda.size(); ++k) {
    if (modes.lambda(k).imag() > 0.0) modes.output.col(k) *= 2.0;
  }
  return modes;
}

ComplexModes chosen(const ComplexModes& all,
                    const std::vector<Eigen::Index>& which) {
  return {all.lambda(which), all.input(which), all.output(Eigen::all, which)};
}

// l g / (s - lambda) = -l g (1 / lambda + s / lambda^2 + s^2 / lambda^3 ...):
// the first term takes the modes' share off what follows the force at once,
// the others act on its slope and curvature.
Eigen::MatrixXd static_part(const ComplexModes& stiff,
                            const Eigen::VectorXd& force,
                            double rate_hz,
                            Eigen::VectorXd& direct) {
  const auto order = [&](int power) -> Eigen::VectorXd {
    const Eigen::ArrayXcd share = stiff.input / stiff.lambda.pow(power);
    return -(stiff.output * share.matrix()).real();
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
  const ComplexModes modes = chosen(*all, moving);
  result.acceleration =
      static_part(chosen(*all, stiff), force, rate_hz, result.direct);

  const double h = 1.0 / rate_hz;
  const Eigen::ArrayXcd x = modes.lambda * h;
  const Eigen::ArrayXcd decay = x.exp();
  const Eigen::ArrayXcd next = h * x.unaryExpr(&phi2) * modes.input;
  const Eigen::ArrayXcd now = h * x.unaryExpr(&phi1) * modes.input - next;
  Eigen::ArrayXcd z = Eigen::ArrayXcd::Zero(x.size());
  for (Eigen::Index n = 0; n < force.size(); ++n) {
    if (n > 0) {
      z *= decay;
      if (force(n - 1) != 0.0 || force(n) != 0.0) {
        z += now * force(n - 1) + next * force(n);
      }
    }
    result.acceleration.row(n) +=
        (modes.output * z.matrix()).real() + result.direct * force(n);
  }
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
