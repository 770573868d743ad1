#include "modal/checks/sensor_patterns.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using complex = std::complex<double>;

// Share of v that is not along u, both of unit length: sin^2 of the angle.
double apart(const VectorXcd& u, const VectorXcd& v) {
  return std::max(1.0 - std::norm(u.dot(v)), 0.0);
}

// How far the patterns of two runs' sensors are from each other: the sine of
// the angle between them, root mean square over modes, weighted by what both
// see of each; noise that is stated is taken off.
double distance(const SensorSetUp& set_up, std::size_t r, std::size_t s) {
  double sum = 0.0;
  double weight = 0.0;
  for (Index k = 0; k < set_up.z[r].cols(); ++k) {
    const double a = set_up.z[r].col(k).norm();
    const double b = set_up.z[s].col(k).norm();
    if (a * b <= 0.0) continue;
    const double noise = 2.0 * (set_up.sd[r].col(k).squaredNorm() / (a * a) +
                                set_up.sd[s].col(k).squaredNorm() / (b * b));
    const VectorXcd u = set_up.z[r].col(k) / a;
    sum += a * b * (apart(u, set_up.z[s].col(k) / b) - noise);
    weight += a * b;
  }
  return weight > 0.0 ? std::sqrt(std::max(sum, 0.0) / weight) : 1.0;
}

// The runs about the one that is nearest to all: those that are as most are, in
// all modes.
std::vector<std::size_t> agreeing_runs(const SensorSetUp& set_up,
                                       const RunResidueLimits& limits) {
  const auto count = static_cast<Index>(set_up.z.size());
  MatrixXd between = MatrixXd::Zero(count, count);
  for (Index r = 0; r < count; ++r) {
    for (Index s = 0; s < r; ++s) {
      between(r, s) = between(s, r) = distance(
          set_up, static_cast<std::size_t>(r), static_cast<std::size_t>(s));
    }
  }
  Index middle = 0;
  between.colwise().sum().minCoeff(&middle);
  const double near = usual_limit(between.col(middle), limits);
  std::vector<std::size_t> agree;
  for (Index r = 0; r < count; ++r) {
    if (between(r, middle) <= near)
      agree.push_back(static_cast<std::size_t>(r));
  }
  return agree;
}

