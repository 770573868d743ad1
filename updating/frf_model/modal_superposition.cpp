#include "updating/frf_model/modal_superposition.hpp"

#include <complex>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::Map;
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

// The products of modal rows that the sums are made of, a column each: of the
// measured pairs first, then of every actor with every response, every
// reference and every actor.
class RowProducts {
 public:
  explicit RowProducts(const RunResponse& lines)
      : actors_(lines.B.cols()),
        responses_(lines.responses.cols()),
        references_(lines.references.cols()) {
    rows_.resize(lines.B.rows(), responses_ + references_ + actors_);
    rows_ << lines.responses, lines.references, lines.B;
    for (const WalkedPair& p : lines.pairs) {
      columns_.emplace_back(p.response, responses_ + p.reference);
    }
    for (Index q = 0; q < rows_.cols(); ++q) {
      for (Index a = 0; a < actors_; ++a) {
        columns_.emplace_back(responses_ + references_ + a, q);
      }
    }
  }

  /// modes x products
  [[nodiscard]] MatrixXd plain() const { return products(rows_, rows_); }
  /// What they change by where the modes turn.
  [[nodiscard]] MatrixXd turned(const ModalDerivative& turn) const {
    const MatrixXd t = turn.turned(rows_);
    return products(t, rows_) + products(rows_, t);
  }

  // One line's sums, behind those of the pairs.
  struct OfActors {
    Map<const MatrixXcd> responses;   // actors x responses
    Map<const MatrixXcd> references;  // actors x references
    Map<const MatrixXcd> actors;      // actors x actors
  };
  [[nodiscard]] OfActors of_actors(const VectorXcd& line) const {
    const std::complex<double>* at =
        line.data() + line.size() - actors_ * rows_.cols();
    return {{at, actors_, responses_},
            {at + actors_ * responses_, actors_, references_},
            {at + actors_ * (responses_ + references_), actors_, actors_}};
  }

 private:
  [[nodiscard]] MatrixXd products(const MatrixXd& a, const MatrixXd& b) const {
    MatrixXd result(a.rows(), static_cast<Index>(columns_.size()));
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      result.col(static_cast<Index>(k)) =
          a.col(columns_[k].first).cwiseProduct(b.col(columns_[k].second));
    }
    return result;
  }

  Index actors_;
  Index responses_;
  Index references_;
  MatrixXd rows_;  // modes x (responses, references, actors)
  std::vector<std::pair<Index, Index>> columns_;
};

// What the actors do on one line: X = G (R - B u) of unit forces at the points.
struct Loaded {
  MatrixXcd uo;   // actors x responses
  MatrixXcd ui;   // actors x references
  MatrixXcd BXo;  // B' X
  MatrixXcd BXi;
};

// What the run's derivatives share.
class Sums {
 public:
  Sums(const RunResponse& lines, const VectorXcd& s, const MatrixXcd& flexible)
      : lines_(lines),
        s_(s),
        flexible_(flexible),
        products_(lines),
        rows_(products_.plain()),
        plain_(flexible),
        squares_(flexible.cwiseProduct(flexible)) {}

  void respond(ModelResponse& out);
  void derive_damping(ModelResponse& out) const;
  void derive_law(ModelResponse& out) const;
  void derive_effects(ModelResponse& out) const;
  void derive_turning(ModelResponse& out) const;

 private:
  // c_o' S c_i of every pair with c = (e; -u), lines x pairs.
  [[nodiscard]] MatrixXcd closed(const MatrixXcd& sums) const;
  void take_close(const ModalDerivative& turn, MatrixXcd& change) const;

  const RunResponse& lines_;
  const VectorXcd& s_;
  const MatrixXcd& flexible_;
  RowProducts products_;
  MatrixXd rows_;
  SumOfModes plain_;    // of g
  SumOfModes squares_;  // of g^2
  std::vector<Loaded> loaded_;
};

