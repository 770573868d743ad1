// Blows at given times on one mode, and what was found of them.
#pragma once

#include "acquisition/hits/find_hits.hpp"
#include "acquisition/hits/hits.hpp"
#include "tests/acquisition/support/hammer_record.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace tapfit::testing {

using acquisition::Hit;
using acquisition::HitFault;
using acquisition::HitOptions;
using acquisition::HitSet;
using acquisition::Recording;
using acquisition::TestBundle;
using Eigen::Index;

struct Blow {
  double time_s = 0.0;
  double peak_n = 20.0;
};

struct Scene {
  double rate = 2048.0;
  double length_s = 17.0;
  double width_s = 2e-3;
  double noise = 1e-3;
  double decay = 2.0;  // [1/s]
  double frequency = 60.0;
  std::vector<Blow> blows{{1.0, 20.0}, {5.0, 30.0}, {9.0, 25.0}, {13.0, 15.0}};
};

inline Recording record(const Scene& scene, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  const auto n = static_cast<Index>(scene.length_s * scene.rate);
  Eigen::VectorXd force = Eigen::VectorXd::Constant(n, 0.3);
  Eigen::VectorXd response = Eigen::VectorXd::Constant(n, -0.02);
  for (const Blow& blow : scene.blows) {
    add_pulse(force,
              scene.rate,
              blow.time_s,
              scene.width_s,
              blow.peak_n,
              scene.width_s * scene.rate < 8.0);
    add_response(response,
                 scene.rate,
                 blow.time_s,
                 scene.frequency,
                 scene.decay,
                 blow.peak_n);
  }
  add_noise(force, scene.noise, random);
  add_noise(response, scene.noise, random);
  Recording recording;
  recording.sample_rate_hz = scene.rate;
  recording.samples.resize(n, 2);
  recording.samples << force, response;
  return recording;
}

inline HitSet find(const std::vector<Recording>& recordings,
                   const HitOptions& options = {}) {
  TestBundle bundle = hammer_bundle(recordings.size());
  bundle.band_hz = {5.0, 200.0};
  return find_hits(bundle, recordings, options);
}

inline std::string reasons(const Hit& hit) {
  std::string text;
  for (const HitFault fault : hit.reasons) text += name(fault) + " ";
  return text;
}

inline bool blames(const Hit& hit, HitFault fault) {
  return !hit.accepted &&
         std::count(hit.reasons.begin(), hit.reasons.end(), fault) == 1;
}

}  // namespace tapfit::testing
