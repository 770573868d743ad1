// A hammer test of a freely hung structure given by its modes at a few points:
// each run hits one point, all sensors listen. Exact but for the noise asked
// for (generated_test.hpp).
#pragma once

#include "tests/signal/support/generated_test.hpp"

namespace tapfit::signal {

struct StructureMode {
  double hz = 10.0;
  double zeta = 0.01;
  std::vector<double> phi;  // per point [kg^-1/2]
};

struct HungStructure {
  std::vector<StructureMode> modes;
  std::vector<std::size_t> sensors;  // points
  std::vector<std::size_t> hits;     // points, one per run
};

// 2 kg on soft strings (0.3 Hz, gone within the block), two bending modes.
// Point k is node k + 1.
inline HungStructure hung_beam() {
  const double rigid = 1.0 / std::sqrt(2.0);
  return {{{0.3, 0.3, {rigid, rigid, rigid}},
           {32.0, 0.01, {1.0, -0.6, 0.3}},
           {71.0, 0.008, {0.8, 0.9, -0.7}}},
          {0, 1},
          {0, 1}};
}

inline std::vector<TestMode> modes_between(const HungStructure& structure,
                                           std::size_t response,
                                           std::size_t hit) {
  std::vector<TestMode> modes;
  for (const StructureMode& m : structure.modes) {
    modes.push_back({m.hz, m.zeta, m.phi[response] * m.phi[hit]});
  }
  return modes;
}

inline GeneratedTest generate_structure(const HungStructure& structure,
                                        GeneratedOptions o) {
  GeneratedTest all;
  for (std::size_t r = 0; r < structure.hits.size(); ++r) {
    acquisition::Run run;
    run.file = "run-" + std::to_string(r + 1) + ".wav";
    run.hammer = {0, Dof{static_cast<int>(structure.hits[r]) + 1, 3, 1}};
    for (std::size_t c = 0; c < structure.sensors.size(); ++c) {
      o.seed += 1;
      const GeneratedTest one = generate_test(
          modes_between(structure, structure.sensors[c], structure.hits[r]), o);
      if (c == 0) {
        all.recordings.push_back(one.recordings[0]);
        all.recordings.back().samples.conservativeResize(
            Eigen::NoChange,
            static_cast<Eigen::Index>(structure.sensors.size()) + 1);
        const std::vector<acquisition::Hit> hits = one.hits.runs[0];
        auto runs = std::move(all.hits.runs);
        all.hits = one.hits;
        all.hits.runs = std::move(runs);
        all.hits.runs.push_back(hits);
      }
      all.recordings.back().samples.col(static_cast<Eigen::Index>(c) + 1) =
          one.recordings[0].samples.col(1);
      run.sensors.push_back(
          {c + 1, Dof{static_cast<int>(structure.sensors[c]) + 1, 3, 1}});
      if (r > 0) continue;
      if (c == 0) all.bundle.channels = {one.bundle.channels[0]};
      all.bundle.channels.push_back(one.bundle.channels[1]);
      all.bundle.channels.back().name = "acc" + std::to_string(c + 1);
      all.bundle.channels.back().unit = "m/s^2";
    }
    all.bundle.runs.push_back(run);
  }
  all.bundle.band_hz = {5.0, 100.0};
  return all;
}

}  // namespace tapfit::signal
