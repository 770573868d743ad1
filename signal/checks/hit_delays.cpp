#include "signal/checks/hit_delays.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::signal {
namespace {

using complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// Blows by hand fall beside the point and askew: FRFs repeat to that.
constexpr double usual_scatter = 0.02;
// Below this share of |H|^2 explained, the delay is looked for further away.
constexpr double well_explained = 0.9;
// A delay from further away must leave less than this of what a near one does.
constexpr double rather_far = 0.7;
constexpr int rounds = 4;  // of Gauss-Newton, from within half a period
// Of lines that share their noise by fours and fives.
constexpr Index most_search_lines = 1000;

// Re sum w conj(a) b.
double product(const VectorXd& w, const VectorXcd& a, const VectorXcd& b) {
  return (a.conjugate().cwiseProduct(b)).real().dot(w);
}

VectorXcd delayed(const VectorXcd& x, const VectorXd& omega, double tau) {
  VectorXcd y(x.size());
  for (Index l = 0; l < x.size(); ++l) {
    y(l) = x(l) * std::polar(1.0, -omega(l) * tau);
  }
  return y;
}

/// One hit against R.
struct Fitted {
  double gain = 1.0;
  double alike = 0.0;
  VectorXcd left;   // H - g P, P = R exp(-j omega tau)
  VectorXcd slope;  // of g P with tau
};

class Alignment {
 public:
  explicit Alignment(const HitFrfs& of)
      : of_(of),
        w_(of.variance.cwiseInverse()),
        delay_(VectorXd::Zero(of.H.cols())),
        gain_(VectorXd::Ones(of.H.cols())) {}

  [[nodiscard]] const VectorXd& delay() const { return delay_; }
  [[nodiscard]] const VectorXcd& reference() const { return R_; }
  [[nodiscard]] VectorXd weight(Index k) const { return w_.col(k); }

  /// R and factors for the delays as they are.
  void average() {
    for (int i = 0; i < 2; ++i) {
      VectorXcd sum = VectorXcd::Zero(of_.omega.size());
      VectorXd all = VectorXd::Zero(of_.omega.size());
      for (Index k = 0; k < delay_.size(); ++k) add(k, sum, all);
      R_ = sum.cwiseQuotient(all.cast<complex>());
      for (Index k = 0; k < delay_.size(); ++k) gain_(k) = fit(k).gain;
      gain_ /= std::max(gain_.mean(), 1e-30);
    }
  }

  [[nodiscard]] Fitted fit(Index k) const { return fit(k, delay_(k)); }

  /// Each hit against the mean of those before it.
  void look(double most_s) {
    VectorXcd sum = VectorXcd::Zero(of_.omega.size());
    VectorXd all = VectorXd::Zero(of_.omega.size());
    for (Index k = 0; k < delay_.size(); ++k) {
      if (k > 0) {
        R_ = sum.cwiseQuotient(all.cast<complex>());
        delay_(k) = near(k, delay_(k - 1));
        const double likeness = fit(k).alike;
        if (likeness < well_explained) {
          const double far = near(k, search(k, most_s));
          const double left = 1.0 - fit(k, far).alike;
          if (left < rather_far * (1.0 - likeness)) delay_(k) = far;
        }
      }
      add(k, sum, all);
    }
  }

  /// One round of Gauss-Newton for all.
  void refine() {
    average();
    for (Index k = 0; k < delay_.size(); ++k) {
      const Fitted one = fit(k);
      delay_(k) += step(weight(k), one);
    }
    delay_.array() -= delay_.mean();
  }

  [[nodiscard]] double squares() const {
    double sum = 0.0;
    for (Index k = 0; k < delay_.size(); ++k) {
      sum += fit(k).left.cwiseAbs2().dot(w_.col(k));
    }
    return sum;
  }

  // What delay would explain more of what is left.
  static double step(const VectorXd& w, const Fitted& one) {
    const double knows = one.slope.cwiseAbs2().dot(w);
    return knows > 0.0 ? product(w, one.slope, one.left) / knows : 0.0;
  }

 private:
  void add(Index k, VectorXcd& sum, VectorXd& all) const {
    const VectorXd w = w_.col(k);
    sum +=
        gain_(k) * w.cwiseProduct(delayed(of_.H.col(k), of_.omega, -delay_(k)));
    all += gain_(k) * gain_(k) * w;
  }

