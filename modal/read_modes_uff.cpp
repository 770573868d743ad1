#include "modal/read_modes_uff.hpp"

#include "acquisition/input_error.hpp"
#include "acquisition/uff_datasets.hpp"
#include "modal/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using acquisition::UffDataset;

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr int kNormal = 2;                  // analysis types
constexpr int kComplex = 3;                 // of first order
constexpr std::size_t kLongestHeader = 40;  // lines; more is no header

/// One mode as it stands in the file.
struct Raw {
  Complex pole;
  Complex modal_a;  ///< 0 where the file gives no scale
  std::map<Dof, Complex> shape;
};

/// The lines of a dataset, taken one after the other.
class Lines {
 public:
  explicit Lines(const UffDataset& dataset) : dataset_(dataset) {}

  [[nodiscard]] bool done() const { return next_ >= dataset_.lines.size(); }

  std::string_view take() {
    if (done()) fail("it ends in the middle of a record");
    return dataset_.lines[next_++];
  }

  void skip(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) static_cast<void>(take());
  }

  /// Integers in columns of ten.
  std::vector<int> integers(std::size_t count) {
    std::vector<int> values;
    const std::string_view line = take();
    for (std::size_t k = 0; k < count; ++k) {
      values.push_back(
          acquisition::integer(acquisition::column(line, 10 * k, 10)));
    }
    return values;
  }

  /// Numbers over as many lines as they need.
  std::vector<double> reals(std::size_t count) {
    std::vector<double> values;
    while (values.size() < count) {
      const std::size_t before = values.size();
      if (!acquisition::numbers(take(), 13, values) ||
          values.size() == before) {
        fail("a line of numbers cannot be read");
      }
    }
    const bool finite = std::ranges::all_of(
        values, [](double value) { return std::isfinite(value); });
    if (!finite) fail("a value is not finite");
    return values;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("broken dataset {}: {}", dataset_.type, what),
                     fmt::format("{} and {} lines on", dataset_.place, next_),
                     "write the file again, or leave this mode out");
  }

 private:
  const UffDataset& dataset_;
  std::size_t next_ = 0;
};

struct Header {
  int analysis = 0;
  int result = 0;
  bool complex = false;
  int values = 0;  ///< per node
};

/// Why a dataset holds no mode; empty where it does.
std::string fault(const Header& header) {
  if (header.analysis != kNormal && header.analysis != kComplex) {
    return fmt::format("analysis type {} is no mode", header.analysis);
  }
  if (header.result != 8 && header.result != 12 && header.result != 11) {
    return fmt::format("data type {} is no motion", header.result);
  }
  if (header.values != 3 && header.values != 6) {
    return fmt::format("{} values per node are no motion", header.values);
  }
  return {};
}

void take_eigenvalue(const Header& header,
                     const std::vector<double>& normal,
                     const std::vector<double>& eigenvalue,
                     Raw& raw) {
  if (header.analysis == kNormal) {
    const double omega = kTwoPi * normal[0];
    const double zeta = normal[2] != 0.0 ? normal[2] : 0.5 * normal[3];
    const double damped = omega * std::sqrt(std::max(0.0, 1.0 - zeta * zeta));
    raw.pole = {-zeta * omega, damped};
    raw.modal_a = {0.0, 2.0 * damped * normal[1]};
    return;
  }
  raw.pole = {eigenvalue[0], std::abs(eigenvalue[1])};
  raw.modal_a = {eigenvalue[2], eigenvalue[3]};
}

void take_shape(const Header& header, Lines& lines, Raw& raw) {
  const auto per_node = static_cast<std::size_t>(header.values);
  while (!lines.done()) {
    const int node = lines.integers(1)[0];
    const std::vector<double> parts =
        lines.reals(per_node * (header.complex ? 2 : 1));
    for (std::size_t k = 0; k < per_node; ++k) {
      const Complex value = header.complex
                                ? Complex(parts[2 * k], parts[2 * k + 1])
                                : Complex(parts[k]);
      raw.shape[{node, static_cast<int>(k) + 1, 1}] = value;
    }
  }
}

