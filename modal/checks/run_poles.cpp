#include "modal/checks/run_poles.hpp"

#include "acquisition/samples/statistics.hpp"
#include "modal/checks/frfs_by_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tapfit::modal {

using acquisition::median;
using Eigen::Index;
using Eigen::VectorXcd;
using signal::FrfSet;

std::vector<std::vector<Index>> pole_groups(const VectorXcd& poles) {
  std::vector<Index> order(static_cast<std::size_t>(poles.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](Index k) { return poles(k).imag(); });
  std::vector<std::vector<Index>> groups;
  for (const Index k : order) {
    const bool near = !groups.empty() &&
                      poles(k).imag() - poles(groups.back().back()).imag() <
                          -poles(k).real() - poles(groups.back().back()).real();
    if (!near) groups.emplace_back();
    groups.back().push_back(k);
  }
  return groups;
}

VectorXcd poles_of(const ModeSet& modes) {
  VectorXcd poles(static_cast<Index>(modes.modes.size()));
  for (Index k = 0; k < poles.size(); ++k) {
    const std::complex<double> p =
        modes.modes[static_cast<std::size_t>(k)].pole;
    poles(k) = {p.real(), std::abs(p.imag())};
  }
  return poles;
}

std::vector<ForeignRun> foreign_runs(const FrfSet& set,
                                     const ModeSet& modes,
                                     const RunPoleLimits& limits) {
  const FrfsByRun runs = frfs_by_run(set);
  const VectorXcd poles = poles_of(modes);
  if (runs.size() < limits.fewest_runs || poles.size() == 0) return {};
  const std::vector<ModalConstants> all = modal_constants(set, poles, false);
  std::vector<ForeignRun> each;
  std::vector<double> shares;
  for (const auto& [run, frfs] : runs) {
    const VectorXcd others =
        shown_by_others(runs, run, all, poles, limits.shown_by);
    shares.push_back(left_by(others, part_of(set, frfs)));
    each.push_back({run, shares.back(), 0.0});
  }
  const double usual = median(shares);
  for (ForeignRun& one : each) one.usual = usual;
  std::erase_if(each, [&](const ForeignRun& one) {
    return one.left < std::max(limits.foreign, limits.foreign_times * usual);
  });
  return each;
}

std::string statement(const ForeignRun& foreign,
                      const acquisition::TestBundle& bundle) {
  return fmt::format(
      "the resonances of the other runs leave {:.0f} % of run {} ({}), and "
      "{:.2g} % of the others",
      100.0 * foreign.left,
      foreign.run + 1,
      bundle.runs[foreign.run].file.filename().string(),
      100.0 * foreign.usual);
}

}  // namespace tapfit::modal
