#include "tests/updating/support/faulty_test.hpp"

#include "acquisition/bundle/write_test_bundle.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "tests/signal/support/generated_structure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tapfit::updating::testing {
namespace {

using acquisition::Recording;
using Eigen::Index;
using Eigen::VectorXd;
using signal::HungStructure;

constexpr double mass_kg = 2.0;

// Modes cos(i pi x) cos(j pi y) (free) or sin (held) at random points.
HungStructure plate(const PlainOptions& o, int points) {
  std::mt19937 engine(o.seed);
  std::uniform_real_distribution<double> anywhere(0.05, 0.95);
  HungStructure made;
  std::vector<double> x;
  std::vector<double> y;
  for (int p = 0; p < points; ++p) {
    x.push_back(anywhere(engine));
    y.push_back(anywhere(engine));
  }
  const double long_side = std::uniform_real_distribution(1.1, 1.9)(engine);
  const double lowest = std::uniform_real_distribution(12.0, 20.0)(engine);
  std::uniform_real_distribution<double> damping(0.004, 0.015);
  if (!o.held) {
    // Hung: up and down, and both ways of tipping, gone within the block.
    for (int kind = 0; kind < 3; ++kind) {
      signal::StructureMode mode{0.3 + 0.1 * kind, 0.3, {}};
      for (int p = 0; p < points; ++p) {
        const auto at = static_cast<std::size_t>(p);
        const double arm = kind == 1 ? x[at] - 0.5 : y[at] - 0.5;
        mode.phi.push_back((kind == 0 ? 1.0 : std::sqrt(12.0) * arm) /
                           std::sqrt(mass_kg));
      }
      made.modes.push_back(mode);
    }
  }
  const int first = o.held ? 1 : 0;
  for (int i = first; i < 4; ++i) {
    for (int j = first; j < 4; ++j) {
      if (!o.held && i + j < 2) continue;
      const double k = i * i + j * j / (long_side * long_side);
      const double hz = o.stiffer * lowest * k / (o.held ? 1.3 : 1.0);
      const double zeta = damping(engine);
      if (hz > 180.0) continue;
      signal::StructureMode mode{hz, zeta, {}};
      for (int p = 0; p < points; ++p) {
        const auto at = static_cast<std::size_t>(p);
        const double px = i * std::numbers::pi * x[at];
        const double py = j * std::numbers::pi * y[at];
        const double value =
            o.held ? std::sin(px) * std::sin(py) : std::cos(px) * std::cos(py);
        const double size =
            (i > 0 ? std::sqrt(2.0) : 1.0) * (j > 0 ? std::sqrt(2.0) : 1.0);
        mode.phi.push_back(size * value / std::sqrt(mass_kg));
      }
      made.modes.push_back(mode);
    }
  }
  return made;
}

Eigen::Ref<VectorXd> column(SheetAndRecords& test, std::size_t run, Index c) {
  return test.recordings[run].samples.col(c);
}

void each_run(SheetAndRecords& test,
              const std::function<void(Eigen::MatrixXd&)>& change) {
  for (Recording& recording : test.recordings) change(recording.samples);
}

// From just visible to gross, evenly in the logarithm.
double between(double least, double most, double size) {
  return least * std::pow(most / least, size);
}

// The samples later by that many, between samples by cubic Lagrange polynomials
// (the signals are smooth).
VectorXd delayed(const VectorXd& x, double samples) {
  VectorXd y = VectorXd::Zero(x.size());
  const auto whole = static_cast<Index>(std::floor(samples));
  const double t = 1.0 - (samples - static_cast<double>(whole));
  // Nodes -1, 0, 1, 2 around the place t between 0 and 1.
  const double w0 = -t * (t - 1.0) * (t - 2.0) / 6.0;
  const double w1 = (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0;
  const double w2 = -(t + 1.0) * t * (t - 2.0) / 2.0;
  const double w3 = (t + 1.0) * t * (t - 1.0) / 6.0;
  for (Index i = whole + 3; i + 1 < x.size(); ++i) {
    const Index at = i - whole - 1;
    y(i) = w0 * x(at - 1) + w1 * x(at) + w2 * x(at + 1) + w3 * x(at + 2);
  }
  return y;
}

// Velocity from acceleration: trapezoids, and a slow leak so that noise does
// not run away.
VectorXd integrated(const VectorXd& x, double rate) {
  VectorXd y = VectorXd::Zero(x.size());
  const double leak = std::exp(-2.0 * std::numbers::pi * 0.2 / rate);
  for (Index i = 1; i < x.size(); ++i) {
    y(i) = leak * y(i - 1) + 0.5 * (x(i) + x(i - 1)) / rate;
  }
  return y;
}

SheetAndRecords other_structure(const PlainOptions& o, double size) {
  PlainOptions other = o;
  other.seed = o.seed + 1000;
  other.stiffer = 1.0 + 0.2 * size;
  return plain_test(other);
}

std::vector<Mistake> all_mistakes() {
  using Test = SheetAndRecords;
  using Plain = PlainOptions;
  return {
      {"sensor turned over",
       {"polarity"},
       [](Test& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(1) *= -1.0; });
       }},
      {"hammer turned over",
       {"negative|polarity"},
       [](Test& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(0) *= -1.0; });
       }},
      {"sensors exchanged",
       {"swapped|another point|driving point"},
       [](Test& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(1).swap(x.col(2)); });
       }},
      {"sensor turned over in one run",
       {"turned over in these runs"},
       [](Test& t, const Plain&, double) { column(t, 3, 1) *= -1.0; }},
      {"range changed in one run",
       {"was changed for these runs"},
       [](Test& t, const Plain&, double size) {
         column(t, 3, 1) *= between(1.1, 10.0, size);
       }},
      {"range changed from a run on",
       {"was changed for these runs"},
       [](Test& t, const Plain&, double size) {
         for (std::size_t r = 5; r < t.recordings.size(); ++r) {
           column(t, r, 2) *= between(1.1, 10.0, size);
         }
       }},
      {"sensor moved from a run on",
       {"sat at another point"},
       [](Test& t, const Plain& o, double) {
         PlainOptions moved = o;
         moved.sensor_at = {0, 9};
         const SheetAndRecords there = plain_test(moved);
         for (std::size_t r = 5; r < t.recordings.size(); ++r) {
           t.recordings[r].samples.col(2) = there.recordings[r].samples.col(2);
         }
       }},
      {"run of another structure",
       {"another structure"},
       [](Test& t, const Plain& o, double size) {
         t.recordings[4] = other_structure(o, size).recordings[4];
       }},
      {"structure changed in one run",
       {"another state"},
       [](Test& t, const Plain& o, double size) {
         PlainOptions other = o;
         other.stiffer = 1.0 + between(0.005, 0.03, size);
         t.recordings[4] = plain_test(other).recordings[4];
       }},
      {"structure warms up",
       {"fall evenly|rise evenly|another state"},
       [](Test& t, const Plain& o, double size) {
         for (std::size_t r = 0; r < t.recordings.size(); ++r) {
           PlainOptions other = o;
           other.stiffer = 1.0 - between(0.01, 0.05, size) *
                                     static_cast<double>(r) /
                                     static_cast<double>(t.recordings.size());
           t.recordings[r] = plain_test(other).recordings[r];
         }
       }},
      {"run listed twice",
       {"same samples"},
       [](Test& t, const Plain&, double) {
         t.recordings[5] = t.recordings[2];
       }},
      {"time axis reversed",
       {"time axis runs backwards"},
       [](Test& t, const Plain&, double) {
         each_run(t, [](auto& x) {
           const Eigen::MatrixXd y = x.colwise().reverse();
           x = y;
         });
       }},
      {"time axis of one run reversed",
       {"time axis runs backwards"},
       [](Test& t, const Plain&, double) {
         const Eigen::MatrixXd y = t.recordings[2].samples.colwise().reverse();
         t.recordings[2].samples = y;
       }},
      {"hammer and sensor exchanged",
       {"exchanged"},
       [](Test& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(0).swap(x.col(1)); });
       }},
      {"columns in another order",
       {"exchanged"},
       [](Test& t, const Plain&, double) {
         each_run(t, [](auto& x) {
           x.col(0).swap(x.col(1));
           x.col(1).swap(x.col(2));
         });
       }},
      {"times in ms read as s",
       {"milliseconds"},
       [](Test& t, const Plain&, double) {
         for (Recording& r : t.recordings) r.sample_rate_hz /= 512.0;
         t.bundle.band_hz.reset();
       }},
      {"cable off",
       {"noise only"},
       [](Test& t, const Plain& o, double) {
         std::mt19937 engine(o.seed);
         std::normal_distribution<double> normal(0.0, 0.01);
         each_run(t, [&](auto& x) {
           for (Index i = 0; i < x.rows(); ++i) x(i, 1) = normal(engine);
         });
       }},
      {"cable off in one run",
       {"noise only"},
       [](Test& t, const Plain& o, double) {
         std::mt19937 engine(o.seed);
         std::normal_distribution<double> normal(0.0, 0.01);
         for (double& value : column(t, 3, 2)) value = normal(engine);
       }},
      {"hammer without signal",
       {"dead"},
       [](Test& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(0).setZero(); });
       }},
      {"sensor drifts",
       {"zero moves"},
       [](Test& t, const Plain&, double size) {
         each_run(t, [size](auto& x) {
           const double level = std::sqrt(x.col(1).squaredNorm() /
                                          static_cast<double>(x.rows()));
           const double blocks = static_cast<double>(x.rows()) / 4096.0;
           for (Index i = 0; i < x.rows(); ++i) {
             x(i, 1) += between(0.2, 20.0, size) * level * blocks *
                        static_cast<double>(i) / static_cast<double>(x.rows());
           }
         });
       }},
      {"8-bit file",
       {"bits"},
       [](Test& t, const Plain&, double) { t.bits = 8; }},
      {"samples lost",
       {"samples were lost"},
       [](Test& t, const Plain&, double size) {
         const auto count = static_cast<Index>(between(16.0, 200.0, size));
         auto x = t.recordings[1].samples.middleRows(700, count);
         x.rowwise() = Eigen::RowVectorXd(x.row(0));
       }},
      {"samples left out",
       {"jump"},
       [](Test& t, const Plain&, double size) {
         const auto count = static_cast<Index>(between(3.0, 40.0, size));
         auto& x = t.recordings[1].samples;
         const Index rest = x.rows() - 900 - count;
         x.middleRows(900, rest) = x.bottomRows(rest).eval();
       }},
      {"response clipped",
       {"clipped"},
       [](Test& t, const Plain&, double size) {
         each_run(t, [size](auto& x) {
           const double limit =
               x.col(1).cwiseAbs().maxCoeff() * between(0.5, 0.1, size);
           x.col(1) = x.col(1).cwiseMin(limit).cwiseMax(-limit);
         });
       }},
      {"hammer overloaded",
       {"clipped|saturates|ends flat|end flat|overload"},
       [](Test& t, const Plain&, double size) {
         each_run(t, [size](auto& x) {
           const double limit =
               x.col(0).cwiseAbs().maxCoeff() * between(0.5, 0.2, size);
           x.col(0) = x.col(0).cwiseMin(limit);
         });
       }},
      {"trigger within the noise",
       {"within the noise"},
       [](Test& t, const Plain&, double size) {
         t.bundle.trigger_percent = between(0.06, 0.02, size);
       }},
      {"sensor delayed",
       {"behind the hammer"},
       [](Test& t, const Plain&, double size) {
         each_run(t, [size](auto& x) {
           x.col(1) = delayed(x.col(1), between(0.1, 1.5, size));
         });
       }},
      {"velocity for acceleration",
       {"velocity"},
       [](Test& t, const Plain&, double) {
         for (Recording& r : t.recordings) {
           r.samples.col(1) = integrated(r.samples.col(1), r.sample_rate_hz);
         }
       }},
      {"displacement for acceleration",
       {"displacement"},
       [](Test& t, const Plain&, double) {
         for (Recording& r : t.recordings) {
           r.samples.col(1) =
               integrated(integrated(r.samples.col(1), r.sample_rate_hz),
                          r.sample_rate_hz);
         }
       }},
      {"hammer in kN declared N",
       {"a unit"},
       [](Test& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(0) *= 1e-3; });
       }},
      {"one sensor's sensitivity off by 1000",
       {"a unit"},
       [](Test& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(2) *= 1e3; });
       }},
      {"sensors off by a unit",
       {"unit|sensitivities|reads"},
       [](Test& t, const Plain&, double size) {
         const double factors[] = {1.0 / 4.448, 1.0 / 9.81, 1.0 / 25.4};
         const double factor = factors[static_cast<int>(2.99 * size)];
         each_run(t,
                  [factor](auto& x) { x.rightCols(x.cols() - 1) *= factor; });
       }},
      {"one sensor off by a factor",
       {"sensitivities"},
       [](Test& t, const Plain&, double size) {
         each_run(t, [size](auto& x) { x.col(1) *= between(1.1, 10.0, size); });
       }},
      {"point hit is another",
       {"another point|driving point|one point|another one"},
       [](Test& t, const Plain&, double) {
         std::swap(t.bundle.runs[0].hammer, t.bundle.runs[3].hammer);
       }},
  };
}

}  // namespace

