#include "signal/spectra/block_tail.hpp"

#include "signal/spectra/decays.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::signal {

using complex = std::complex<double>;
using Eigen::Index;

BlockTail fit_tail(const Eigen::MatrixXd& blocks,
                   Index trigger,
                   double dt,
                   const Eigen::VectorXcd& poles) {
  if (poles.size() == 0) return {};
  const Index rows = (blocks.rows() - trigger) / 2;
  const double slowest = poles.cwiseAbs().minCoeff() / (2.0 * std::numbers::pi);
  if (static_cast<double>(rows) * dt * slowest < 2.0 ||
      rows < 4 * (2 * poles.size() + 1)) {
    return {};
  }
  const Index end = blocks.rows();
  const Eigen::MatrixXd a = fit_decays(
      decays(poles, 1.0 / dt, end - rows, rows, end), blocks.bottomRows(rows));
  BlockTail tail{poles, Eigen::MatrixXcd(poles.size(), blocks.cols())};
  for (Index r = 0; r < poles.size(); ++r) {
    tail.amplitudes.row(r).real() = a.row(2 * r);
    tail.amplitudes.row(r).imag() = -a.row(2 * r + 1);
  }
  return tail;
}

Eigen::MatrixXcd tail_spectra(const BlockTail& tail,
                              const Eigen::VectorXcd& s,
                              const Eigen::VectorXcd& kernel,
                              double dt) {
  const auto sums = [&](const Eigen::VectorXcd& poles) {
    Eigen::MatrixXcd sum(s.size(), poles.size());
    for (Index r = 0; r < poles.size(); ++r) {
      sum.col(r) =
          0.5 * kernel.array() / (1.0 - ((poles(r) - s.array()) * dt).exp());
    }
    return sum;
  };
  return sums(tail.poles) * tail.amplitudes +
         sums(tail.poles.conjugate()) * tail.amplitudes.conjugate();
}

std::string tail_statement(const Eigen::VectorXcd& poles, double seconds) {
  if (poles.size() == 0) return {};
  Index slowest = 0;
  const double rate = -poles.real().maxCoeff(&slowest);
  const bool one = poles.size() == 1;
  return fmt::format(
      "{} mode{} ({:.4g} Hz{}) {} not decayed at the end of the block ({:.2g} "
      "% left); corrected by extrapolation, in the next hit's block, too",
      poles.size(),
      one ? "" : "s",
      std::abs(poles(slowest)) / (2.0 * std::numbers::pi),
      one ? "" : " the most",
      one ? "has" : "have",
      100.0 * std::exp(-rate * seconds));
}

}  // namespace tapfit::signal
