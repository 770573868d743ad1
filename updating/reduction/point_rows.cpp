#include "updating/reduction/point_rows.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;

PointRows::PointRows(MatrixXd columns)
    : shared_(std::make_shared<MatrixXd>(std::move(columns))),
      own_(std::make_shared<MatrixXf>(shared_->rows(), 0)),
      Q_(MatrixXd::Identity(shared_->cols(), shared_->cols())) {}

PointRows PointRows::with(const MatrixXd& columns) const {
  PointRows wider = *this;
  const Index n = columns.cols();
  MatrixXf own(rows(), own_->cols() + n);
  own.leftCols(own_->cols()) = *own_;
  own.rightCols(n) = columns.cast<float>();
  wider.own_ = std::make_shared<MatrixXf>(std::move(own));
  wider.Q_ = MatrixXd::Zero(Q_.rows() + n, Q_.cols() + n);
  wider.Q_.topLeftCorner(Q_.rows(), Q_.cols()) = Q_;
  wider.Q_.bottomRightCorner(n, n).setIdentity();
  return wider;
}

void PointRows::turn(const MatrixXd& Q) { Q_ = (Q_ * Q).eval(); }

void PointRows::set_at_rest(const std::vector<int>& dofs) {
  for (const Index dof : dofs) {
    if (dof < rows()) at_rest_.push_back(dof);
  }
  std::ranges::sort(at_rest_);
}

Index PointRows::rows() const { return own_ ? own_->rows() : 0; }

Eigen::RowVectorXd PointRows::row(Index dof) const {
  if (std::ranges::binary_search(at_rest_, dof)) {
    return Eigen::RowVectorXd::Zero(cols());
  }
  if (own_->cols() == 0) return shared_->row(dof) * Q_;
  return shared_->row(dof) * Q_.topRows(shared_->cols()) +
         own_->row(dof).cast<double>() * Q_.bottomRows(own_->cols());
}

MatrixXd PointRows::rows_of_grid(std::size_t grid) const {
  const Index first = 6 * static_cast<Index>(grid);
  MatrixXd rows = shared_->middleRows(first, 6) * Q_.topRows(shared_->cols());
  if (own_->cols() > 0) {
    rows +=
        own_->middleRows(first, 6).cast<double>() * Q_.bottomRows(own_->cols());
  }
  for (const Index dof : at_rest_) {
    if (dof >= first && dof < first + 6) rows.row(dof - first).setZero();
  }
  return rows;
}

MatrixXd PointRows::all() const {
  return *this * MatrixXd::Identity(cols(), cols());
}

MatrixXd PointRows::operator*(const MatrixXd& X) const {
  const MatrixXd QX = Q_ * X;
  MatrixXd result = *shared_ * QX.topRows(shared_->cols());
  // Few rows at a time in double precision.
  constexpr Index block = 512;
  for (Index first = 0; own_->cols() > 0 && first < rows(); first += block) {
    const Index count = std::min(block, rows() - first);
    result.middleRows(first, count) +=
        own_->middleRows(first, count).cast<double>() *
        QX.bottomRows(own_->cols());
  }
  for (const Index dof : at_rest_) result.row(dof).setZero();
  return result;
}

}  // namespace tapfit::updating
