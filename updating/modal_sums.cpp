#include "updating/modal_sums.hpp"

#include <cassert>
#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// Factors of the modes on all lines, to be summed with real weights: one real
// product in place of a complex one.
class SumOfModes {
 public:
  explicit SumOfModes(const MatrixXcd& factors) : lines_(factors.cols()) {
    parts_.resize(factors.rows(), 2 * lines_);
    parts_ << factors.real(), factors.imag();
  }

  /// @param weights modes x any
  /// @return lines x any
  [[nodiscard]] MatrixXcd with(const MatrixXd& weights) const {
    const MatrixXd sums = parts_.transpose() * weights;
    MatrixXcd result(lines_, weights.cols());
    result.real() = sums.topRows(lines_);
    result.imag() = sums.bottomRows(lines_);
    return result;
  }

 private:
  Index lines_;
  MatrixXd parts_;  // modes x (real, imaginary parts of all lines)
};

// Products of a row of each point, modes x pairs.
MatrixXd products(const std::vector<WalkedPair>& pairs,
                  const MatrixXd& responses,
                  const MatrixXd& references) {
  MatrixXd result(responses.rows(), static_cast<Index>(pairs.size()));
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    result.col(static_cast<Index>(k)) =
        responses.col(pairs[k].response)
            .cwiseProduct(references.col(pairs[k].reference));
  }
  return result;
}

// What the run's derivatives share.
struct Sums {
  const RunLines& lines;
  const VectorXcd& s;
  const MatrixXcd& flexible;
  MatrixXcd squared;  // g^2, modes x lines
  MatrixXd rows;      // r_o r_i, modes x pairs
};

void derive_damping(const Sums& of, ModelResponse& out) {
  const ModalState& shared = *of.lines.shared;
  const VectorXcd cube = of.s.array().cube();
  for (Index m = 0; m < of.rows.rows(); ++m) {
    const int q = shared.owner[static_cast<std::size_t>(m)];
    if (q < 0) continue;
    const VectorXcd slope =
        -shared.damping.d(m) * cube.cwiseProduct(of.squared.row(m).transpose());
    MatrixXcd& d = out.dH[shared.first_zeta + static_cast<std::size_t>(q)];
    for (std::size_t k = 0; k < of.lines.pairs.size(); ++k) {
      d.col(of.lines.pairs[k].frf) = of.rows(m, static_cast<Index>(k)) * slope;
    }
  }
}

// The law gives every mode, the highest too, its share.
void derive_law(const Sums& of, const SumOfModes& squares, ModelResponse& out) {
  const ModalState& shared = *of.lines.shared;
  const VectorXd& w = shared.modes.omega;
  const VectorXcd cube = of.s.array().cube();
  for (std::size_t e = 0; e < shared.state->effects.size(); ++e) {
    const PlacedEffect& placed = shared.state->effects[e];
    if (placed.effect->entry() != effects::Entry::Damping) continue;
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      VectorXd share(w.size());
      for (Index m = 0; m < w.size(); ++m) {
        share(m) = placed.p[p] * placed.effect->mode_damping(w(m), p).c;
      }
      const MatrixXcd change = squares.with(share.asDiagonal() * of.rows);
      MatrixXcd& d = out.dH[shared.first[e] + p];
      for (std::size_t k = 0; k < of.lines.pairs.size(); ++k) {
        d.col(of.lines.pairs[k].frf) -=
            cube.cwiseProduct(change.col(static_cast<Index>(k)));
      }
    }
  }
}

// Of modes too close to each other to be told by their turn.
void take_close(const Sums& of, const ModeTurn& turn, MatrixXcd& change) {
  for (Index at = 0; at < of.s.size(); ++at) {
    const auto g = of.flexible.col(at).asDiagonal();
    const MatrixXcd Xo = g * of.lines.responses;
    const MatrixXcd Xi = g * of.lines.references;
    MatrixXcd close = MatrixXcd::Zero(Xo.cols(), Xi.cols());
    turn.take_close(of.s(at), Xo, Xi, close);
    for (std::size_t k = 0; k < of.lines.pairs.size(); ++k) {
      const WalkedPair& pair = of.lines.pairs[k];
      change(at, static_cast<Index>(k)) += close(pair.response, pair.reference);
    }
  }
}

void derive_turning(const Sums& of,
                    const SumOfModes& plain,
                    const SumOfModes& squares,
                    ModelResponse& out) {
  const RunLines& lines = of.lines;
  for (const TurningParameter& p : lines.shared->turning) {
    const MatrixXd turned =
        products(
            lines.pairs, p.turn.turned(lines.responses), lines.references) +
        products(lines.pairs, lines.responses, p.turn.turned(lines.references));
    MatrixXcd change = plain.with(turned);
    change -= squares.with(p.turn.stiffness().asDiagonal() * of.rows);
    change -= of.s.asDiagonal() *
              squares.with(p.turn.damping().asDiagonal() * of.rows);
    if (p.turn.has_close()) take_close(of, p.turn, change);
    const VectorXcd factor = p.scale * of.s.cwiseProduct(of.s);
    for (std::size_t k = 0; k < lines.pairs.size(); ++k) {
      out.dH[p.column].col(lines.pairs[k].frf) =
          factor.cwiseProduct(change.col(static_cast<Index>(k)));
    }
  }
}

}  // namespace

void sum_modes(const RunLines& lines,
               const VectorXcd& s,
               const MatrixXcd& flexible,
               ModelResponse& out) {
  assert(lines.B.cols() == 0);
  Sums of{lines,
          s,
          flexible,
          {},
          products(lines.pairs, lines.responses, lines.references)};
  const SumOfModes plain(flexible);
  const MatrixXcd receptance = plain.with(of.rows);
  const VectorXcd square = s.cwiseProduct(s);
  for (std::size_t k = 0; k < lines.pairs.size(); ++k) {
    out.H.col(lines.pairs[k].frf) =
        square.cwiseProduct(receptance.col(static_cast<Index>(k)));
  }
  if (out.dH.empty()) return;
  of.squared = flexible.cwiseProduct(flexible);
  const SumOfModes squares(of.squared);
  derive_damping(of, out);
  derive_law(of, squares, out);
  derive_turning(of, plain, squares, out);
}

}  // namespace tapfit::updating
