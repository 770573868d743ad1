#include "signal/mass_removal/free_frfs.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "signal/frf_set/set_ups.hpp"
#include "signal/mass_removal/sensor_loads.hpp"
#include "tests/support/matchers.hpp"

#include <Eigen/Dense>

#include <complex>
#include <numbers>
#include <random>

namespace tapfit::signal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr Index dofs = 6;  // nodes 1 and 2 in X, Y, Z

Dof dof_of(Index i, int sign = 1) {
  return {static_cast<int>(i) / 3 + 1, static_cast<int>(i) % 3 + 1, sign};
}

/// A full structure of six degrees of freedom, loaded at some of them.
struct Structure {
  Eigen::MatrixXd M;
  Eigen::MatrixXd K;

  Structure() {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(
        dofs, dofs, [&] { return normal(random); });
    const Eigen::MatrixXd b = Eigen::MatrixXd::NullaryExpr(
        dofs, dofs, [&] { return normal(random); });
    M = Eigen::MatrixXd::Identity(dofs, dofs) + 0.05 * a * a.transpose();
    K = 1e4 * (Eigen::MatrixXd::Identity(dofs, dofs) + b * b.transpose());
  }

  [[nodiscard]] Eigen::MatrixXcd accelerance(Complex s,
                                             const Eigen::VectorXd& kg) const {
    Eigen::MatrixXcd Z =
        (s * s * (M + Eigen::MatrixXd(kg.asDiagonal())) + K + 1e-4 * s * K)
            .eval();
    return s * s * Z.inverse();
  }
};

const Eigen::VectorXcd& test_lines() {
  static const Eigen::VectorXcd s = [] {
    Eigen::VectorXcd lines(20);
    for (Index k = 0; k < lines.size(); ++k) {
      lines(k) = {
          0.3, 2.0 * std::numbers::pi * (4.0 + 2.0 * static_cast<double>(k))};
    }
    return lines;
  }();
  return s;
}

Frf frf_of(const Structure& structure,
           const Eigen::VectorXd& kg,
           Dof response,
           Dof reference) {
  const auto index = [](const Dof& dof) {
    return Index{3} * (dof.node - 1) + dof.component - 1;
  };
  Frf frf;
  frf.response = response;
  frf.reference = reference;
  frf.H.resize(test_lines().size());
  for (Index k = 0; k < frf.H.size(); ++k) {
    frf.H(k) = static_cast<double>(response.sign * reference.sign) *
               structure.accelerance(test_lines()(k), kg)(index(response),
                                                          index(reference));
  }
  frf.variance = Eigen::VectorXd::Zero(frf.H.size());
  frf.coherence = Eigen::VectorXd::Ones(frf.H.size());
  return frf;
}

void expect_bare(const Frf& freed) {
  static const Structure structure;
  const Frf bare = frf_of(
      structure, Eigen::VectorXd::Zero(dofs), freed.response, freed.reference);
  // Exact algebra on numbers of some hundreds.
  EXPECT_LT((freed.H - bare.H).norm(), 1e-10 * bare.H.norm()) << name(freed);
}

TEST(FreeFrfs, TakesATriaxialSensorOffInAllDirections) {
  const Structure structure;
  Eigen::VectorXd kg = Eigen::VectorXd::Zero(dofs);
  kg.head(3).setConstant(0.2);  // one sensor at node 1 under three names
  FrfSet set;
  set.s = test_lines();
  for (Index hit = 0; hit < dofs; ++hit) {
    for (Index axis = 0; axis < 3; ++axis) {
      const int sign = axis == 1 ? -1 : 1;
      Frf frf = frf_of(
          structure, kg, dof_of(axis, sign), dof_of(hit, hit == 0 ? -1 : 1));
      frf.run = static_cast<std::size_t>(hit);
      frf.channel = static_cast<std::size_t>(axis) + 1;
      set.frfs.push_back(frf);
    }
  }
  const LoadedTest loaded = sensors_as_loads(set, {{2, {"accy", 0.2, 0.0}}});
  ASSERT_EQ(loaded.loads.size(), 1U);
  EXPECT_EQ(loaded.loads[0].size(), 3U);
  const FreedFrfs freed = free_frfs(set, loaded, {});
  for (std::size_t f = 0; f < set.frfs.size(); ++f) {
    EXPECT_EQ(freed.notes[f].by, FreedBy::Measurement);
    expect_bare(freed.frfs.frfs[f]);
  }
}

/// A sensor roves over the nodes in Z, the hammer stays at node 1.
FrfSet roving_sensor(double kg_each) {
  const Structure structure;
  FrfSet set;
  set.s = test_lines();
  for (std::size_t run = 0; run < 2; ++run) {
    Eigen::VectorXd kg = Eigen::VectorXd::Zero(dofs);
    const Index at = run == 0 ? 2 : 5;
    kg(at) = kg_each;
    Frf frf = frf_of(structure, kg, dof_of(at), dof_of(2));
    frf.run = run;
    frf.channel = 1;
    set.frfs.push_back(frf);
  }
  return set;
}

