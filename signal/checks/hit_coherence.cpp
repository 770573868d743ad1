#include "signal/checks/hit_coherence.hpp"

#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::signal {
namespace {

using Eigen::Index;

constexpr double least_incoherence = 0.005;
constexpr double apart_factor = 5.0;

double pair_coherence(const Eigen::MatrixXcd& F,
                      const Eigen::MatrixXcd& Y,
                      Index i,
                      Index j) {
  double sum = 0.0;
  for (Index line = 0; line < F.rows(); ++line) {
    const std::complex<double> cross =
        Y(line, i) * std::conj(F(line, i)) + Y(line, j) * std::conj(F(line, j));
    const double powers = (std::norm(F(line, i)) + std::norm(F(line, j))) *
                          (std::norm(Y(line, i)) + std::norm(Y(line, j)));
    if (powers > 0.0) sum += std::norm(cross) / powers;
  }
  return sum / static_cast<double>(F.rows());
}

// Mean over sensors of 1 - g^2, hits x hits.
Eigen::MatrixXd incoherence(const HitCoherence& of) {
  const auto n = static_cast<Index>(of.hits.size());
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(n, n);
  for (const Eigen::MatrixXd& pairs : of.pairs)
    mean.array() += 1.0 - pairs.array();
  return of.pairs.empty() ? mean
                          : (mean / static_cast<double>(of.pairs.size()));
}

// Median of a hit's incoherence with those left.
double apart(const Eigen::MatrixXd& u,
             const std::vector<Index>& left,
             Index k) {
  std::vector<double> values;
  for (const Index j : left) {
    if (j != k) values.push_back(u(k, j));
  }
  return acquisition::median(values);
}

double among_others(const Eigen::MatrixXd& u,
                    const std::vector<Index>& left,
                    Index without) {
  std::vector<double> values;
  for (const Index i : left) {
    for (const Index j : left) {
      if (i < j && i != without && j != without) values.push_back(u(i, j));
    }
  }
  return acquisition::median(values);
}

}  // namespace

HitCoherence hit_coherence(const Spectra& spectra) {
  const Index n = spectra.force.cols();
  HitCoherence result;
  if (n < 2) return result;
  const auto sensors = static_cast<Index>(spectra.responses.size());
  result.with_others.resize(sensors, n);
  for (Index c = 0; c < sensors; ++c) {
    const Eigen::MatrixXcd& Y = spectra.responses[static_cast<std::size_t>(c)];
    Eigen::MatrixXd pairs = Eigen::MatrixXd::Identity(n, n);
    for (Index i = 0; i < n; ++i) {
      for (Index j = i + 1; j < n; ++j) {
        pairs(i, j) = pairs(j, i) = pair_coherence(spectra.force, Y, i, j);
      }
    }
    result.with_others.row(c) =
        (pairs.colwise().sum().array() - 1.0) / static_cast<double>(n - 1);
    result.pairs.push_back(std::move(pairs));
  }
  for (Index i = 0; i < n; ++i) {
    result.hits.push_back({0, static_cast<std::size_t>(i)});
  }
  return result;
}

HitCoherence group_coherence(const GroupSpectra& of) {
  if (of.hits.size() < 2) return {};
  HitCoherence result = hit_coherence(of.spectra);
  result.hits = of.hits;
  result.channels = of.channels;
  return result;
}

HitCoherence group_coherence(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const acquisition::RunGroup& group) {
  return group_coherence(group_spectra(bundle, recordings, hits, group));
}

RunCoherence part_of(const HitCoherence& of,
                     const acquisition::TestBundle& bundle,
                     std::size_t run) {
  RunCoherence part;
  std::vector<Index> columns;
  for (std::size_t k = 0; k < of.hits.size(); ++k) {
    if (of.hits[k].run != run) continue;
    part.hits.push_back(of.hits[k].hit);
    columns.push_back(static_cast<Index>(k));
  }
  if (columns.empty()) return part;
  std::vector<Index> rows;
  for (const acquisition::Placement& sensor : bundle.runs[run].sensors) {
    rows.push_back(std::ranges::find(of.channels, sensor.channel) -
                   of.channels.begin());
  }
  part.with_others = of.with_others(rows, columns);
  return part;
}

std::vector<HitAt> hits_apart(const HitCoherence& of) {
  const Eigen::MatrixXd u = incoherence(of);
  std::vector<Index> left;
  for (Index k = 0; k < u.rows(); ++k) left.push_back(k);
  std::vector<HitAt> result;
  while (left.size() > 2) {
    const auto worst =
        std::max_element(left.begin(), left.end(), [&](Index a, Index b) {
          return apart(u, left, a) < apart(u, left, b);
        });
    const double limit = std::max(least_incoherence,
                                  apart_factor * among_others(u, left, *worst));
    if (apart(u, left, *worst) <= limit) break;
    result.push_back(of.hits[static_cast<std::size_t>(*worst)]);
    left.erase(worst);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace tapfit::signal
