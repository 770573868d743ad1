#include "modal/poles/weighted_frfs.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "acquisition/samples/statistics.hpp"
#include "signal/frf_set/set_ups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::modal {
namespace {

constexpr Eigen::Index fewest_lines = 8;
constexpr double smallest = 1e-60;  // its fourth power is still a number
constexpr double model_floor = 0.01;

/// Mean over 2 half + 1 lines, fewer at the ends.
Eigen::VectorXd running_mean(const Eigen::VectorXd& x, Eigen::Index half) {
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(x.size() + 1);
  for (Eigen::Index k = 0; k < x.size(); ++k) sums(k + 1) = sums(k) + x(k);
  Eigen::VectorXd result(x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const Eigen::Index begin = std::max<Eigen::Index>(0, k - half);
    const Eigen::Index end = std::min(x.size(), k + half + 1);
    // A difference of large sums may fall below zero by rounding.
    result(k) = std::max(0.0, sums(end) - sums(begin)) /
                static_cast<double>(end - begin);
  }
  return result;
}

/// Median over 2 half + 1 lines, fewer at the ends; between every quarter of
/// half, where it is taken, a straight line.
Eigen::VectorXd running_median(const Eigen::VectorXd& x, Eigen::Index half) {
  const Eigen::Index n = x.size();
  const Eigen::Index stride = std::max<Eigen::Index>(1, half / 4);
  const auto median = [&](Eigen::Index k) {
    const Eigen::Index begin = std::max<Eigen::Index>(0, k - half);
    const Eigen::Index end = std::min(n, k + half + 1);
    return acquisition::median(x.segment(begin, end - begin));
  };
  Eigen::VectorXd result(n);
  result(0) = median(0);
  for (Eigen::Index last = 0; last < n - 1;) {
    const Eigen::Index next = std::min(n - 1, last + stride);
    result(next) = median(next);
    for (Eigen::Index k = last + 1; k < next; ++k) {
      const double share =
          static_cast<double>(k - last) / static_cast<double>(next - last);
      result(k) = (1.0 - share) * result(last) + share * result(next);
    }
    last = next;
  }
  return result;
}

/// Names the widest step, where a line may be missing.
[[noreturn]] void refuse_spacing(const Eigen::VectorXcd& s) {
  const Eigen::VectorXd hz = s.imag() / (2.0 * std::numbers::pi);
  const Eigen::VectorXd steps = hz.tail(hz.size() - 1) - hz.head(hz.size() - 1);
  Eigen::Index widest = 0;
  steps.maxCoeff(&widest);
  throw InputError(
      "the frequency lines are not evenly spaced on one sigma",
      fmt::format("FRFs, line {}: {:.6g} Hz is followed by {:.6g} Hz",
                  widest + 1,
                  hz(widest),
                  hz(widest + 1)),
      "if a value there could not be read, mend the file or look at a band on "
      "one side of it; else estimate the FRFs on the lines of one block");
}

void check_lines(const Eigen::VectorXcd& s) {
  if (s.size() < fewest_lines) {
    throw InputError(
        fmt::format("only {} frequency lines to identify modes from", s.size()),
        "FRFs",
        "widen the band or lengthen the block so that there are at least 8");
  }
  if (!s.allFinite()) {
    throw InputError("a frequency line is not finite",
                     "FRFs",
                     "check the file the FRFs came from");
  }
  const double sigma = s(0).real();
  const double spacing =
      (s(s.size() - 1) - s(0)).imag() / static_cast<double>(s.size() - 1);
  for (Eigen::Index k = 0; k < s.size(); ++k) {
    const double expected = s(0).imag() + static_cast<double>(k) * spacing;
    if (spacing <= 0.0 || std::abs(s(k).imag() - expected) > 1e-3 * spacing ||
        std::abs(s(k).real() - sigma) > 1e-9 * std::abs(s(s.size() - 1))) {
      refuse_spacing(s);
    }
  }
}

/// As the accelerance of a rigid mass would be, or of a dead channel.
bool is_constant(const signal::Frf& frf) {
  if (frf.H.size() == 0) return true;
  const double change = (frf.H.array() - frf.H(0)).abs().maxCoeff();
  return change <= 1e-9 * frf.H.cwiseAbs().maxCoeff();
}

/// @param others whether there are FRFs that are not constant
bool usable(const signal::Frf& frf,
            Eigen::Index lines,
            bool others,
            std::vector<std::string>& warnings) {
  if (frf.H.size() != lines) {
    throw InputError(fmt::format("{} values on {} lines", frf.H.size(), lines),
                     "FRF " + signal::name(frf),
                     "all FRFs of a set share their lines");
  }
  if (!frf.H.allFinite()) {
    throw InputError("a value is not finite",
                     "FRF " + signal::name(frf),
                     "check the recording behind it, or leave it out");
  }
  const double largest = frf.H.cwiseAbs().maxCoeff();
  if (largest > 0.0 && !(largest > smallest && largest < 1.0 / smallest)) {
    throw InputError(fmt::format("the largest value is {:.1g}", largest),
                     "FRF " + signal::name(frf),
                     "check its unit: no structure has such an accelerance, "
                     "and products of such values are lost");
  }
  if (largest > 0.0 && !(others && is_constant(frf))) return true;
  warnings.push_back("FRF " + signal::name(frf) +
                     (largest > 0.0 ? " is constant" : " is zero throughout") +
                     " and was left out");
  return false;
}

/// Correlation of the noise of lines d apart: that of an exponential window
/// (modal/fit/fit_noise.hpp).
double correlation(double sigma_in_lines, int d) {
  if (sigma_in_lines <= 0.0) return d == 0 ? 1.0 : 0.0;
  const double x = static_cast<double>(d) / (2.0 * sigma_in_lines);
  return 1.0 / (1.0 + x * x);
}

/// Variance from differences of an even order over the lines, as the running
/// median, which a narrow resonance cannot move. The higher the order, the less
/// is added by the curvature of wide ones. The median of |x|^2 is ln 2 of its
/// mean.
///
/// @param sigma_in_lines Re(s) over the lines' spacing
Eigen::VectorXd roughness(const Eigen::VectorXcd& H,
                          int order,
                          double sigma_in_lines) {
  Eigen::VectorXd of_unit = Eigen::VectorXd::Unit(order + 1, 0);
  Eigen::VectorXcd difference = H;
  for (int i = 0; i < order; ++i) {
    of_unit.tail(order) -= of_unit.head(order).eval();
    const Eigen::Index n = difference.size() - 1;
    difference = (difference.tail(n) - difference.head(n)).eval();
  }
  double of_noise = 0.0;
  for (int i = 0; i <= order; ++i) {
    for (int j = 0; j <= order; ++j) {
      of_noise += of_unit(i) * of_unit(j) * correlation(sigma_in_lines, i - j);
    }
  }
  const Eigen::Index n = H.size();
  const Eigen::Index reach = order / 2;
  Eigen::VectorXd power(n);
  power.segment(reach, n - order) = difference.cwiseAbs2();
  power.head(reach).setConstant(power(reach));
  power.tail(reach).setConstant(power(n - 1 - reach));
  const Eigen::Index half = std::max<Eigen::Index>(10, n / 20);
  return running_median(power, half) / (of_noise * std::numbers::ln2);
}

/// What stands for the noise of a FRF without scatter in its weights: curvature
/// included, since a model follows a sharp peak less well than its skirts.
Eigen::VectorXd rough_variance(const Eigen::VectorXcd& H) {
  return roughness(H, 2, 0.0);
}

Eigen::VectorXd clean_variance(const signal::Frf& frf, Eigen::Index lines) {
  if (frf.variance.size() != lines) return Eigen::VectorXd::Zero(lines);
  Eigen::VectorXd variance = frf.variance;
  for (double& value : variance) {
    if (!std::isfinite(value) || value < 0.0) value = 0.0;
  }
  return variance;
}

Eigen::VectorXd weights(const Eigen::VectorXcd& H,
                        const Eigen::VectorXd& variance) {
  const Eigen::Index wide = std::max<Eigen::Index>(4, H.size() / 25);
  const Eigen::VectorXd noise = running_mean(variance, 2);
  const Eigen::VectorXd level = running_mean(H.cwiseAbs2(), wide);
  const double least = 1e-6 * H.cwiseAbs2().mean();
  return (noise + model_floor * model_floor * level)
      .array()
      .max(model_floor * model_floor * least)
      .rsqrt()
      .matrix();
}

/// The same numbers of the same points once more would count as data.
bool is_copy(const signal::Frf& frf,
             const signal::FrfSet& set,
             const std::vector<std::size_t>& kept) {
  return std::ranges::any_of(kept, [&](std::size_t k) {
    const signal::Frf& other = set.frfs[k];
    return other.response == frf.response && other.reference == frf.reference &&
           other.H == frf.H;
  });
}

Dof positive(Dof dof) {
  dof.sign = 1;
  return dof;
}

void sum_up(WeightedFrfs& curves) {
  curves.power = curves.H.colwise().squaredNorm().transpose();
  curves.weights = separate_weights(curves.weight);
  curves.sums = fit_sums(curves.s, curves.H, curves.weights);
}

}  // namespace