void Sums::respond(ModelResponse& out) {
  const MatrixXcd sums = plain_.with(rows_);
  for (Index at = 0; at < s_.size(); ++at) {
    const VectorXcd line = sums.row(at).transpose();
    const auto [Bo, Bi, BB] = products_.of_actors(line);
    Loaded now;
    MatrixXcd taken;
    if (lines_.B.cols() > 0) {
      const MatrixXcd coupled = lines_.coupling(s_(at), BB);
      now.uo = coupled.lazyProduct(Bo);
      now.ui = coupled.lazyProduct(Bi);
      now.BXo = Bo - BB.lazyProduct(now.uo);
      now.BXi = Bi - BB.lazyProduct(now.ui);
      taken = now.uo.transpose().lazyProduct(Bi);
    }
    for (std::size_t k = 0; k < lines_.pairs.size(); ++k) {
      const WalkedPair& p = lines_.pairs[k];
      std::complex<double> H = line(static_cast<Index>(k));
      if (taken.size() > 0) H -= taken(p.response, p.reference);
      out.H(at, p.frf) = s_(at) * s_(at) * H;
    }
    loaded_.push_back(std::move(now));
  }
}

MatrixXcd Sums::closed(const MatrixXcd& sums) const {
  if (lines_.B.cols() == 0) return sums;
  MatrixXcd result = sums.leftCols(static_cast<Index>(lines_.pairs.size()));
  for (Index at = 0; at < s_.size(); ++at) {
    const VectorXcd line = sums.row(at).transpose();
    const auto [Bo, Bi, BB] = products_.of_actors(line);
    const Loaded& now = loaded_[static_cast<std::size_t>(at)];
    const MatrixXcd moved = BB.lazyProduct(now.ui) - Bi;
    const MatrixXcd added = now.uo.transpose().lazyProduct(moved) -
                            Bo.transpose().lazyProduct(now.ui);
    for (std::size_t k = 0; k < lines_.pairs.size(); ++k) {
      const WalkedPair& p = lines_.pairs[k];
      result(at, static_cast<Index>(k)) += added(p.response, p.reference);
    }
  }
  return result;
}

void Sums::derive_damping(ModelResponse& out) const {
  const ModalState& shared = *lines_.shared;
  std::vector<Index> owned;
  for (Index m = 0; m < rows_.rows(); ++m) {
    if (shared.owner[static_cast<std::size_t>(m)] >= 0) owned.push_back(m);
  }
  const MatrixXd o = lines_.responses(owned, Eigen::all);
  const MatrixXd i = lines_.references(owned, Eigen::all);
  const MatrixXd B = lines_.B(owned, Eigen::all);
  for (Index at = 0; at < s_.size(); ++at) {
    const Loaded& now = loaded_[static_cast<std::size_t>(at)];
    MatrixXcd co = o;
    MatrixXcd ci = i;
    if (B.cols() > 0) {
      co -= B.cast<std::complex<double>>().lazyProduct(now.uo);
      ci -= B.cast<std::complex<double>>().lazyProduct(now.ui);
    }
    const std::complex<double> cube = s_(at) * s_(at) * s_(at);
    for (std::size_t k = 0; k < owned.size(); ++k) {
      const Index m = owned[k];
      const auto q =
          static_cast<std::size_t>(shared.owner[static_cast<std::size_t>(m)]);
      const std::complex<double> g = flexible_(m, at);
      const std::complex<double> z = -shared.damping.d(m) * cube * g * g;
      const auto row = static_cast<Index>(k);
      MatrixXcd& d = out.dH[shared.first_zeta + q];
      for (const WalkedPair& p : lines_.pairs) {
        d(at, p.frf) = z * co(row, p.response) * ci(row, p.reference);
      }
    }
  }
}

