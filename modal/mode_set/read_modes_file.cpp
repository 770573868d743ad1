#include "modal/mode_set/read_modes_file.hpp"

#include "acquisition/bundle/uff_file.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "modal/mode_set/mac.hpp"
#include "modal/mode_set/read_modes_csv.hpp"
#include "modal/mode_set/read_modes_json.hpp"
#include "modal/mode_set/read_modes_uff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace tapfit::modal {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in =
      acquisition::open_input(file, acquisition::most_text_bytes);
  if (!in) {
    throw InputError("cannot be read", file.string(), "check its name");
  }
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Whether a weight can be made of a standard deviation of that value: their
/// squares are neither lost beside each other nor without end. 0 is none.
bool is_scatter(double sd, double value) {
  constexpr double least = 1e-30;
  constexpr double most = 1e6;
  return sd == 0.0 || (sd >= least * value && sd <= most * value);
}

/// Why a mode cannot have been measured and what to do; empty: it can.
std::pair<std::string, std::string> fault(const Mode& mode) {
  const auto [f, zeta] = std::pair{mode.frequency_hz, mode.damping_ratio};
  if (!std::isfinite(f) || f < 0.0) {
    return {fmt::format("its frequency is {} Hz", f),
            "give it in Hz, 0 or more"};
  }
  if (!std::isfinite(zeta) || zeta < 0.0 || zeta >= 1.0) {
    return {fmt::format("its damping ratio is {}", zeta),
            "give a ratio from 0 to below 1 (1 % is 0.01); leave it out where "
            "it is not known"};
  }
  if (!mode.shape.allFinite()) {
    return {"its shape holds values that are no numbers",
            "give a value at every point, or leave the point out of all modes"};
  }
  const double largest =
      mode.shape.size() > 0 ? mode.shape.cwiseAbs().maxCoeff() : 1.0;
  // Fourth powers of it are finite; of zero the frequency counts alone.
  const bool still = largest == 0.0;
  if (!still && (largest < 1e-60 || largest > 1e60)) {
    return {fmt::format("its shape reaches {}", largest),
            "scale it, for example to 1 where it is largest"};
  }
  const auto belongs = [&](double sd) { return is_scatter(sd, largest); };
  const bool rigid = f == 0.0;  // it is left out
  if (!(rigid || is_scatter(mode.frequency_sd_hz, f)) ||
      (!still && !std::ranges::all_of(mode.shape_sd, belongs))) {
    return {
        "a standard deviation of it is below 0, no number, or beyond "
        "1e-30 to 1e6 of the value",
        "give what the modes scattered by, or leave it out"};
  }
  return {};
}

/// Two modes of one frequency may be measured, as of what is symmetric, but
/// not one twice.
bool is_same(const Mode& a, const Mode& b) {
  constexpr double rounding = 1e-6;
  if (a.frequency_hz != b.frequency_hz || a.frequency_hz == 0.0) return false;
  return a.shape.size() == 0 || mac(a.shape, b.shape)(0, 0) > 1.0 - rounding;
}

}  // namespace

ModeSet read_modes_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError("is a folder, not a file of modes",
                     file.string(),
                     "write one with tapfit modes BUNDLE --json > modes.json");
  }
  const std::filesystem::path kind = file.extension();
  if (kind == ".json") return read_modes_json(text_of(file), file.string());
  const bool table = kind == ".csv" || kind == ".tsv" || kind == ".txt";
  if (table && !acquisition::is_uff(file)) return read_modes_csv(file);
  UffModes read = read_modes_uff(file);
  read.set.warnings = std::move(read.skipped);
  return std::move(read.set);
}

void check_measured(const ModeSet& set, const std::string& name) {
  for (std::size_t k = 0; k < set.modes.size(); ++k) {
    const std::string place = fmt::format("{}: mode {}", name, k + 1);
    const auto [what, remedy] = fault(set.modes[k]);
    if (!what.empty()) throw InputError(what, place, remedy);
    if (k == 0 || !is_same(set.modes[k], set.modes[k - 1])) continue;
    throw InputError(
        fmt::format("it has the frequency of the mode before ({:.6g} Hz) and "
                    "no other shape",
                    set.modes[k].frequency_hz),
        place,
        "leave one out where it is the same mode twice; of two modes that "
        "close give shapes, or more digits");
  }
}

}  // namespace tapfit::modal
