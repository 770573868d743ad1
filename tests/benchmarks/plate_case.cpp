#include "tests/benchmarks/plate_case.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/eigenmodes.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

namespace tapfit::benchmarks {
namespace {

constexpr double top_hz = 400.0;

structure::Deck make_deck(int nx, int ny) {
  structure::Deck deck;
  deck.path = "plate.bdf";
  deck.materials[1] = {1, false, 70e9, 0.33, 70e9 / 2.66, 2700.0, 0, 0, 0};
  deck.shell_properties[1] = {1, 1, 1, 1, 0.003};
  for (int i = 0; i <= nx; ++i) {
    for (int j = 0; j <= ny; ++j) {
      const int id = 1 + i * (ny + 1) + j;
      deck.grids.push_back({id, {0.30 * i / nx, 0.12 * j / ny, 0.0}});
      if (i == 0) deck.constraints.push_back({id, "123456"});
      if (i == nx || j == ny) continue;
      const int shell = 1 + i * ny + j;
      deck.shells.push_back({shell, 1, {id, id + ny + 1, id + ny + 2, id + 1}});
    }
  }
  return deck;
}

acquisition::TestBundle make_bundle(int nx, int ny) {
  const auto node = [&](double x, double y) {
    return 1 + static_cast<int>(x * nx + 0.5) * (ny + 1) +
           static_cast<int>(y * ny + 0.5);
  };
  acquisition::TestBundle bundle;
  bundle.folder = ".";
  bundle.channels.resize(3);
  bundle.channels[0].name = "hammer";
  bundle.channels[0].quantity = acquisition::Quantity::Force;
  bundle.channels[1].name = "acc1";
  bundle.channels[2].name = "acc2";
  for (const auto& [x, y] : {std::pair{1.0, 0.0},
                             {0.5, 1.0},
                             {0.5, 0.0},
                             {1.0, 1.0},
                             {0.75, 0.0},
                             {0.75, 1.0}}) {
    acquisition::Run run;
    run.hammer = {0, {node(x, y), 3, 1}};
    run.sensors = {{1, {node(1.0, 0.0), 3, 1}}, {2, {node(0.5, 1.0), 3, 1}}};
    bundle.runs.push_back(run);
  }
  bundle.band_hz = {10.0, top_hz};
  return bundle;
}

// Degrees of freedom that are hit, measured or loaded with a mass.
std::vector<int> points_of(const PlateCase& plate) {
  std::vector<int> points;
  for (const acquisition::Run& run : plate.bundle.runs) {
    const std::size_t grid = plate.deck.grid_index(run.hammer.dof.node);
    for (int c = 0; c < 3; ++c)
      points.push_back(6 * static_cast<int>(grid) + c);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::unique_ptr<PlateCase> make_case(int nx, int ny) {
  auto plate = std::make_unique<PlateCase>();
  plate->deck = make_deck(nx, ny);
  plate->bundle = make_bundle(nx, ny);
  plate->context.bundle = &plate->bundle;
  plate->context.deck = &plate->deck;
  plate->context.mass_kg = 0.2916;
  plate->context.high_hz = top_hz;
  const structure::System system = structure::assemble(plate->deck);
  plate->free = system.free_dofs();
  plate->K = structure::extract(system.K, plate->free);
  plate->M = structure::extract(system.M, plate->free);
  updating::BaseOptions options;
  options.high_hz = top_hz;
  options.split = false;
  const std::vector<int> points = points_of(*plate);
  options.points = points;
  plate->base = updating::BaseBuilder(plate->deck, {}, options, Progress{})
                    .build(points, {});
  return plate;
}

}  // namespace

const PlateCase& plate_case(int nx, int ny) {
  static std::map<std::pair<int, int>, std::unique_ptr<PlateCase>> known;
  std::unique_ptr<PlateCase>& plate = known[{nx, ny}];
  if (!plate) plate = make_case(nx, ny);
  return *plate;
}

Eigen::VectorXcd band_lines(Eigen::Index count) {
  Eigen::VectorXcd s(count);
  s.real().setConstant(2.0);
  s.imag() =
      Eigen::VectorXd::LinSpaced(count, 10.0, top_hz) * 2.0 * std::numbers::pi;
  return s;
}

signal::FrfSet measured_pairs(const acquisition::TestBundle& bundle,
                              const Eigen::VectorXcd& s) {
  signal::FrfSet pairs;
  pairs.s = s;
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    for (const acquisition::Placement& p : bundle.runs[r].sensors) {
      signal::Frf frf;
      frf.response = p.dof;
      frf.reference = bundle.runs[r].hammer.dof;
      frf.run = r;
      frf.channel = p.channel;
      frf.H = Eigen::VectorXcd::Zero(s.size());
      frf.variance = Eigen::VectorXd::Zero(s.size());
      pairs.frfs.push_back(frf);
    }
  }
  return pairs;
}

updating::FrfModel frf_model(const PlateCase& plate,
                             const Eigen::VectorXcd& s) {
  return {plate.base, plate.context, measured_pairs(plate.bundle, s)};
}

updating::ModelState with_masses(const PlateCase& plate,
                                 std::size_t count,
                                 double mass) {
  updating::ModelState state;
  state.zeta = Eigen::VectorXd::Constant(4, 0.01);
  for (std::size_t k = 0; k < count; ++k) {
    updating::EffectInstance effect;
    effect.effect = &effects::find("added-mass");
    effect.where.node = plate.bundle.runs[k].hammer.dof.node;
    effect.p = {mass};
    state.effects.push_back(effect);
  }
  return state;
}

}  // namespace tapfit::benchmarks
