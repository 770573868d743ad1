#include "updating/frf_model/modal_superposition.hpp"

#include "updating/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <cstdlib>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

MatrixXd symmetric(Index n) {
  const MatrixXd A = MatrixXd::Random(n, n);
  return A + A.transpose();
}

// Twelve modes, the second and third one frequency, in a base that they are
// not the coordinates of; a run with three responses and four hit points, of
// which not all pairs were measured. A dashpot of the deck and an absorber at
// two points act on it, or nothing does.
struct SumsOfTwelve {
  static constexpr Index modes = 12;
  ModelState state;
  ModalState shared;
  RunResponse lines;
  VectorXcd s = VectorXcd::LinSpaced(9, {20.0, 300.0}, {25.0, 5000.0});

  SumsOfTwelve(bool law, bool loaded) {
    std::srand(7);
    state.zeta_other = 0.008;
    shared.state = &state;
    shared.modes.omega = VectorXd::LinSpaced(modes, 500.0, 9000.0);
    shared.modes.omega(2) = shared.modes.omega(1);
    shared.modes.phi = MatrixXd::Random(modes, modes);
    shared.owner.assign(static_cast<std::size_t>(modes), -1);
    shared.damping.d = 0.02 * shared.modes.omega;
    shared.damping.slope = shared.modes.omega.cwiseInverse() * 0.01;
    if (law) {
      state.effects = {{&effects::find("damping-law"), {}, {3.0, 1e-6, 0.01}}};
      shared.first = {0};
    } else {
      state.zeta = VectorXd::Constant(3, 0.01);
      shared.owner[1] = 0;
      shared.owner[0] = 1;
      shared.owner[4] = 2;
    }
    lines.B.resize(modes, 0);
    if (loaded) {
      const EffectInstance absorber{
          &effects::find("absorber"), {}, {2e-3, 400.0, 0.03}};
      shared.first.resize(state.effects.size());
      state.effects.push_back(absorber);
      shared.beside.resize(state.effects.size());
      shared.beside.back() = absorber;
      shared.first.push_back(5);
      lines.B = MatrixXd::Random(modes, 3);
      lines.actors = {{},
                      {shared.beside.size() - 1, 0, 1.0},
                      {shared.beside.size() - 1, 0, 0.5}};
    }
    // After three ratios, or the law's three parameters.
    constexpr std::size_t columns = 3;
    for (std::size_t k = 0; k < 2; ++k) {
      const MatrixXd dM = k == 0 ? MatrixXd() : symmetric(modes);
      shared.turning.push_back({ModalDerivative(shared.modes.phi,
                                                shared.modes.omega,
                                                shared.damping,
                                                1e6 * symmetric(modes),
                                                dM,
                                                5000.0),
                                columns + k,
                                0.7 + static_cast<double>(k)});
    }
    lines.shared = &shared;
    lines.responses = MatrixXd::Random(modes, 3);
    lines.references = MatrixXd::Random(modes, 4);
    lines.pairs = {{4, 0, 0}, {1, 2, 3}, {0, 1, 3}, {3, 2, 1}};
  }

  [[nodiscard]] ModelResponse blank(bool derivatives) const {
    ModelResponse out;
    out.H = MatrixXcd::Zero(s.size(), 5);
    if (derivatives) {
      out.dH.assign(lines.B.cols() > 0 ? 8 : 5, MatrixXcd::Zero(s.size(), 5));
    }
    return out;
  }
};

// By the dynamic stiffness of all modes with what acts on them,
// Z = diag(s^2 + d s + lambda) + B D B', of which X = Z^-1 r.
class OneByOne {
 public:
  OneByOne(const SumsOfTwelve& test, Index at)
      : test_(test), s_(test.s(at)), at_(at) {
    const VectorXd& w = test.shared.modes.omega;
    const RunResponse& lines = test.lines;
    MatrixXcd Z = MatrixXcd::Zero(w.size(), w.size());
    Z.diagonal() =
        (s_ * s_ + s_ * test.shared.damping.d.array() + w.array().square());
    D_.resize(lines.B.cols());
    for (Index a = 0; a < D_.size(); ++a) {
      const CoupledDof& actor = lines.actors[static_cast<std::size_t>(a)];
      D_(a) = s_;
      if (!actor.effect) continue;
      const EffectInstance& placed = test.shared.beside[*actor.effect];
      D_(a) = actor.weight * placed.effect->law(s_, placed.p, actor.group);
    }
    Z += lines.B * D_.asDiagonal() * lines.B.transpose();
    const auto lu = Z.partialPivLu();
    Xo_ = lu.solve(lines.responses.cast<complex<double>>());
    Xi_ = lu.solve(lines.references.cast<complex<double>>());
  }