WeightedFrfs prepare_frfs(const signal::FrfSet& frfs,
                          std::vector<std::string>& warnings) {
  check_lines(frfs.s);
  // Nothing can be divided by s^2 on the line s = 0.
  const Eigen::Index skip = std::abs(frfs.s(0).imag()) > 0.0 ? 0 : 1;
  const Eigen::Index lines = frfs.lines() - skip;
  const std::vector<std::size_t> set_up = signal::set_ups(frfs);
  WeightedFrfs curves;
  curves.s = frfs.s.tail(lines);
  curves.sigma = curves.s(0).real();
  curves.spacing = (curves.s(lines - 1) - curves.s(0)).imag() /
                   static_cast<double>(lines - 1);
  const bool any = !std::ranges::all_of(frfs.frfs, is_constant);
  for (std::size_t f = 0; f < frfs.frfs.size(); ++f) {
    const signal::Frf& frf = frfs.frfs[f];
    if (!usable(frf, frfs.lines(), any, warnings)) continue;
    if (is_copy(frf, frfs, curves.source)) {
      warnings.push_back("FRF " + signal::name(frf) +
                         " is there twice, to the digit, and counts once");
      continue;
    }
    curves.source.push_back(f);
    curves.response.push_back(positive(frf.response));
    curves.reference.push_back(positive(frf.reference));
    curves.run.push_back(frf.run);
    curves.set_up.push_back(set_up[f]);
  }
  if (curves.source.empty()) {
    throw InputError("no FRF to identify modes from",
                     "FRFs",
                     "accept at least one hit with a response");
  }
  const auto count = static_cast<Eigen::Index>(curves.source.size());
  curves.H.resize(lines, count);
  curves.variance.resize(lines, count);
  curves.weight.resize(lines, count);
  const auto operations = 300.0 * static_cast<double>(curves.H.size());
  const auto pieces = static_cast<std::size_t>(count);
  for_each_parallel(pieces, operations, [&](std::size_t k) {
    const auto f = static_cast<Eigen::Index>(k);
    const signal::Frf& frf =
        frfs.frfs[curves.source[static_cast<std::size_t>(f)]];
    const int sign = frf.response.sign * frf.reference.sign;
    curves.H.col(f) = static_cast<double>(sign) * frf.H.tail(lines);
    curves.variance.col(f) = clean_variance(frf, frfs.lines()).tail(lines);
    Eigen::VectorXd expected = curves.variance.col(f);
    if (frf.hits < 2 || expected.isZero(0.0)) {
      expected = expected.cwiseMax(rough_variance(curves.H.col(f)));
      curves.variance.col(f) = curves.variance.col(f).cwiseMax(
          roughness(curves.H.col(f), 4, curves.sigma / curves.spacing));
    }
    curves.weight.col(f) = weights(curves.H.col(f), expected);
  });
  sum_up(curves);
  return curves;
}

WeightedFrfs select_frfs(const WeightedFrfs& curves,
                         const std::vector<Eigen::Index>& indices) {
  WeightedFrfs part;
  part.s = curves.s;
  part.sigma = curves.sigma;
  part.spacing = curves.spacing;
  part.H = curves.H(Eigen::all, indices);
  part.variance = curves.variance(Eigen::all, indices);
  part.weight = curves.weight(Eigen::all, indices);
  for (const Eigen::Index index : indices) {
    const auto f = static_cast<std::size_t>(index);
    part.response.push_back(curves.response[f]);
    part.reference.push_back(curves.reference[f]);
    part.run.push_back(curves.run[f]);
    part.set_up.push_back(curves.set_up[f]);
    part.source.push_back(curves.source[f]);
  }
  sum_up(part);
  return part;
}

}  // namespace tapfit::modal