std::optional<Raw> read_55(const UffDataset& dataset, std::string& why) {
  Lines lines(dataset);
  lines.skip(5);
  const std::vector<int> kind = lines.integers(6);
  const Header header{kind[1], kind[3], kind[4] == 5 || kind[4] == 6, kind[5]};
  why = fault(header);
  if (!why.empty()) return std::nullopt;
  const std::vector<int> counts = lines.integers(2);
  const auto integers = static_cast<std::size_t>(std::max(0, counts[0]));
  const auto reals = static_cast<std::size_t>(std::max(0, counts[1]));
  if (integers > kLongestHeader || reals > kLongestHeader) {
    lines.fail("its counts of integers and reals make no sense");
  }
  if (integers > 6) lines.skip((integers - 6 + 7) / 8);
  std::vector<double> values = lines.reals(reals);
  values.resize(6, 0.0);
  Raw raw;
  take_eigenvalue(header, values, values, raw);
  take_shape(header, lines, raw);
  return raw;
}

std::optional<Raw> read_2414(const UffDataset& dataset, std::string& why) {
  Lines lines(dataset);
  lines.skip(2);
  const int location = lines.integers(1)[0];
  lines.skip(5);
  const std::vector<int> kind = lines.integers(6);
  const Header header{kind[1], kind[3], kind[4] == 5 || kind[4] == 6, kind[5]};
  why = location == 1 ? fault(header) : "its data are not at nodes";
  if (!why.empty()) return std::nullopt;
  lines.skip(2);
  // Time, frequency, eigenvalue, modal mass, viscous and hysteretic damping.
  const std::vector<double> normal = lines.reals(6);
  const std::vector<double> eigenvalue = lines.reals(6);
  Raw raw;
  take_eigenvalue(
      header, {normal[1], normal[3], normal[4], normal[5]}, eigenvalue, raw);
  take_shape(header, lines, raw);
  return raw;
}

/// All modes on the degrees of freedom at which one of them moves.
ModeSet collect(std::vector<Raw>& raws) {
  ModeSet set;
  std::ranges::stable_sort(
      raws, {}, [](const Raw& raw) { return std::abs(raw.pole); });
  std::map<Dof, bool> moves;
  for (const Raw& raw : raws) {
    for (const auto& [dof, value] : raw.shape) {
      moves[dof] = moves[dof] || value != Complex(0.0);
    }
  }
  for (const auto& [dof, moving] : moves) {
    if (moving) set.dofs.push_back(dof);
  }
  set.scaled = std::ranges::all_of(raws, [](const Raw& raw) {
    return std::abs(raw.modal_a) > 0.0 && raw.pole.imag() > 0.0;
  });
  for (const Raw& raw : raws) {
    Mode mode;
    mode.pole = raw.pole;
    const double omega = std::abs(raw.pole);
    mode.frequency_hz = omega / kTwoPi;
    mode.damping_ratio = omega > 0.0 ? -raw.pole.real() / omega : 0.0;
    mode.shape.setZero(static_cast<Eigen::Index>(set.dofs.size()));
    // phi phi' / A is what stays when both are scaled.
    const Complex factor =
        set.scaled
            ? std::sqrt(Complex(0.0, 2.0 * raw.pole.imag()) / raw.modal_a)
            : Complex(1.0);
    for (std::size_t k = 0; k < set.dofs.size(); ++k) {
      const auto found = raw.shape.find(set.dofs[k]);
      if (found == raw.shape.end()) continue;
      mode.shape(static_cast<Eigen::Index>(k)) = factor * found->second;
    }
    mode.mpc = phase_collinearity(mode.shape);
    mode.mpd_deg = mean_phase_deviation(mode.shape);
    set.modes.push_back(std::move(mode));
  }
  return set;
}

}  // namespace

UffModes read_modes_uff_text(const std::string& text, const std::string& name) {
  UffModes result;
  std::vector<Raw> raws;
  for (const UffDataset& dataset : acquisition::split_uff(text, name)) {
    if (dataset.type != 55 && dataset.type != 2414) continue;
    std::string why;
    std::optional<Raw> raw =
        dataset.type == 55 ? read_55(dataset, why) : read_2414(dataset, why);
    if (raw) {
      raws.push_back(std::move(*raw));
    } else {
      result.skipped.push_back(
          fmt::format("{}: dataset {}: {}", dataset.place, dataset.type, why));
    }
  }
  if (raws.empty()) {
    throw InputError(result.skipped.empty()
                         ? std::string("no dataset 55 or 2414 in the file")
                         : "no mode in the file: " + result.skipped.front(),
                     name,
                     "export modes (dataset 55 or 2414, at nodes)");
  }
  result.set = collect(raws);
  return result;
}

UffModes read_modes_uff(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw InputError("cannot be read", file.string(), "check its name");
  }
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  return read_modes_uff_text(text, file.string());
}

}  // namespace tapfit::modal