// The pattern over the sensors that these runs show of a mode, strong ones
// first.
VectorXcd common_pattern(const SensorSetUp& set_up,
                         const std::vector<std::size_t>& runs,
                         Index mode) {
  const Index sensors = set_up.z.front().rows();
  MatrixXcd outer = MatrixXcd::Zero(sensors, sensors);
  for (const std::size_t r : runs) {
    const VectorXcd v = set_up.z[r].col(mode);
    outer += v * v.adjoint();
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXcd> eigen(outer);
  return eigen.eigenvectors().col(sensors - 1);
}

// Relative error of z against the patterns, each mode with its own amplitude;
// noise that is stated is taken off.
double pattern_error(const MatrixXcd& z,
                     const MatrixXd& sd,
                     const MatrixXcd& patterns) {
  double rest = 0.0;
  double all = 0.0;
  for (Index k = 0; k < z.cols(); ++k) {
    const VectorXcd u = patterns.col(k).normalized();
    const complex q = u.dot(z.col(k));
    rest += (z.col(k) - q * u).squaredNorm() - 2.0 * sd.col(k).squaredNorm();
    all += z.col(k).squaredNorm();
  }
  return std::sqrt(std::max(rest, 0.0) / std::max(all, 1e-300));
}

/// What the others' amplitudes let a sensor see of each mode.
struct Predicted {
  VectorXcd seen;
  VectorXd sd;  ///< of what is seen beside it, the others' included
};

Predicted predict(Index sensor,
                  const MatrixXcd& z,
                  const MatrixXd& sd,
                  const MatrixXcd& patterns) {
  Predicted by{VectorXcd::Zero(z.cols()), VectorXd::Zero(z.cols())};
  for (Index k = 0; k < z.cols(); ++k) {
    VectorXcd others = patterns.col(k);
    const complex own = others(sensor);
    others(sensor) = 0.0;
    const double size = others.squaredNorm();
    if (size < 1e-6) continue;  // only this sensor sees the mode
    by.seen(k) = own * others.dot(z.col(k)) / size;
    by.sd(k) = std::hypot(
        sd(sensor, k), std::abs(own) / size * others.cwiseAbs().dot(sd.col(k)));
  }
  return by;
}

// The factor on one sensor that the others' amplitudes ask for.
complex factor_on(Index sensor, const MatrixXcd& z, const VectorXcd& seen) {
  const double square = seen.squaredNorm();
  return square > 0.0 ? seen.dot(z.row(sensor).transpose()) / square
                      : complex(1.0);
}

// How far the modes, each by itself, ask for that factor.
void compare_modes(const MatrixXcd& z,
                   const Predicted& by,
                   const RunResidueLimits& limits,
                   SensorPattern& found) {
  constexpr double tells = 0.1;
  double sum = 0.0;
  for (Index k = 0; k < z.cols(); ++k) {
    const double size = std::abs(found.factor * by.seen(k));
    if (size <= 0.0 || by.sd(k) > tells * size) continue;
    const complex own = z(static_cast<Index>(found.sensor), k);
    const double sd = std::hypot(by.sd(k), limits.much * size);
    sum += std::norm(own - found.factor * by.seen(k)) / (sd * sd);
    ++found.modes;
  }
  found.scatter = std::sqrt(sum / std::max(found.modes, 1));
}

/// A run's modal constants with one law of one sensor taken off.
struct Corrected {
  MatrixXcd z;
  MatrixXd sd;
};

Corrected without(const MatrixXcd& z,
                  const MatrixXd& sd,
                  Index sensor,
                  const VectorXcd& factors) {
  Corrected result{z, sd};
  result.z.row(sensor).array() /= factors.transpose().array();
  result.sd.row(sensor).array() /= factors.cwiseAbs().transpose().array();
  return result;
}

class RunPattern {
 public:
  RunPattern(const SensorSetUp& set_up,
             std::size_t run,
             const MatrixXcd& patterns,
             const RunResidueLimits& limits)
      : z_(set_up.z[run]),
        sd_(set_up.sd[run]),
        poles_(set_up.poles),
        patterns_(patterns),
        limits_(limits) {
    plain_.error = pattern_error(z_, sd_, patterns_);
    plain_.noise = std::numbers::sqrt2 * sd_.norm() / z_.norm();
    plain_.left = plain_.error;
  }

  // One factor on one sensor, unless another law says far more.
  [[nodiscard]] SensorPattern best() const {
    SensorPattern found = plain_;
    for (Index c = 0; c < z_.rows(); ++c) {
      const SensorPattern tried = with(c, {});
      if (tried.left < found.left) found = tried;
    }
    found.modes = 0;
    compare(found);
    SensorPattern by_law = found;
    by_law.left *= limits_.one_factor;
    for (Index c = 0; c < z_.rows(); ++c) {
      const VectorXcd seen = predict(c, z_, sd_, patterns_).seen;
      for (const SensorLaw& law :
           laws_that_explain(z_.row(c).transpose(), seen, poles_)) {
        SensorPattern tried = with(c, law);
        if (tried.left >= by_law.left) continue;
        compare(tried);
        if (is_told(tried)) by_law = tried;
      }
    }
    return by_law.law.is_plain() ? found : by_law;
  }

 private:
  // Amplifiers have no phase, and what is late is as large as before: a sensor
  // at another point is, mode by mode, neither.
  [[nodiscard]] bool is_told(const SensorPattern& p) const {
    constexpr double most_phase = 0.2;
    constexpr double as_large = 0.1;
    const bool late = p.law.power == 0;
    const bool real =
        std::abs(p.factor.imag()) <= most_phase * std::abs(p.factor.real());
    return p.scatter <= limits_.scatter &&
           (late ? p.modes >= 2 && std::abs(p.factor - 1.0) <= as_large
                 : p.modes >= limits_.fewest_modes_of_law && real);
  }

  [[nodiscard]] SensorPattern with(Index sensor, const SensorLaw& law) const {
    SensorPattern tried = plain_;
    const VectorXcd shape = law.factors(poles_);
    const Corrected by_law = without(z_, sd_, sensor, shape);
    const complex factor = factor_on(
        sensor, by_law.z, predict(sensor, by_law.z, by_law.sd, patterns_).seen);
    if (std::abs(factor) < 1e-6) return tried;
    const Corrected all = without(z_, sd_, sensor, factor * shape);
    tried.left = pattern_error(all.z, all.sd, patterns_);
    tried.sensor = static_cast<std::size_t>(sensor);
    tried.factor = factor;
    tried.law = law;
    return tried;
  }

  void compare(SensorPattern& found) const {
    const auto sensor = static_cast<Index>(found.sensor);
    const Corrected by_law =
        without(z_, sd_, sensor, found.law.factors(poles_));
    compare_modes(by_law.z,
                  predict(sensor, by_law.z, by_law.sd, patterns_),
                  limits_,
                  found);
  }

  const MatrixXcd& z_;
  const MatrixXd& sd_;
  const VectorXcd& poles_;
  const MatrixXcd& patterns_;
  const RunResidueLimits& limits_;
  SensorPattern plain_;
};

}  // namespace

double usual_limit(VectorXd errors, const RunResidueLimits& limits) {
  std::ranges::sort(errors);
  return std::max(limits.much, limits.times_usual * errors(errors.size() / 4));
}

std::vector<SensorPattern> compare_patterns(const SensorSetUp& set_up,
                                            const RunResidueLimits& limits) {
  MatrixXcd patterns(set_up.z.front().rows(), set_up.z.front().cols());
  const std::vector<std::size_t> usual = agreeing_runs(set_up, limits);
  for (Index k = 0; k < patterns.cols(); ++k) {
    patterns.col(k) = common_pattern(set_up, usual, k);
  }
  std::vector<SensorPattern> of;
  for (std::size_t r = 0; r < set_up.runs.size(); ++r) {
    of.push_back(RunPattern(set_up, r, patterns, limits).best());
  }
  return of;
}

}  // namespace tapfit::modal
