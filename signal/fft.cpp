#include "signal/fft.hpp"

#include <fftw3.h>

#include <cassert>
#include <complex>
#include <limits>
#include <mutex>

namespace tapfit::signal {
namespace {

std::mutex& planner_lock() {
  static std::mutex lock;
  return lock;
}

}  // namespace

struct RealFft::Plan {
  explicit Plan(Eigen::Index length)
      : n(length),
        in(fftw_alloc_real(static_cast<std::size_t>(length))),
        out(fftw_alloc_complex(static_cast<std::size_t>(length / 2 + 1))) {
    const std::lock_guard guard(planner_lock());
    handle = fftw_plan_dft_r2c_1d(static_cast<int>(n), in, out, FFTW_ESTIMATE);
  }
  ~Plan() {
    const std::lock_guard guard(planner_lock());
    fftw_destroy_plan(handle);
    fftw_free(out);
    fftw_free(in);
  }
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  Eigen::Index n;
  double* in;
  fftw_complex* out;
  fftw_plan handle = nullptr;
};

RealFft::RealFft(Eigen::Index length) {
  assert(length >= 1 && length <= std::numeric_limits<int>::max());
  plan_ = std::make_unique<Plan>(length);
}

RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

Eigen::Index RealFft::length() const { return plan_->n; }

Eigen::VectorXcd RealFft::transform(
    const Eigen::Ref<const Eigen::VectorXd>& samples) {
  assert(samples.size() <= plan_->n);
  Eigen::Map<Eigen::VectorXd> in(plan_->in, plan_->n);
  in.head(samples.size()) = samples;
  in.tail(plan_->n - samples.size()).setZero();
  fftw_execute(plan_->handle);
  // fftw_complex is laid out as std::complex<double> (FFTW manual 4.1.1).
  return Eigen::Map<const Eigen::VectorXcd>(
      reinterpret_cast<const std::complex<double>*>(plan_->out),
      plan_->n / 2 + 1);
}

void RealFft::transform(const Eigen::Ref<const Eigen::VectorXd>& samples,
                        const Eigen::Ref<const Eigen::VectorXd>& window,
                        Eigen::Index first,
                        Eigen::Ref<Eigen::VectorXcd> lines) {
  assert(samples.size() == plan_->n && window.size() == plan_->n);
  assert(first >= 0 && first + lines.size() <= plan_->n / 2 + 1);
  Eigen::Map<Eigen::VectorXd>(plan_->in, plan_->n) =
      samples.cwiseProduct(window);
  fftw_execute(plan_->handle);
  lines = Eigen::Map<const Eigen::VectorXcd>(
      reinterpret_cast<const std::complex<double>*>(plan_->out) + first,
      lines.size());
}

}  // namespace tapfit::signal
