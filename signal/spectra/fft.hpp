// Discrete Fourier transform of real samples, by FFTW.
//
//   X_k = sum_n x_n exp(-2 pi j k n / N),   k = 0 .. N/2
//
// Source: M. Frigo, S. G. Johnson, "The design and implementation of FFTW3",
// Proc. IEEE 93(2), 2005. The only pair of files that includes fftw3.h.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>

namespace tapfit::signal {

/// A transform of one length, with its plan and its buffers.
///
/// The plans of the last few lengths are kept and shared. Planning is guarded
/// by a lock because FFTW's planner is not thread-safe; one RealFft must not be
/// used by two threads at once. A copy has the same plan and buffers of its
/// own: one for each thread.
class RealFft {
 public:
  /// @param length number of samples N, at least 1; any size, products of
  ///   small primes are fastest
  explicit RealFft(Eigen::Index length);
  ~RealFft();
  RealFft(const RealFft& other);
  RealFft& operator=(const RealFft&) = delete;
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;

  [[nodiscard]] Eigen::Index length() const;

  /// Transform of the samples; missing ones count as zero.
  ///
  /// @param samples up to N real samples
  /// @return N/2 + 1 lines, not scaled
  [[nodiscard]] Eigen::VectorXcd transform(
      const Eigen::Ref<const Eigen::VectorXd>& samples);

  /// The lines first, first + 1, ... of samples times a window.
  ///
  /// @param samples, window N real numbers each
  /// @param lines as many as are wanted, within N/2 + 1
  void transform(const Eigen::Ref<const Eigen::VectorXd>& samples,
                 const Eigen::Ref<const Eigen::VectorXd>& window,
                 Eigen::Index first,
                 Eigen::Ref<Eigen::VectorXcd> lines);

 private:
  class Plan;
  class Plans;
  struct Buffers;
  std::shared_ptr<const Plan> plan_;
  std::unique_ptr<Buffers> buffers_;
};

/// The version of FFTW that is in use.
[[nodiscard]] std::string fft_library();

}  // namespace tapfit::signal
