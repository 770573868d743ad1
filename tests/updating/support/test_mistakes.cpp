#include "tests/updating/support/test_mistakes.hpp"

#include "tests/updating/support/resampled.hpp"
#include "tests/updating/support/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace tapfit::updating::testing {
namespace {

using acquisition::Recording;
using Eigen::Index;
using Eigen::VectorXd;
using Sheet = SheetAndRecords;
using Plain = PlainOptions;

Eigen::Ref<VectorXd> column(SheetAndRecords& test, std::size_t run, Index c) {
  return test.recordings[run].samples.col(c);
}

void each_run(SheetAndRecords& test,
              const std::function<void(Eigen::MatrixXd&)>& change) {
  for (Recording& recording : test.recordings) change(recording.samples);
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

// Of channels that are turned over, exchanged or moved.
std::vector<Mistake> sensor_mistakes() {
  return {
      {"sensor turned over",
       {"polarity"},
       [](Sheet& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(1) *= -1.0; });
       }},
      {"hammer turned over",
       {"negative|polarity"},
       [](Sheet& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(0) *= -1.0; });
       }},
      {"sensors exchanged",
       {"swapped|another point|driving point"},
       [](Sheet& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(1).swap(x.col(2)); });
       }},
      {"sensor turned over in one run",
       {"turned over in these runs"},
       [](Sheet& t, const Plain&, double) { column(t, 3, 1) *= -1.0; }},
      {"range changed in one run",
       {"was changed for these runs"},
       [](Sheet& t, const Plain&, double size) {
         column(t, 3, 1) *= between(1.1, 10.0, size);
       }},
      {"range changed from a run on",
       {"was changed for these runs"},
       [](Sheet& t, const Plain&, double size) {
         for (std::size_t r = 5; r < t.recordings.size(); ++r) {
           column(t, r, 2) *= between(1.1, 10.0, size);
         }
       }},
      {"sensor moved from a run on",
       {"sat at another point"},
       [](Sheet& t, const Plain& o, double) {
         PlainOptions moved = o;
         moved.sensor_at = {0, 9};
         const SheetAndRecords there = plain_test(moved);
         for (std::size_t r = 5; r < t.recordings.size(); ++r) {
           t.recordings[r].samples.col(2) = there.recordings[r].samples.col(2);
         }
       }},
  };
}

// Of runs that are others, and of orders in time and in the file.
std::vector<Mistake> run_mistakes() {
  return {
      {"run of another structure",
       {"another structure"},
       [](Sheet& t, const Plain& o, double size) {
         t.recordings[4] = other_structure(o, size).recordings[4];
       }},
      {"structure changed in one run",
       {"another state"},
       [](Sheet& t, const Plain& o, double size) {
         PlainOptions other = o;
         other.stiffer = 1.0 + between(0.005, 0.03, size);
         t.recordings[4] = plain_test(other).recordings[4];
       }},
      {"structure warms up",
       {"fall evenly|rise evenly|another state"},
       [](Sheet& t, const Plain& o, double size) {
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
       [](Sheet& t, const Plain&, double) {
         t.recordings[5] = t.recordings[2];
       }},
      {"time axis reversed",
       {"time axis runs backwards"},
       [](Sheet& t, const Plain&, double) {
         each_run(t, [](auto& x) {
           const Eigen::MatrixXd y = x.colwise().reverse();
           x = y;
         });
       }},
      {"time axis of one run reversed",
       {"time axis runs backwards"},
       [](Sheet& t, const Plain&, double) {
         const Eigen::MatrixXd y = t.recordings[2].samples.colwise().reverse();
         t.recordings[2].samples = y;
       }},
      {"hammer and sensor exchanged",
       {"exchanged"},
       [](Sheet& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(0).swap(x.col(1)); });
       }},
      {"columns in another order",
       {"exchanged"},
       [](Sheet& t, const Plain&, double) {
         each_run(t, [](auto& x) {
           x.col(0).swap(x.col(1));
           x.col(1).swap(x.col(2));
         });
       }},
  };
}

// Of the clock, the cables and the front end.
std::vector<Mistake> signal_mistakes() {
  return {
      {"times in ms read as s",
       {"milliseconds"},
       [](Sheet& t, const Plain&, double) {
         for (Recording& r : t.recordings) r.sample_rate_hz /= 512.0;
         t.bundle.band_hz.reset();
       }},
      {"cable off",
       {"noise only"},
       [](Sheet& t, const Plain& o, double) {
         std::mt19937 engine(o.seed);
         std::normal_distribution<double> normal(0.0, 0.01);
         each_run(t, [&](auto& x) {
           for (Index i = 0; i < x.rows(); ++i) x(i, 1) = normal(engine);
         });
       }},
      {"cable off in one run",
       {"noise only"},
       [](Sheet& t, const Plain& o, double) {
         std::mt19937 engine(o.seed);
         std::normal_distribution<double> normal(0.0, 0.01);
         for (double& value : column(t, 3, 2)) value = normal(engine);
       }},
      {"hammer without signal",
       {"dead"},
       [](Sheet& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(0).setZero(); });
       }},
      {"sensor drifts",
       {"zero moves"},
       [](Sheet& t, const Plain&, double size) {
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
       [](Sheet& t, const Plain&, double) { t.bits = 8; }},
  };
}

