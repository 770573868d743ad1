// Decompositions of dense matrices, compiled once instead of in every file
// that uses them (eigen_instances.hpp).
// decompositions.cpp defines what the others declare.
#pragma once

#include <Eigen/Dense>

#ifndef TAPFIT_INSTANCE
#define TAPFIT_INSTANCE extern template
#endif

// A class and, since its members that are templates do not come with it, its
// compute() from a matrix.
#define TAPFIT_DECOMPOSITION(Kind, Matrix) \
  TAPFIT_INSTANCE class Kind<Matrix>;      \
  TAPFIT_INSTANCE Kind<Matrix>& Kind<Matrix>::compute(const EigenBase<Matrix>&);
#define TAPFIT_EIGENSOLVER(Kind, Matrix, Options)      \
  TAPFIT_INSTANCE class Kind<Matrix>;                  \
  TAPFIT_INSTANCE Kind<Matrix>& Kind<Matrix>::compute( \
      const EigenBase<Matrix>&, Options);

namespace Eigen {

TAPFIT_DECOMPOSITION(LDLT, MatrixXd)
TAPFIT_DECOMPOSITION(LLT, MatrixXd)
TAPFIT_DECOMPOSITION(PartialPivLU, MatrixXcd)
TAPFIT_DECOMPOSITION(HouseholderQR, MatrixXd)
TAPFIT_DECOMPOSITION(ColPivHouseholderQR, MatrixXd)
TAPFIT_DECOMPOSITION(CompleteOrthogonalDecomposition, MatrixXd)
TAPFIT_EIGENSOLVER(SelfAdjointEigenSolver, MatrixXd, int)
TAPFIT_EIGENSOLVER(EigenSolver, MatrixXd, bool)
TAPFIT_INSTANCE class GeneralizedSelfAdjointEigenSolver<MatrixXd>;
TAPFIT_INSTANCE class JacobiSVD<MatrixXd>;
TAPFIT_INSTANCE class JacobiSVD<MatrixXcd>;

}  // namespace Eigen

#undef TAPFIT_DECOMPOSITION
#undef TAPFIT_EIGENSOLVER
#undef TAPFIT_INSTANCE
