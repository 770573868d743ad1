#include "modal/run_modes.hpp"

#include "modal/frf_matrix.hpp"
#include "modal/plscf.hpp"
#include "modal/select_modes.hpp"
#include "modal/stabilisation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double kFarthest = 0.06;  // relative, between runs

struct RunFit {
  std::vector<Index> frfs;
  ModalFit fit;
};

struct Member {
  std::size_t run = 0;
  Index mode = 0;
};

struct Group {
  std::vector<Member> members;
  double frequency = 0.0;  ///< mean [rad/s]
};

std::vector<RunFit> fit_runs(const Curves& curves,
                             const IdentifyOptions& options,
                             const Progress& progress) {
  std::map<std::size_t, std::vector<Index>> by_run;
  for (std::size_t f = 0; f < curves.run.size(); ++f) {
    by_run[curves.run[f]].push_back(static_cast<Index>(f));
  }
  std::vector<RunFit> fits;
  for (const auto& [run, indices] : by_run) {
    const Curves part = select_curves(curves, indices);
    const std::vector<OrderPoles> orders =
        plscf_poles(part, arrange_frfs(part), options.max_order, progress);
    const Stabilisation stabilisation = stabilise(
        orders, part.s(0).imag(), part.s(part.lines() - 1).imag(), options);
    fits.push_back(
        {indices,
         select_modes(
             part, stabilisation.tracks, orders.size(), options, progress)
             .fit});
  }
  return fits;
}

bool share_a_run(const Group& a, const Group& b) {
  return std::ranges::any_of(a.members, [&](const Member& x) {
    return std::ranges::any_of(b.members,
                               [&](const Member& y) { return x.run == y.run; });
  });
}

void join(Group& into, const Group& other) {
  const auto n = static_cast<double>(into.members.size());
  const auto m = static_cast<double>(other.members.size());
  into.frequency = (n * into.frequency + m * other.frequency) / (n + m);
  into.members.insert(
      into.members.end(), other.members.begin(), other.members.end());
}

/// Joins the closest two groups that share no run until none are close.
std::vector<Group> group_modes(const std::vector<RunFit>& fits) {
  std::vector<Group> groups;
  for (std::size_t run = 0; run < fits.size(); ++run) {
    const Eigen::VectorXcd& poles = fits[run].fit.poles;
    for (Index r = 0; r < poles.size(); ++r) {
      groups.push_back({{{run, r}}, std::abs(poles(r))});
    }
  }
  for (;;) {
    double least = kFarthest;
    std::size_t first = 0;
    std::size_t second = 0;
    for (std::size_t a = 0; a < groups.size(); ++a) {
      for (std::size_t b = a + 1; b < groups.size(); ++b) {
        const double apart =
            std::abs(std::log(groups[a].frequency / groups[b].frequency));
        if (apart >= least || share_a_run(groups[a], groups[b])) continue;
        least = apart;
        first = a;
        second = b;
      }
    }
    if (second == 0) break;
    join(groups[first], groups[second]);
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(second));
  }
  const std::size_t enough = std::max<std::size_t>(2, (fits.size() + 1) / 2);
  std::erase_if(groups, [&](const Group& group) {
    return group.members.size() < enough;
  });
  std::ranges::sort(groups, {}, &Group::frequency);
  return groups;
}

void summarise(const std::vector<RunFit>& fits,
               const Group& group,
               Index column,
               RunModes& result) {
  Complex mean = 0.0;
  double low = group.frequency;
  double high = group.frequency;
  const auto n = static_cast<double>(group.members.size());
  for (const Member& member : group.members) {
    const RunFit& run = fits[member.run];
    const Complex pole = run.fit.poles(member.mode);
    mean += pole / n;
    low = std::min(low, std::abs(pole));
    high = std::max(high, std::abs(pole));
    for (std::size_t k = 0; k < run.frfs.size(); ++k) {
      result.residues(run.frfs[k], column) =
          run.fit.residues(static_cast<Index>(k), member.mode);
    }
  }
  double re = 0.0;
  double im = 0.0;
  for (const Member& member : group.members) {
    const Complex off = fits[member.run].fit.poles(member.mode) - mean;
    re += off.real() * off.real() / (n - 1.0);
    im += off.imag() * off.imag() / (n - 1.0);
  }
  result.poles(column) = mean;
  result.scatter(column) = {std::sqrt(re), std::sqrt(im)};
  result.frequency_range(column) = (high - low) / group.frequency;
}

}  // namespace

bool sensors_rove(const Curves& curves) {
  std::set<std::size_t> runs(curves.run.begin(), curves.run.end());
  std::map<Dof, std::set<std::size_t>> seen;
  for (std::size_t f = 0; f < curves.run.size(); ++f) {
    seen[curves.response[f]].insert(curves.run[f]);
  }
  return runs.size() > 1 && std::ranges::all_of(seen, [&](const auto& entry) {
           return 2 * entry.second.size() <= runs.size();
         });
}

std::optional<RunModes> identify_per_run(const Curves& curves,
                                         const IdentifyOptions& options,
                                         const Progress& progress) {
  const std::vector<RunFit> fits = fit_runs(curves, options, progress);
  for (const RunFit& run : fits) {
    if (run.fit.poles.size() == 0) return std::nullopt;
  }
  const std::vector<Group> groups = group_modes(fits);
  if (groups.empty()) return std::nullopt;
  const auto count = static_cast<Index>(groups.size());
  RunModes result;
  result.poles.resize(count);
  result.scatter.resize(count);
  result.frequency_range.resize(count);
  result.residues = Eigen::MatrixXcd::Zero(curves.count(), count);
  result.H.resize(curves.lines(), curves.count());
  for (const RunFit& run : fits) result.H(Eigen::all, run.frfs) = run.fit.H;
  for (Index c = 0; c < count; ++c) {
    summarise(fits, groups[static_cast<std::size_t>(c)], c, result);
  }
  return result;
}

}  // namespace tapfit::modal
