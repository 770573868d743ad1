#include "updating/studies/property_study.hpp"

#include "acquisition/bundle/read_test_bundle.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/measurement/test_model.hpp"
#include "updating/properties/uncertain_property.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/eigenmodes.hpp"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

namespace {

using ComplexSparse = Eigen::SparseMatrix<complex<double>>;

// Degree of freedom among those that move, its sign left out.
Index position(const structure::Deck& deck,
               const std::vector<int>& free,
               const Dof& dof) {
  const int index =
      6 * static_cast<int>(deck.grid_index(dof.node)) + dof.component - 1;
  return std::lower_bound(free.begin(), free.end(), index) - free.begin();
}

acquisition::Run run_of(const std::vector<Dof>& points) {
  acquisition::Run run;
  run.hammer = {0, points.front()};
  for (const Dof& dof : points) run.sensors.push_back({1, dof});
  return run;
}

}  // namespace

PropertyStudy::PropertyStudy(const std::filesystem::path& folder,
                             const std::vector<Dof>& points,
                             double reach_hz,
                             const RayleighDamping& damping)
    : bundle_(acquisition::read_test_bundle(folder)),
      points_(points),
      reach_hz_(reach_hz),
      damping_(damping) {
  acquisition::Channel force;
  force.name = "force";
  force.quantity = acquisition::Quantity::Force;
  acquisition::Channel response;
  response.name = "response";
  bundle_.channels = {force, response};
  bundle_.runs = {run_of(points)};
  deck_ = read_test_model(bundle_);
  context_.bundle = &bundle_;
  context_.deck = &deck_;
}

FrfModel PropertyStudy::model_at(const std::vector<double>& factor) const {
  BaseOptions options;
  options.high_hz = reach_hz_;
  options.reach = 1.0;
  options.split = false;
  options.points = measured_points(deck_, bundle_).all;
  const BaseBuilder builder(
      scaled(factor), bundle_.uncertain, options, Progress{});
  return {builder.build({}, {}), context_, empty_set(VectorXcd())};
}

structure::Deck PropertyStudy::scaled(const std::vector<double>& factor) const {
  structure::Deck deck = deck_;
  for (std::size_t k = 0; k < factor.size(); ++k) {
    scale_property(deck, bundle_.uncertain[k], factor[k]);
  }
  return deck;
}

signal::FrfSet PropertyStudy::empty_set(const VectorXcd& s) const {
  signal::FrfSet set;
  set.s = s;
  for (const Dof& dof : points_) {
    signal::Frf frf;
    frf.response = frf.reference = dof;
    frf.channel = 1;
    frf.H = VectorXcd::Zero(s.size());
    frf.coherence = VectorXd::Ones(s.size());
    frf.variance = VectorXd::Zero(s.size());
    set.frfs.push_back(std::move(frf));
  }
  return set;
}

signal::FrfSet PropertyStudy::exact(const std::vector<double>& factor,
                                    const VectorXcd& s) const {
  const structure::System system = structure::assemble(scaled(factor));
  const std::vector<int> free = system.free_dofs();
  const ComplexSparse K =
      structure::extract(system.K, free).cast<complex<double>>();
  const ComplexSparse M =
      structure::extract(system.M, free).cast<complex<double>>();
  signal::FrfSet set = empty_set(s);
  Eigen::SparseLU<ComplexSparse> lu;
  for (Index l = 0; l < s.size(); ++l) {
    const complex<double> of_K = 1.0 + s(l) * damping_.b;
    const complex<double> of_M = s(l) * (s(l) + damping_.a);
    const ComplexSparse Z = of_K * K + of_M * M;
    if (l == 0) lu.analyzePattern(Z);
    lu.factorize(Z);
    for (signal::Frf& frf : set.frfs) {
      VectorXcd force = VectorXcd::Zero(K.rows());
      const Index at = position(deck_, free, frf.reference);
      force(at) = 1.0;
      frf.H(l) = s(l) * s(l) * VectorXcd(lu.solve(force))(at);
    }
  }
  return set;
}

VectorXd PropertyStudy::frequencies_hz(const std::vector<double>& factor,
                                       Index count) const {
  const structure::System system = structure::assemble(scaled(factor));
  const std::vector<int> free = system.free_dofs();
  return structure::eigenmodes(structure::extract(system.K, free),
                               structure::extract(system.M, free),
                               count)
      .frequency_hz;
}

ModelState PropertyStudy::state(const FrfModel& model,
                                const std::vector<double>& factor) const {
  ModelState state;
  state.factor = factor;
  state.zeta_other = 0.0;
  if (damping_.a == 0.0 && damping_.b == 0.0) return state;
  const VectorXd omega = model.base_modes(state).omega;
  state.zeta = 0.5 * (damping_.a * omega.cwiseInverse() + damping_.b * omega);
  return state;
}

VectorXcd lines_at(const VectorXd& frequency_hz, double delta) {
  return 2.0 * std::numbers::pi * complex<double>(delta, 1.0) * frequency_hz;
}

void add_noise(signal::FrfSet& set,
               double noise,
               acquisition::SeededRandom& random) {
  for (signal::Frf& frf : set.frfs) {
    frf.variance = frf.H.cwiseAbs2() * (noise * noise / 3.0);
    for (complex<double>& h : frf.H) h *= 1.0 + noise * random.uniform(-1, 1);
  }
}

}  // namespace tapfit::updating
