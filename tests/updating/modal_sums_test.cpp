#include "updating/modal_sums.hpp"

#include "updating/effects/catalogue.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

MatrixXd symmetric(Index n) {
  const MatrixXd A = MatrixXd::Random(n, n);
  return A + A.transpose();
}

// Twelve modes, the second and third one frequency, in a base that they are
// not the coordinates of; a run with three responses and four hit points, of
// which not all pairs were measured.
struct SumsOfTwelve {
  static constexpr Index modes = 12;
  ModelState state;
  ModalState shared;
  RunLines lines;
  VectorXcd s = VectorXcd::LinSpaced(9, {20.0, 300.0}, {25.0, 5000.0});

  explicit SumsOfTwelve(bool law) {
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
    // After three ratios, or the law's three parameters.
    constexpr std::size_t columns = 3;
    for (std::size_t k = 0; k < 2; ++k) {
      const MatrixXd dM = k == 0 ? MatrixXd() : symmetric(modes);
      shared.turning.push_back({ModeTurn(shared.modes.phi,
                                         shared.modes.omega,
                                         shared.damping,
                                         1e6 * symmetric(modes),
                                         dM,
                                         5000.0),
                                columns + k,
                                0.7 + static_cast<double>(k)});
    }
    lines.shared = &shared;
    lines.B.resize(modes, 0);
    lines.responses = MatrixXd::Random(modes, 3);
    lines.references = MatrixXd::Random(modes, 4);
    lines.pairs = {{4, 0, 0}, {1, 2, 3}, {0, 1, 3}, {3, 2, 1}};
  }

  [[nodiscard]] ModelResponse blank(bool derivatives) const {
    ModelResponse out;
    out.H = MatrixXcd::Zero(s.size(), 5);
    if (derivatives) out.dH.assign(5, MatrixXcd::Zero(s.size(), 5));
    return out;
  }
};

// The definition: one line after the other.
TEST(ModalSums, AreWhatTheLinesGiveOneByOne) {
  for (const bool law : {false, true}) {
    const SumsOfTwelve test(law);
    ASSERT_TRUE(test.shared.turning[0].turn.has_close());
    const MatrixXcd flexible = flexibility(test.shared, test.s);
    ModelResponse one_by_one = test.blank(true);
    test.lines.respond(test.s, flexible, one_by_one);
    ModelResponse at_once = test.blank(true);
    sum_modes(test.lines, test.s, flexible, at_once);
    ModelResponse alone = test.blank(false);
    sum_modes(test.lines, test.s, flexible, alone);
    // The same sums in another order.
    EXPECT_LT((at_once.H - one_by_one.H).norm(), 1e-13 * one_by_one.H.norm());
    EXPECT_EQ(alone.H, at_once.H);
    for (std::size_t k = 0; k < at_once.dH.size(); ++k) {
      EXPECT_GT(one_by_one.dH[k].norm(), 0.0) << law << ' ' << k;
      EXPECT_LT((at_once.dH[k] - one_by_one.dH[k]).norm(),
                1e-12 * one_by_one.dH[k].norm())
          << law << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace tapfit::updating