  [[nodiscard]] Fitted fit(Index k, double tau) const {
    const VectorXd w = w_.col(k);
    const VectorXcd P = delayed(R_, of_.omega, tau);
    const double own = P.cwiseAbs2().dot(w);
    const double common = product(w, P, of_.H.col(k));
    const double size = of_.H.col(k).cwiseAbs2().dot(w);
    Fitted one;
    if (!(own > 0.0) || !(size > 0.0)) {
      one.left = of_.H.col(k);
      one.slope = VectorXcd::Zero(P.size());
      return one;
    }
    // A hit that is turned over has no delay that explains it.
    one.gain = std::max(common / own, 1e-3);
    one.alike = common > 0.0 ? common * common / (own * size) : 0.0;
    one.left = of_.H.col(k) - one.gain * P;
    one.slope =
        complex(0.0, -one.gain) * of_.omega.cast<complex>().cwiseProduct(P);
    return one;
  }

  [[nodiscard]] double near(Index k, double tau) const {
    const VectorXd w = w_.col(k);
    for (int i = 0; i < rounds; ++i) tau += step(w, fit(k, tau));
    return tau;
  }

  // The delay of the largest correlation with R, by quarters of a period of the
  // highest line.
  [[nodiscard]] double search(Index k, double most_s) const {
    const Index stride =
        std::max<Index>(1, of_.omega.size() / most_search_lines);
    const Index lines = (of_.omega.size() - 1) / stride + 1;
    const double quarter =
        0.5 * std::numbers::pi / of_.omega(of_.omega.size() - 1);
    const auto most = static_cast<Index>(most_s / quarter);
    VectorXcd turning(lines);
    VectorXcd turn(lines);
    for (Index i = 0; i < lines; ++i) {
      const Index l = i * stride;
      turn(i) = std::polar(1.0, of_.omega(l) * quarter);
      turning(i) =
          w_(l, k) * std::conj(R_(l)) * of_.H(l, k) *
          std::polar(1.0, -of_.omega(l) * quarter * static_cast<double>(most));
    }
    double best = 0.0;
    double largest = -1.0;
    for (Index i = -most; i <= most; ++i) {
      const double value = turning.real().sum();
      if (value > largest) {
        largest = value;
        best = static_cast<double>(i) * quarter;
      }
      turning = turning.cwiseProduct(turn).eval();
    }
    return best;
  }

  const HitFrfs& of_;
  MatrixXd w_;
  VectorXd delay_;
  VectorXd gain_;
  VectorXcd R_;
};

// Parts of the band that know equally much of a delay: index per line.
std::vector<Index> parts_of(const HitFrfs& of,
                            const VectorXcd& R,
                            Index parts) {
  const VectorXd knows = of.variance.cwiseInverse()
                             .rowwise()
                             .sum()
                             .cwiseProduct(R.cwiseAbs2())
                             .cwiseProduct(of.omega.cwiseAbs2());
  const double all = std::max(knows.sum(), 1e-300);
  std::vector<Index> part(static_cast<std::size_t>(knows.size()));
  double sum = 0.0;
  for (Index l = 0; l < knows.size(); ++l) {
    part[static_cast<std::size_t>(l)] = std::min(
        parts - 1, static_cast<Index>(sum / all * static_cast<double>(parts)));
    sum += knows(l);
  }
  return part;
}

// omega dR/domega, by neighbouring lines.
VectorXcd stretched(const VectorXd& omega, const VectorXcd& R) {
  VectorXcd slope = VectorXcd::Zero(R.size());
  for (Index l = 1; l + 1 < R.size(); ++l) {
    slope(l) = omega(l) * (R(l + 1) - R(l - 1)) / (omega(l + 1) - omega(l - 1));
  }
  return slope;
}

/// Re conj(a) b and |a|^2 summed with weights over each part of the band.
struct PartSums {
  VectorXd ab;
  VectorXd aa;
  VectorXd bb;
  VectorXd lines;
};

PartSums sums_by_part(const std::vector<Index>& part,
                      Index parts,
                      const VectorXd& w,
                      const VectorXcd& a,
                      const VectorXcd& b) {
  PartSums sums{VectorXd::Zero(parts),
                VectorXd::Zero(parts),
                VectorXd::Zero(parts),
                VectorXd::Zero(parts)};
  for (Index l = 0; l < w.size(); ++l) {
    const Index p = part[static_cast<std::size_t>(l)];
    sums.ab(p) += w(l) * (std::conj(a(l)) * b(l)).real();
    sums.aa(p) += w(l) * std::norm(a(l));
    sums.bb(p) += w(l) * std::norm(b(l));
    sums.lines(p) += 1.0;
  }
  return sums;
}

// What lines that move along omega explain where there is no delay.
double moved_squares(const HitFrfs& of, const Alignment& still, Index parts) {
  const VectorXcd& R = still.reference();
  const std::vector<Index> part = parts_of(of, R, parts);
  const VectorXcd slope = stretched(of.omega, R);
  double sum = 0.0;
  for (Index k = 0; k < of.H.cols(); ++k) {
    const PartSums sums =
        sums_by_part(part, parts, still.weight(k), slope, still.fit(k).left);
    for (Index p = 0; p < parts; ++p) {
      if (sums.aa(p) > 0.0) sum += sums.ab(p) * sums.ab(p) / sums.aa(p);
    }
  }
  return sum;
}

// Hits' own share of what R has not taken up.
double freedom(Index hits) {
  const auto n = static_cast<double>(hits);
  return (n - 1.0) / n;
}

void take_parts(const HitFrfs& of,
                const Alignment& aligned,
                Index parts,
                HitDelays& result) {
  const Index hits = of.H.cols();
  const auto lines = static_cast<double>(of.omega.size());
  const std::vector<Index> part = parts_of(of, aligned.reference(), parts);
  result.sd_s.resize(hits);
  result.alike.resize(hits);
  result.parts_s = MatrixXd::Zero(parts, hits);
  result.parts_sd_s = MatrixXd::Zero(parts, hits);
  const double free = freedom(hits);
  for (Index k = 0; k < hits; ++k) {
    const Fitted one = aligned.fit(k);
    result.alike(k) = one.alike;
    const PartSums sums =
        sums_by_part(part, parts, aligned.weight(k), one.slope, one.left);
    // Each line has a real and an imaginary part.
    const double scatter = sums.bb.sum() / (2.0 * lines * free) * of.alike;
    result.sd_s(k) = std::sqrt(scatter / std::max(sums.aa.sum(), 1e-300));
    for (Index p = 0; p < parts; ++p) {
      if (!(sums.aa(p) > 0.0)) continue;
      const double own = sums.bb(p) / (2.0 * sums.lines(p) * free) * of.alike;
      result.parts_s(p, k) = sums.ab(p) / sums.aa(p);
      result.parts_sd_s(p, k) = std::sqrt(own / sums.aa(p));
    }
  }
}

// Whether a first look without delays finds all hits alike and in time.
bool in_time(const Alignment& still, Index hits, double slight_s) {
  VectorXd step(hits);
  for (Index k = 0; k < hits; ++k) {
    const Fitted one = still.fit(k);
    if (one.alike < well_explained) return false;
    step(k) = Alignment::step(still.weight(k), one);
  }
  return step.maxCoeff() - step.minCoeff() < slight_s;
}

}  // namespace

