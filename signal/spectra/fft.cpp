#include "signal/spectra/fft.hpp"

#include "acquisition/foundation/cache_folder.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/output_file.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cassert>
#include <complex>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <mutex>
#include <string>
#include <system_error>
#include <vector>

namespace tapfit::signal {
namespace {

namespace fs = std::filesystem;

std::mutex& planner_lock() {
  static std::mutex lock;
  return lock;
}

// What FFTW has learnt about planning, kept from one run of the program to the
// next. Never an error: a file that is damaged or of another FFTW teaches
// nothing, and where nothing can be written nothing is kept.
class Wisdom {
 public:
  Wisdom() {
    const auto folder = acquisition::cache_folder();
    if (!folder) return;
    file_ = *folder / "fftw-wisdom";
    // Reading more takes as long as planning anew.
    constexpr std::uintmax_t most = 1 << 14;
    std::error_code none;
    if (fs::file_size(file_, none) > most || none) return;
    fftw_import_wisdom_from_filename(file_.c_str());
    known_ = words();
  }
  ~Wisdom() {
    if (file_.empty() || words() == known_) return;
    std::error_code fault;
    fs::create_directories(file_.parent_path(), fault);
    try {
      acquisition::write_file(file_, words(), {{}, true});
    } catch (const InputError&) {
      // Where nothing can be written nothing is kept.
    }
  }
  Wisdom(const Wisdom&) = delete;
  Wisdom& operator=(const Wisdom&) = delete;

 private:
  static std::string words() {
    char* text = fftw_export_wisdom_to_string();
    std::string result = text == nullptr ? "" : text;
    std::free(text);
    return result;
  }

  fs::path file_;  ///< empty: none is kept
  std::string known_;
};

}  // namespace

struct RealFft::Buffers {
  explicit Buffers(Eigen::Index n)
      : in(fftw_alloc_real(static_cast<std::size_t>(n))),
        out(fftw_alloc_complex(static_cast<std::size_t>(n / 2 + 1))) {}
  ~Buffers() {
    fftw_free(out);
    fftw_free(in);
  }
  Buffers(const Buffers&) = delete;
  Buffers& operator=(const Buffers&) = delete;

  // fftw_complex is laid out as std::complex<double> (FFTW manual 4.1.1).
  [[nodiscard]] const std::complex<double>* lines() const {
    return reinterpret_cast<const std::complex<double>*>(out);
  }

  double* in;
  fftw_complex* out;
};

class RealFft::Plan {
 public:
  Plan(Eigen::Index length, const Buffers& buffers) : n(length) {
    const std::lock_guard guard(planner_lock());
    handle_ = fftw_plan_dft_r2c_1d(
        static_cast<int>(n), buffers.in, buffers.out, FFTW_ESTIMATE);
  }
  ~Plan() {
    const std::lock_guard guard(planner_lock());
    fftw_destroy_plan(handle_);
  }
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  // Any buffers of fftw_alloc are aligned as those of the planning were.
  void execute(const Buffers& buffers) const {
    fftw_execute_dft_r2c(handle_, buffers.in, buffers.out);
  }

  Eigen::Index n;

 private:
  fftw_plan handle_ = nullptr;
};

/// The latest plans; planning takes as long as some ten transforms.
class RealFft::Plans {
 public:
  std::shared_ptr<const Plan> plan(Eigen::Index length,
                                   const Buffers& buffers) {
    // Whoever else wants the same length waits for it.
    const std::lock_guard guard(lock_);
    auto found = std::ranges::find(
        latest_, length, [](const auto& plan) { return plan->n; });
    if (found == latest_.end()) {
      if (latest_.size() == most) latest_.pop_back();
      found = latest_.insert(latest_.end(),
                             std::make_shared<const Plan>(length, buffers));
    }
    std::rotate(latest_.begin(), found, found + 1);
    return latest_.front();
  }

  static Plans& all() {
    static Plans plans;
    return plans;
  }

 private:
  // Blocks, their halves and segments, stretches of noise: twice that.
  static constexpr std::size_t most = 8;

  std::mutex lock_;
  Wisdom wisdom_;
  std::vector<std::shared_ptr<const Plan>> latest_;  ///< the last one first
};

RealFft::RealFft(Eigen::Index length) {
  assert(length >= 1 && length <= std::numeric_limits<int>::max());
  buffers_ = std::make_unique<Buffers>(length);
  plan_ = Plans::all().plan(length, *buffers_);
}

RealFft::RealFft(const RealFft& other)
    : plan_(other.plan_), buffers_(std::make_unique<Buffers>(plan_->n)) {}

RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

Eigen::Index RealFft::length() const { return plan_->n; }

Eigen::VectorXcd RealFft::transform(
    const Eigen::Ref<const Eigen::VectorXd>& samples) {
  assert(samples.size() <= plan_->n);
  Eigen::Map<Eigen::VectorXd> in(buffers_->in, plan_->n);
  in.head(samples.size()) = samples;
  in.tail(plan_->n - samples.size()).setZero();
  plan_->execute(*buffers_);
  return Eigen::Map<const Eigen::VectorXcd>(buffers_->lines(),
                                            plan_->n / 2 + 1);
}

void RealFft::transform(const Eigen::Ref<const Eigen::VectorXd>& samples,
                        const Eigen::Ref<const Eigen::VectorXd>& window,
                        Eigen::Index first,
                        Eigen::Ref<Eigen::VectorXcd> lines) {
  assert(samples.size() == plan_->n && window.size() == plan_->n);
  assert(first >= 0 && first + lines.size() <= plan_->n / 2 + 1);
  Eigen::Map<Eigen::VectorXd>(buffers_->in, plan_->n) =
      samples.cwiseProduct(window);
  plan_->execute(*buffers_);
  lines = Eigen::Map<const Eigen::VectorXcd>(buffers_->lines() + first,
                                             lines.size());
}

std::string fft_library() {
  const std::string name = fftw_version;  // "fftw-3.3.10-sse2-avx"
  const std::size_t begin = name.find('-') + 1;
  return name.substr(begin, name.find('-', begin) - begin);
}

}  // namespace tapfit::signal
