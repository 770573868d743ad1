#include "updating/prediction/predicted_frfs.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

// L with L L' = C, also where C is singular.
MatrixXd root_of(const MatrixXd& C) {
  if (C.rows() == 0) return C;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(C);
  return solver.eigenvectors() *
         solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

double mean_square(const MatrixXcd& of_frf) {
  return of_frf.squaredNorm() / static_cast<double>(of_frf.rows());
}

}  // namespace

signal::FrfSet predicted_frfs(const ChangedModel& model,
                              const signal::FrfSet& measured) {
  signal::FrfSet result;
  result.s = measured.s;
  const MatrixXcd H =
      model.after->respond(model.changed(), measured.s, false).H;
  for (std::size_t f = 0; f < measured.frfs.size(); ++f) {
    const signal::Frf& seen = measured.frfs[f];
    signal::Frf frf;
    frf.response = seen.response;
    frf.reference = seen.reference;
    frf.run = seen.run;
    frf.channel = seen.channel;
    frf.H = H.col(static_cast<Index>(f));
    frf.coherence = Eigen::VectorXd::Ones(H.rows());
    frf.variance = Eigen::VectorXd::Zero(H.rows());
    result.frfs.push_back(std::move(frf));
  }
  return result;
}

std::vector<FrfChange> frf_changes(const ChangedModel& model,
                                   const Target& target,
                                   const MatrixXd& covariance,
                                   double form_variance) {
  const ModelState changed = model.changed();
  const MatrixXcd now = model.now->respond(model.state, target.s, false).H;
  const ModelResponse after = model.after->respond(changed, target.s, true);
  const FormPatterns form = model.after->form_patterns(changed, target.s);
  const Eigen::VectorXd level = target.weight.cwiseInverse();
  const MatrixXcd root = root_of(covariance).cast<std::complex<double>>();
  std::vector<FrfChange> result;
  for (Index f = 0; f < now.cols(); ++f) {
    // Sizes that are stated, behind those fitted, are known.
    MatrixXcd slopes(now.rows(), covariance.rows());
    for (Index k = 0; k < slopes.cols(); ++k) {
      slopes.col(k) = after.dH[static_cast<std::size_t>(k)].col(f);
    }
    double variance = mean_square(level.asDiagonal() * slopes * root);
    for (Index k = 0; k < form.mesh_sd.size(); ++k) {
      const MatrixXcd& pattern = form.dH[static_cast<std::size_t>(k)];
      variance += (4.0 * form_variance + form.mesh_sd(k) * form.mesh_sd(k)) *
                  mean_square(level.asDiagonal() * pattern.col(f));
    }
    result.push_back({std::sqrt(mean_square(level.asDiagonal() *
                                            (after.H.col(f) - now.col(f)))),
                      std::sqrt(variance)});
  }
  return result;
}

}  // namespace tapfit::updating