HitFrfs hit_frfs(const GroupSpectra& of, std::size_t sensor) {
  const Eigen::MatrixXcd& F = of.spectra.force;
  const Eigen::MatrixXcd& Y = of.spectra.responses.at(sensor);
  HitFrfs result;
  result.omega = of.s.imag();
  result.H = Y.cwiseQuotient(F);
  // |H|^2 as all hits have it together, so that no line is taken for certain
  // because one hit found little there.
  const VectorXd power = Y.cwiseAbs2().rowwise().sum().cwiseQuotient(
      F.cwiseAbs2().rowwise().sum());
  result.variance.resize(F.rows(), F.cols());
  for (Index k = 0; k < F.cols(); ++k) {
    const LineNoise& noise =
        of.noise[of.noise_of[static_cast<std::size_t>(k)]][sensor];
    result.variance.col(k) = (noise.response + power.cwiseProduct(noise.force))
                                 .cwiseQuotient(F.col(k).cwiseAbs2()) +
                             usual_scatter * usual_scatter * power;
  }
  if (of.s.size() > 1) {
    const double step = of.s(1).imag() - of.s(0).imag();
    result.alike =
        std::max(1.0, of.noise.front()[sensor].bandwidth.mean() / step);
  }
  return result;
}

HitDelays hit_delays(const HitFrfs& of, const HitDelayOptions& options) {
  const Index hits = of.H.cols();
  HitDelays result;
  result.delay_s = VectorXd::Zero(hits);
  if (hits < 2 || of.omega.size() < 2 * options.parts) return result;
  if (!of.H.allFinite() || !(of.variance.minCoeff() > 0.0)) return result;
  Alignment still(of);
  still.average();
  if (in_time(still, hits, options.slight_s)) return result;
  Alignment aligned(of);
  aligned.look(options.most_s);
  for (int i = 0; i < rounds; ++i) aligned.refine();
  aligned.average();
  result.delay_s = aligned.delay();
  result.before = still.squares();
  result.after = aligned.squares();
  result.moved = moved_squares(of, still, options.parts);
  result.expected =
      static_cast<double>(of.omega.size()) * static_cast<double>(hits - 1);
  take_parts(of, aligned, options.parts, result);
  return result;
}

}  // namespace tapfit::signal