// From the third hit of a run on, as plain_test() times it.
void late_from_last_hit(Eigen::Ref<VectorXd> x, double samples) {
  const Index rest = x.size() - (600 + 2 * 4096 - 200);
  x.tail(rest) = resampled(x, -samples, 1.0).bottomRows(rest);
}

// Of samples that are lost, clipped or late.
std::vector<Mistake> sample_mistakes() {
  return {
      {"samples lost",
       {"samples were lost"},
       [](Sheet& t, const Plain&, double size) {
         const auto count = static_cast<Index>(between(16.0, 200.0, size));
         auto x = t.recordings[1].samples.middleRows(700, count);
         x.rowwise() = Eigen::RowVectorXd(x.row(0));
       }},
      {"samples left out",
       {"jump"},
       [](Sheet& t, const Plain&, double size) {
         const auto count = static_cast<Index>(between(3.0, 40.0, size));
         auto& x = t.recordings[1].samples;
         const Index rest = x.rows() - 900 - count;
         x.middleRows(900, rest) = x.bottomRows(rest).eval();
       }},
      {"response clipped",
       {"clipped"},
       [](Sheet& t, const Plain&, double size) {
         each_run(t, [size](auto& x) {
           const double limit =
               x.col(1).cwiseAbs().maxCoeff() * between(0.5, 0.1, size);
           x.col(1) = x.col(1).cwiseMin(limit).cwiseMax(-limit);
         });
       }},
      {"hammer overloaded",
       {"clipped|saturates|ends flat|end flat|overload"},
       [](Sheet& t, const Plain&, double size) {
         each_run(t, [size](auto& x) {
           const double limit =
               x.col(0).cwiseAbs().maxCoeff() * between(0.5, 0.2, size);
           x.col(0) = x.col(0).cwiseMin(limit);
         });
       }},
      {"trigger within the noise",
       {"within the noise"},
       [](Sheet& t, const Plain& o, double size) {
         t.bundle.trigger_percent =
             std::min(o.noise, 1.0) * between(0.06, 0.02, size);
       }},
      {"sensor delayed",
       {"behind the hammer|lags behind"},
       [](Sheet& t, const Plain&, double size) {
         each_run(t, [size](auto& x) {
           x.col(1) = resampled(x.col(1), -between(0.1, 1.5, size), 1.0);
         });
       }},
      {"sensor delayed from a hit on",
       {"in the hits before"},
       [](Sheet& t, const Plain&, double size) {
         late_from_last_hit(column(t, 2, 2), between(0.3, 3.0, size));
       }},
      {"hammer delayed from a hit on",
       {"against all sensors"},
       [](Sheet& t, const Plain&, double size) {
         late_from_last_hit(column(t, 2, 0), between(0.3, 3.0, size));
       }},
  };
}

// Of what is measured and of its unit.
std::vector<Mistake> unit_mistakes() {
  return {
      {"velocity for acceleration",
       {"velocity"},
       [](Sheet& t, const Plain&, double) {
         for (Recording& r : t.recordings) {
           r.samples.col(1) = integrated(r.samples.col(1), r.sample_rate_hz);
         }
       }},
      {"displacement for acceleration",
       {"displacement"},
       [](Sheet& t, const Plain&, double) {
         for (Recording& r : t.recordings) {
           r.samples.col(1) =
               integrated(integrated(r.samples.col(1), r.sample_rate_hz),
                          r.sample_rate_hz);
         }
       }},
      {"hammer in kN declared N",
       {"a unit"},
       [](Sheet& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(0) *= 1e-3; });
       }},
      {"one sensor's sensitivity off by 1000",
       {"a unit"},
       [](Sheet& t, const Plain&, double) {
         each_run(t, [](auto& x) { x.col(2) *= 1e3; });
       }},
      {"sensors off by a unit",
       {"unit|sensitivities|reads"},
       [](Sheet& t, const Plain&, double size) {
         const double factors[] = {1.0 / 4.448, 1.0 / 9.81, 1.0 / 25.4};
         const double factor = factors[static_cast<int>(2.99 * size)];
         each_run(t,
                  [factor](auto& x) { x.rightCols(x.cols() - 1) *= factor; });
       }},
      {"one sensor off by a factor",
       {"sensitivities"},
       [](Sheet& t, const Plain&, double size) {
         each_run(t, [size](auto& x) { x.col(1) *= between(1.1, 10.0, size); });
       }},
      {"point hit is another",
       {"another point|driving point|one point|another one"},
       [](Sheet& t, const Plain&, double) {
         std::swap(t.bundle.runs[0].hammer, t.bundle.runs[3].hammer);
       }},
  };
}

}  // namespace

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all = [] {
    std::vector<Mistake> joined;
    for (const auto& part : {sensor_mistakes(),
                             run_mistakes(),
                             signal_mistakes(),
                             sample_mistakes(),
                             unit_mistakes()}) {
      joined.insert(joined.end(), part.begin(), part.end());
    }
    return joined;
  }();
  return all;
}

}  // namespace tapfit::updating::testing