SheetAndRecords plain_test(const PlainOptions& options) {
  constexpr int points = 12;
  HungStructure structure = plate(options, points);
  for (int c = 0; c < options.sensors; ++c) {
    const auto at = static_cast<std::size_t>(c);
    structure.sensors.push_back(
        at < options.sensor_at.size()
            ? static_cast<std::size_t>(options.sensor_at[at])
            : at);
  }
  for (int r = 0; r < options.runs; ++r) {
    structure.hits.push_back(static_cast<std::size_t>(r));
  }
  signal::GeneratedOptions o;
  o.hits = 3;
  o.response_noise = 0.02 * options.noise;
  o.force_noise = 0.01 * options.noise;
  o.seed = 100 * options.seed + 1;
  signal::GeneratedTest made = generate_structure(structure, o);
  SheetAndRecords test{std::move(made.bundle), std::move(made.recordings)};
  // The sheet says where they were meant to be.
  for (acquisition::Run& run : test.bundle.runs) {
    for (std::size_t c = 0; c < run.sensors.size(); ++c) {
      run.sensors[c].dof.node = static_cast<int>(c) + 1;
    }
  }
  test.bundle.band_hz = {4.0, 90.0};
  test.bundle.weighed = acquisition::Weighed{mass_kg, {}, 1.0};
  test.bundle.channels.front().unit = "N";
  return test;
}