TEST(FreeFrfs, FreesARovingSensorWhereItsOwnPlaceWasHit) {
  const FrfSet set = roving_sensor(0.3);
  EXPECT_EQ(set_ups(set), (std::vector<std::size_t>{0, 1}));
  const LoadedTest loaded = sensors_as_loads(set, {{1, {"acc1", 0.3, 0.0}}});
  const FreedFrfs freed = free_frfs(set, loaded, {});
  EXPECT_EQ(freed.notes[0].by, FreedBy::Measurement);
  expect_bare(freed.frfs.frfs[0]);
  EXPECT_EQ(freed.notes[1].by, FreedBy::NotFreed);
  EXPECT_THAT(freed.notes[1].reason, HasSubstr("2Z+ / 2Z+"));
  // As it was: nothing half done.
  EXPECT_EQ(freed.frfs.frfs[1].H, set.frfs[1].H);
}

TEST(FreeFrfs, AsksAModelForWhatWasNotMeasured) {
  const FrfSet set = roving_sensor(0.3);
  const LoadedTest loaded = sensors_as_loads(set, {{1, {"acc1", 0.3, 0.0}}});
  const Structure structure;
  Eigen::VectorXd kg = Eigen::VectorXd::Zero(dofs);
  kg(5) = 0.3;
  const auto model = [&](std::size_t set_up, const Dof& a, const Dof& b) {
    EXPECT_EQ(set_up, 1U);
    return ModelledFrf{frf_of(structure, kg, a, b).H,
                       Eigen::VectorXd::Constant(set.lines(), 1e-3)};
  };
  const FreedFrfs freed = free_frfs(set, loaded, model);
  EXPECT_EQ(freed.notes[1].by, FreedBy::Model);
  expect_bare(freed.frfs.frfs[1]);
  EXPECT_GT(freed.frfs.frfs[1].variance.minCoeff(), 0.0);
}

TEST(FreeFrfs, UsesReciprocityBetweenSensors) {
  // Two sensors at 1Z and 2Z, hits at both: A(1Z, 2Z) is missing and known from
  // A(2Z, 1Z).
  const Structure structure;
  Eigen::VectorXd kg = Eigen::VectorXd::Zero(dofs);
  kg(2) = 0.2;
  kg(5) = 0.1;
  FrfSet set;
  set.s = test_lines();
  const std::vector<std::array<Index, 2>> pairs{{2, 2}, {5, 2}, {5, 5}};
  for (const auto& [response, reference] : pairs) {
    Frf frf = frf_of(structure, kg, dof_of(response), dof_of(reference));
    frf.run = reference == 2 ? 0 : 1;
    frf.channel = response == 2 ? 1 : 2;
    set.frfs.push_back(frf);
  }
  const LoadedTest loaded =
      sensors_as_loads(set, {{1, {"acc1", 0.2, 0.0}}, {2, {"acc2", 0.1, 0.0}}});
  ASSERT_EQ(loaded.loads.size(), 1U);
  const FreedFrfs freed = free_frfs(set, loaded, {});
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_EQ(freed.notes[f].by, FreedBy::Measurement);
    expect_bare(freed.frfs.frfs[f]);
  }
}

TEST(FreeFrfs, LeavesWhatNoMassWasOn) {
  const FrfSet set = roving_sensor(0.3);
  const LoadedTest loaded = sensors_as_loads(set, {{4, {"other", 0.3, 0.0}}});
  for (const FreedNote& note : free_frfs(set, loaded, {}).notes) {
    EXPECT_EQ(note.by, FreedBy::NoNeed);
  }
}

TEST(FreeFrfs, TakesAMassOffAPoint) {
  const FrfSet all = roving_sensor(0.3);
  FrfSet set = all;
  set.frfs.resize(1);
  const LoadedTest loaded =
      points_as_loads(set, {{dof_of(2, -1), {"1Z-", 0.3, 0.0}}});
  const FreedFrfs freed = free_frfs(set, loaded, {});
  EXPECT_EQ(freed.notes[0].by, FreedBy::Measurement);
  expect_bare(freed.frfs.frfs[0]);
}

TEST(FreeFrfs, RefusesTwoMassesOfOneSensor) {
  FrfSet set = roving_sensor(0.3);
  set.frfs.resize(1);
  Frf other = set.frfs[0];
  other.response.component = 1;
  other.channel = 2;
  set.frfs.push_back(other);
  EXPECT_THROW((void)sensors_as_loads(
                   set, {{1, {"accz", 0.3, 0.0}}, {2, {"accx", 0.2, 0.0}}}),
               InputError);
}

TEST(SetUps, JoinsRunsWhoseSensorsStay) {
  FrfSet set;
  const auto add = [&](std::size_t run, std::size_t channel, int node) {
    Frf frf;
    frf.run = run;
    frf.channel = channel;
    frf.response = {node, 3, 1};
    set.frfs.push_back(frf);
  };
  add(0, 1, 10);
  add(0, 2, 20);
  add(1, 1, 10);
  add(1, 2, 30);  // the second sensor moved
  add(2, 1, 10);  // one dead channel: nothing says that it moved
  add(3, 2, 10);  // another sensor at the same point is another mass
  EXPECT_EQ(set_ups(set), (std::vector<std::size_t>{0, 0, 1, 1, 0, 2}));
}

}  // namespace
}  // namespace tapfit::signal