  void respond(ModelResponse& out) const {
    fill(test_.lines.responses.transpose() * Xi_, out.H);
    of_damping(out);
    for (const TurningParameter& p : test_.shared.turning) {
      of_turning(p, out);
    }
    if (D_.size() > 0) of_absorber(out);
  }

 private:
  void of_damping(ModelResponse& out) const {
    const ModalState& shared = test_.shared;
    for (std::size_t m = 0; m < shared.owner.size(); ++m) {
      if (shared.owner[m] < 0) continue;
      VectorXcd dz = VectorXcd::Zero(SumsOfTwelve::modes);
      dz(static_cast<Index>(m)) = s_ * shared.damping.d(static_cast<Index>(m));
      fill(-Xo_.transpose() * dz.asDiagonal() * Xi_,
           out.dH[static_cast<std::size_t>(shared.owner[m])]);
    }
    const EffectInstance* law = test_.state.damping_law();
    for (std::size_t p = 0; law != nullptr && p < law->p.size(); ++p) {
      VectorXcd dz(SumsOfTwelve::modes);
      for (Index m = 0; m < dz.size(); ++m) {
        dz(m) =
            s_ * law->p[p] * law->effect->mode_damping(shared_omega()(m), p).c;
      }
      fill(-Xo_.transpose() * dz.asDiagonal() * Xi_, out.dH[p]);
    }
  }

  void of_turning(const TurningParameter& p, ModelResponse& out) const {
    const RunResponse& lines = test_.lines;
    const MatrixXd to = p.turn.turned(lines.responses);
    const MatrixXd ti = p.turn.turned(lines.references);
    const MatrixXd tB = p.turn.turned(lines.B);
    MatrixXcd dZ = lines.B * D_.asDiagonal() * tB.transpose();
    dZ += dZ.transpose().eval();
    dZ.diagonal() += p.turn.stiffness() + s_ * p.turn.damping();
    MatrixXcd change = to.transpose() * Xi_ + Xo_.transpose() * ti -
                       Xo_.transpose() * dZ * Xi_;
    p.turn.take_close(s_, Xo_, Xi_, change);
    fill(p.scale * change, out.dH[p.column]);
  }

  void of_absorber(ModelResponse& out) const {
    const ModalState& shared = test_.shared;
    const EffectInstance& placed = shared.beside.back();
    const auto actors = test_.lines.B.rightCols(2);
    for (std::size_t p = 0; p < placed.p.size(); ++p) {
      const complex<double> z =
          placed.p[p] * placed.effect->law_derivative(s_, placed.p, 0, p);
      const Eigen::Vector2cd dD(z, 0.5 * z);
      fill(-(Xo_.transpose() * actors) * dD.asDiagonal() *
               (actors.transpose() * Xi_),
           out.dH[shared.first.back() + p]);
    }
  }

  [[nodiscard]] const VectorXd& shared_omega() const {
    return test_.shared.modes.omega;
  }

  void fill(const MatrixXcd& of_points, MatrixXcd& out) const {
    for (const WalkedPair& p : test_.lines.pairs) {
      out(at_, p.frf) = s_ * s_ * of_points(p.response, p.reference);
    }
  }

  const SumsOfTwelve& test_;
  complex<double> s_;
  Index at_;
  VectorXcd D_;
  MatrixXcd Xo_;
  MatrixXcd Xi_;
};

class ModalSums : public testing::TestWithParam<std::tuple<bool, bool>> {};

TEST_P(ModalSums, AreWhatTheLinesGiveOneByOne) {
  const auto [law, loaded] = GetParam();
  const SumsOfTwelve test(law, loaded);
  ASSERT_TRUE(test.shared.turning[0].turn.has_close());
  const MatrixXcd flexible = flexibility(test.shared, test.s);
  ModelResponse one_by_one = test.blank(true);
  for (Index at = 0; at < test.s.size(); ++at) {
    OneByOne(test, at).respond(one_by_one);
  }
  ModelResponse at_once = test.blank(true);
  superpose_modes(test.lines, test.s, flexible, at_once);
  ModelResponse alone = test.blank(false);
  superpose_modes(test.lines, test.s, flexible, alone);
  // The same in another order; the absorber's own lines make it less exact.
  EXPECT_LT((at_once.H - one_by_one.H).norm(), 1e-12 * one_by_one.H.norm());
  EXPECT_EQ(alone.H, at_once.H);
  for (std::size_t k = 0; k < at_once.dH.size(); ++k) {
    EXPECT_GT(one_by_one.dH[k].norm(), 0.0) << k;
    EXPECT_LT((at_once.dH[k] - one_by_one.dH[k]).norm(),
              1e-11 * one_by_one.dH[k].norm())
        << k;
  }
}

INSTANTIATE_TEST_SUITE_P(LawAndLoad,
                         ModalSums,
                         testing::Combine(testing::Bool(), testing::Bool()));

}  // namespace
}  // namespace tapfit::updating
