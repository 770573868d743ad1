#include "signal/files/finite_lines.hpp"

#include "signal/frf_set/kept_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::signal {
namespace {

bool is_finite(const Frf& frf, Eigen::Index line) {
  return std::isfinite(std::abs(frf.H(line)));
}

// "2 lines (0 and 12.6 Hz) are left out of all FRFs: 4Z+ / 3Z+ has no finite
// value there", of the FRF that has the most of them.
std::string dropped_statement(const FrfSet& set,
                              const std::vector<Eigen::Index>& dropped) {
  const Frf* worst = nullptr;
  std::ptrdiff_t most = 0;
  std::ptrdiff_t concerned = 0;
  for (const Frf& frf : set.frfs) {
    const std::ptrdiff_t bad = std::ranges::count_if(
        dropped, [&](Eigen::Index i) { return !is_finite(frf, i); });
    concerned += bad > 0 ? 1 : 0;
    if (bad > most) worst = &frf;
    most = std::max(most, bad);
  }
  const auto hz = [&](Eigen::Index i) {
    return set.s(i).imag() / (2.0 * std::numbers::pi);
  };
  std::string text = fmt::format("{} {} left out of all FRFs ({:.6g}",
                                 dropped.size(),
                                 dropped.size() == 1 ? "line is" : "lines are",
                                 hz(dropped.front()));
  if (dropped.size() > 1)
    text += fmt::format(" ... {:.6g}", hz(dropped.back()));
  text += " Hz): ";
  if (worst == nullptr) return text + "their frequencies are no numbers";
  text += fmt::format("{} of {} {} not finite",
                      most,
                      name(*worst),
                      most == 1 ? "value is" : "values are");
  if (concerned < 2) return text;
  return text + fmt::format(", and some of {} more", concerned - 1);
}

}  // namespace

std::string drop_bad_lines(FrfSet& set) {
  std::vector<Eigen::Index> keep;
  std::vector<Eigen::Index> dropped;
  for (Eigen::Index i = 0; i < set.lines(); ++i) {
    const bool good = std::isfinite(set.s(i).imag()) &&
                      std::ranges::all_of(set.frfs, [&](const Frf& frf) {
                        return is_finite(frf, i);
                      });
    (good ? keep : dropped).push_back(i);
  }
  if (dropped.empty()) return {};
  std::string said = dropped_statement(set, dropped);
  keep_lines(keep, set);
  return said;
}

std::vector<std::string> leave_out_broken(FrfSet& set) {
  std::vector<std::string> said;
  std::vector<std::size_t> bad(static_cast<std::size_t>(set.lines()), 0);
  for (const Frf& frf : set.frfs) {
    for (std::size_t i = 0; i < bad.size(); ++i) {
      if (!is_finite(frf, static_cast<Eigen::Index>(i))) ++bad[i];
    }
  }
  const auto whole = [](std::size_t count) { return count == 0; };
  const auto first = std::find_if(bad.begin(), bad.end(), whole);
  const auto last = std::find_if(bad.rbegin(), bad.rend(), whole).base();
  const std::size_t most = set.frfs.size() / 2;
  std::erase_if(set.frfs, [&](const Frf& frf) {
    for (auto it = first; it < last; ++it) {
      const Eigen::Index i = it - bad.begin();
      if (is_finite(frf, i) || *it > most) continue;
      said.push_back(
          fmt::format("FRF {} is left out: its value at {:.6g} Hz is no number",
                      name(frf),
                      set.s(i).imag() / (2.0 * std::numbers::pi)));
      return true;
    }
    return false;
  });
  return said;
}

}  // namespace tapfit::signal
