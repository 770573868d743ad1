#include "tests/updating/support/sample_plate.hpp"

#include "updating/fit/fitter.hpp"

#include <fmt/format.h>

namespace tapfit::support {

structure::Deck plate_deck(bool clamped) {
  structure::Deck deck;
  deck.path = "plate.bdf";
  deck.coupled_mass = true;
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 11; ++i) {
      deck.grids.push_back({1 + i + 11 * j, {0.03 * i, 0.03 * j, 0.0}});
    }
  }
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 10; ++i) {
      const int a = 1 + i + 11 * j;
      structure::Shell shell;
      shell.id = 1 + i + 10 * j;
      shell.property = 1;
      shell.grids = {a, a + 1, a + 12, a + 11};
      deck.shells.push_back(shell);
    }
  }
  structure::Material aluminium;
  aluminium.id = 1;
  aluminium.E = 70e9;
  aluminium.nu = 0.33;
  aluminium.G = 70e9 / 2.66;
  aluminium.rho = 2700.0;
  deck.materials[1] = aluminium;
  structure::ShellProperty property;
  property.id = 1;
  property.membrane = property.bending = property.shear = 1;
  property.thickness = 0.003;
  deck.shell_properties[1] = property;
  for (int j = 0; clamped && j < 5; ++j) {
    deck.constraints.push_back({1 + 11 * j, "123456"});
  }
  return deck;
}

acquisition::TestBundle plate_bundle() {
  acquisition::TestBundle bundle;
  bundle.folder = ".";
  acquisition::Channel hammer;
  hammer.name = "hammer";
  hammer.quantity = acquisition::Quantity::Force;
  acquisition::Channel acc1;
  acc1.name = "acc1";
  acquisition::Channel acc2;
  acc2.name = "acc2";
  bundle.channels = {hammer, acc1, acc2};
  for (const int node : {11, 36, 52, 28, 6, 42}) {
    acquisition::Run run;
    run.hammer = {0, {node, 3, 1}};
    run.sensors = {{1, {11, 3, 1}}, {2, {36, 3, -1}}};
    bundle.runs.push_back(run);
  }
  bundle.band_hz = {10.0, 400.0};
  bundle.uncertain.push_back({"material", 1, "E", 3.0});
  return bundle;
}

effects::TestContext plate_context(const acquisition::TestBundle& bundle,
                                   const structure::Deck& deck) {
  effects::TestContext context;
  context.bundle = &bundle;
  context.deck = &deck;
  context.mass_kg = 0.2916;  // 0.30 * 0.12 * 0.003 * 2700
  context.low_hz = 10.0;
  context.high_hz = 400.0;
  context.component = 3;
  return context;
}

updating::BaseOptions plate_base(const acquisition::TestBundle& bundle,
                                 const structure::Deck& deck) {
  updating::BaseOptions options;
  options.high_hz = 400.0;
  options.split = false;
  const updating::MeasuredPoints points =
      updating::measured_points(deck, bundle);
  options.points = points.all;
  options.driven = points.driven;
  return options;
}

signal::FrfSet plate_pairs(const acquisition::TestBundle& bundle,
                           const Eigen::VectorXcd& s) {
  signal::FrfSet set;
  set.s = s;
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    for (const acquisition::Placement& p : bundle.runs[r].sensors) {
      signal::Frf frf;
      frf.response = p.dof;
      frf.reference = bundle.runs[r].hammer.dof;
      frf.run = r;
      frf.channel = p.channel;
      frf.H = Eigen::VectorXcd::Zero(s.size());
      frf.coherence = Eigen::VectorXd::Ones(s.size());
      frf.variance = Eigen::VectorXd::Zero(s.size());
      frf.hits = 4;
      set.frfs.push_back(frf);
    }
  }
  return set;
}

}  // namespace tapfit::support