void write_bundle(const SheetAndRecords& test,
                  const std::filesystem::path& folder) {
  acquisition::TestBundle bundle = test.bundle;
  std::filesystem::create_directories(folder);
  // One range for all runs, half of it used.
  for (std::size_t c = 0; c < bundle.channels.size(); ++c) {
    double peak = 1e-9;
    for (const Recording& r : test.recordings) {
      peak = std::max(
          peak, r.samples.col(static_cast<Index>(c)).cwiseAbs().maxCoeff());
    }
    bundle.channels[c].full_scale_volts = 2.0 * peak;
  }
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    Eigen::MatrixXd samples = test.recordings[r].samples;
    const double steps = std::pow(2.0, test.bits - 1);
    for (std::size_t c = 0; c < bundle.channels.size(); ++c) {
      auto x = samples.col(static_cast<Index>(c));
      x = (x / bundle.channels[c].full_scale_volts * steps).array().round() /
          steps;
    }
    bundle.runs[r].file = "run-" + std::to_string(r + 1) + ".wav";
    acquisition::write_audio(
        folder / bundle.runs[r].file,
        samples,
        static_cast<int>(test.recordings[r].sample_rate_hz),
        acquisition::AudioFormat::Wav24);
  }
  acquisition::write_test_bundle(bundle, folder);
}

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all = all_mistakes();
  return all;
}

}  // namespace tapfit::updating::testing