// The law gives every mode, the highest too, its share.
void Sums::derive_law(ModelResponse& out) const {
  const ModalState& shared = *lines_.shared;
  const VectorXd& w = shared.modes.omega;
  const VectorXcd cube = s_.array().cube();
  for (std::size_t e = 0; e < shared.state->effects.size(); ++e) {
    const EffectInstance& placed = shared.state->effects[e];
    if (placed.effect->entry() != effects::Entry::Damping) continue;
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      VectorXd share(w.size());
      for (Index m = 0; m < w.size(); ++m) {
        share(m) = placed.p[p] * placed.effect->mode_damping(w(m), p).c;
      }
      const MatrixXcd change =
          closed(squares_.with(share.asDiagonal() * rows_));
      MatrixXcd& d = out.dH[shared.first[e] + p];
      for (std::size_t k = 0; k < lines_.pairs.size(); ++k) {
        d.col(lines_.pairs[k].frf) -=
            cube.cwiseProduct(change.col(static_cast<Index>(k)));
      }
    }
  }
}

void Sums::derive_effects(ModelResponse& out) const {
  const ModalState& shared = *lines_.shared;
  for (std::size_t a = 0; a < lines_.actors.size(); ++a) {
    const CoupledDof& actor = lines_.actors[a];
    if (!actor.effect) continue;
    // What is in the modes is zero here, and so is its slope.
    const EffectInstance& placed = shared.beside[*actor.effect];
    const auto r = static_cast<Index>(a);
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      MatrixXcd& d = out.dH[shared.first[*actor.effect] + p];
      for (Index at = 0; at < s_.size(); ++at) {
        const std::complex<double> s = s_(at);
        const Loaded& now = loaded_[static_cast<std::size_t>(at)];
        const std::complex<double> dz =
            actor.weight * placed.p[p] *
            placed.effect->law_derivative(s, placed.p, actor.group, p);
        for (const WalkedPair& q : lines_.pairs) {
          d(at, q.frf) -=
              s * s * dz * now.BXo(r, q.response) * now.BXi(r, q.reference);
        }
      }
    }
  }
}

// Of modes too close to each other to be told by their turn.
void Sums::take_close(const ModalDerivative& turn, MatrixXcd& change) const {
  for (Index at = 0; at < s_.size(); ++at) {
    const Loaded& now = loaded_[static_cast<std::size_t>(at)];
    const auto g = flexible_.col(at).asDiagonal();
    MatrixXcd Xo = g * lines_.responses;
    MatrixXcd Xi = g * lines_.references;
    if (lines_.B.cols() > 0) {
      Xo -= g * (lines_.B * now.uo);
      Xi -= g * (lines_.B * now.ui);
    }
    MatrixXcd close = MatrixXcd::Zero(Xo.cols(), Xi.cols());
    turn.take_close(s_(at), Xo, Xi, close);
    for (std::size_t k = 0; k < lines_.pairs.size(); ++k) {
      const WalkedPair& pair = lines_.pairs[k];
      change(at, static_cast<Index>(k)) += close(pair.response, pair.reference);
    }
  }
}

void Sums::derive_turning(ModelResponse& out) const {
  for (const TurningParameter& p : lines_.shared->turning) {
    MatrixXcd sums = plain_.with(products_.turned(p.turn));
    sums -= squares_.with(p.turn.stiffness().asDiagonal() * rows_);
    sums -=
        s_.asDiagonal() * squares_.with(p.turn.damping().asDiagonal() * rows_);
    MatrixXcd change = closed(sums);
    if (p.turn.has_close()) take_close(p.turn, change);
    const VectorXcd factor = p.scale * s_.cwiseProduct(s_);
    for (std::size_t k = 0; k < lines_.pairs.size(); ++k) {
      out.dH[p.column].col(lines_.pairs[k].frf) =
          factor.cwiseProduct(change.col(static_cast<Index>(k)));
    }
  }
}

}  // namespace

void superpose_modes(const RunResponse& lines,
                     const VectorXcd& s,
                     const MatrixXcd& flexible,
                     ModelResponse& out) {
  Sums sums(lines, s, flexible);
  sums.respond(out);
  if (out.dH.empty()) return;
  sums.derive_damping(out);
  sums.derive_law(out);
  sums.derive_effects(out);
  sums.derive_turning(out);
}

}  // namespace tapfit::updating
