#include "signal/spectra/spectra.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "signal/spectra/window.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::signal {
namespace {

using Eigen::Index;

constexpr Index chunk = 1024;

Eigen::MatrixXcd fft_columns(const RealFft& planned,
                             const Eigen::MatrixXd& blocks,
                             const Eigen::VectorXd& window,
                             Index first,
                             Index last) {
  RealFft fft = planned;  // buffers of this thread
  Eigen::MatrixXcd result(last - first + 1, blocks.cols());
  for (Index k = 0; k < blocks.cols(); ++k) {
    fft.transform(blocks.col(k), window, first, result.col(k));
  }
  return result;
}

// Real and imaginary part of exp(-s t) for rows [begin, begin + n).
struct Kernel {
  Eigen::MatrixXd real;  // lines x n
  Eigen::MatrixXd imag;
};

Kernel kernel(const Eigen::VectorXcd& s, double dt, Index row, Index n) {
  Kernel e{Eigen::MatrixXd(s.size(), n), Eigen::MatrixXd(s.size(), n)};
  const Eigen::VectorXcd step = (-s * dt).array().exp().matrix();
  // Started anew for every chunk, so that rounding grows over 1024 factors
  // at most, to about 1e-13.
  Eigen::VectorXcd value =
      (-s * (dt * static_cast<double>(row))).array().exp().matrix();
  for (Index i = 0; i < n; ++i) {
    e.real.col(i) = value.real();
    e.imag.col(i) = value.imag();
    value.array() *= step.array();
  }
  return e;
}

void accumulate(const Kernel& e,
                const Eigen::Ref<const Eigen::MatrixXd>& x,
                Eigen::MatrixXcd& sum) {
  const Eigen::MatrixXd real = e.real * x;
  const Eigen::MatrixXd imag = e.imag * x;
  sum.real() += real;
  sum.imag() += imag;
}

// Completes the transforms by what follows behind the blocks.
//
// kernel: exp(-s t) at the blocks' end
void add_tails(const HitBlocks& blocks,
               const Eigen::VectorXcd& s,
               const Eigen::VectorXcd& kernel,
               Spectra& spectra) {
  for (std::size_t c = 0; c < blocks.tails.size(); ++c) {
    if (blocks.tails[c].poles.size() == 0) continue;
    spectra.responses[c] += tail_spectra(blocks.tails[c], s, kernel, blocks.dt);
  }
}

// From trigger to the blocks' end [s].
double seconds_of(const HitBlocks& blocks) {
  return static_cast<double>(blocks.force.rows() - blocks.trigger) * blocks.dt;
}

Eigen::MatrixXcd side_by_side(const std::vector<const Eigen::MatrixXcd*>& all) {
  Index columns = 0;
  for (const Eigen::MatrixXcd* one : all) columns += one->cols();
  Eigen::MatrixXcd result(all.front()->rows(), columns);
  Index at = 0;
  for (const Eigen::MatrixXcd* one : all) {
    result.middleCols(at, one->cols()) = *one;
    at += one->cols();
  }
  return result;
}

}  // namespace

Spectra side_by_side(std::vector<Spectra> runs) {
  std::erase_if(runs, [](const Spectra& run) { return run.force.cols() == 0; });
  if (runs.empty()) return {};
  if (runs.size() == 1) return std::move(runs.front());
  const auto joined = [&](const auto& of) {
    std::vector<const Eigen::MatrixXcd*> all;
    for (const Spectra& run : runs) all.push_back(&of(run));
    return side_by_side(all);
  };
  Spectra result;
  result.force = joined([](const Spectra& run) -> auto& { return run.force; });
  for (std::size_t c = 0; c < runs.front().responses.size(); ++c) {
    result.responses.push_back(
        joined([c](const Spectra& run) -> auto& { return run.responses[c]; }));
  }
  return result;
}

Spectra fft_spectra(const HitBlocks& blocks,
                    const RealFft& fft,
                    double sigma,
                    Index first,
                    Index last) {
  const Index n = blocks.force.rows();
  const Eigen::VectorXd window =
      exponential_window(n, blocks.trigger, blocks.dt, sigma);
  Spectra result;
  result.responses.resize(blocks.responses.size());
  for_each_parallel(blocks.responses.size() + 1, [&](std::size_t c) {
    if (c == 0) {
      result.force = fft_columns(fft, blocks.force, window, first, last);
    } else {
      result.responses[c - 1] =
          fft_columns(fft, blocks.responses[c - 1], window, first, last);
    }
  });
  // The FFT counts from the block's begin: j omega turns by whole circles.
  const double step =
      2.0 * std::numbers::pi / (static_cast<double>(n) * blocks.dt);
  Eigen::VectorXcd s(last - first + 1);
  s.real().setConstant(sigma);
  s.imag().setLinSpaced(step * static_cast<double>(first),
                        step * static_cast<double>(last));
  add_tails(blocks,
            s,
            Eigen::VectorXcd::Constant(s.size(),
                                       std::exp(-sigma * seconds_of(blocks))),
            result);
  return result;
}

Spectra spectra_at(const HitBlocks& blocks, const Eigen::VectorXcd& s) {
  const Index n = blocks.force.rows();
  const Index hits = blocks.force.cols();
  const double sigma = s.size() == 0 ? 0.0 : s.real().minCoeff();
  const double needed =
      sigma > 0.0 ? 27.6 / (sigma * blocks.dt) : static_cast<double>(n);
  const Index end = std::clamp(
      blocks.trigger +
          static_cast<Index>(std::min(needed, static_cast<double>(n))),
      std::min(n, blocks.force_end),
      n);
  // All sensors side by side, so that one product serves them.
  const Index sensors = static_cast<Index>(blocks.responses.size());
  Eigen::MatrixXcd force = Eigen::MatrixXcd::Zero(s.size(), hits);
  Eigen::MatrixXcd responses = Eigen::MatrixXcd::Zero(s.size(), hits * sensors);
  for (Index row = 0; row < end; row += chunk) {
    const Index rows = std::min(chunk, end - row);
    const Kernel e = kernel(s, blocks.dt, row - blocks.trigger, rows);
    Eigen::MatrixXd x(rows, hits * sensors);
    for (Index c = 0; c < sensors; ++c)
      x.middleCols(c * hits, hits) =
          blocks.responses[static_cast<std::size_t>(c)].middleRows(row, rows);
    accumulate(e, x, responses);
    if (row < blocks.force_end)
      accumulate(e, blocks.force.middleRows(row, rows), force);
  }
  Spectra result;
  result.force = std::move(force);
  for (Index c = 0; c < sensors; ++c)
    result.responses.emplace_back(responses.middleCols(c * hits, hits));
  add_tails(
      blocks, s, (-s * seconds_of(blocks)).array().exp().matrix(), result);
  return result;
}

}  // namespace tapfit::signal
