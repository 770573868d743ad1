#include "modal/run_modes.hpp"

#include "modal/frf_matrix.hpp"
#include "modal/plscf.hpp"
#include "modal/select_modes.hpp"
#include "modal/shape_uncertainty.hpp"
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

struct SetUpFit {
  std::size_t set_up = 0;
  std::vector<Index> frfs;
  ModalFit fit;
  Eigen::MatrixXd residue_variance;
  Eigen::MatrixXd pole_covariance;
};

struct Member {
  std::size_t fit = 0;
  Index mode = 0;
};

struct Group {
  std::vector<Member> members;
  double frequency = 0.0;  ///< mean [rad/s]
};

SetUpFit fit_set_up(const Curves& curves,
                    std::size_t set_up,
                    const std::vector<Index>& frfs,
                    const IdentifyOptions& options,
                    const Progress& progress) {
  const Curves part = select_curves(curves, frfs);
  const std::vector<OrderPoles> orders =
      plscf_poles(part, arrange_frfs(part), options.max_order, progress);
  const Stabilisation stabilisation = stabilise(
      orders, part.s(0).imag(), part.s(part.lines() - 1).imag(), options);
  SetUpFit result;
  result.set_up = set_up;
  result.frfs = frfs;
  result.fit =
      select_modes(part, stabilisation.tracks, orders.size(), options, progress)
          .fit;
  result.residue_variance = residue_variance(part, result.fit);
  result.pole_covariance = pole_covariance(part, result.fit);
  return result;
}

std::vector<SetUpFit> fit_set_ups(const Curves& curves,
                                  const IdentifyOptions& options,
                                  const Progress& progress) {
  std::map<std::size_t, std::vector<Index>> frfs;
  for (std::size_t f = 0; f < curves.set_up.size(); ++f) {
    frfs[curves.set_up[f]].push_back(static_cast<Index>(f));
  }
  std::vector<SetUpFit> fits;
  for (const auto& [set_up, own] : frfs) {
    fits.push_back(fit_set_up(curves, set_up, own, options, progress));
  }
  return fits;
}

bool share_a_set_up(const Group& a, const Group& b) {
  return std::ranges::any_of(a.members, [&](const Member& x) {
    return std::ranges::any_of(b.members,
                               [&](const Member& y) { return x.fit == y.fit; });
  });
}

void join(Group& into, const Group& other) {
  const auto n = static_cast<double>(into.members.size());
  const auto m = static_cast<double>(other.members.size());
  into.frequency = (n * into.frequency + m * other.frequency) / (n + m);
  into.members.insert(
      into.members.end(), other.members.begin(), other.members.end());
}

/// Joins the closest two groups that share no set-up until none are close.
std::vector<Group> group_modes(const std::vector<SetUpFit>& fits) {
  std::vector<Group> groups;
  for (std::size_t k = 0; k < fits.size(); ++k) {
    const Eigen::VectorXcd& poles = fits[k].fit.poles;
    for (Index r = 0; r < poles.size(); ++r) {
      groups.push_back({{{k, r}}, std::abs(poles(r))});
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
        if (apart >= least || share_a_set_up(groups[a], groups[b])) continue;
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

/// Standard deviation of ln|lambda| of mode r.
double log_deviation(const SetUpFit& fit, Index r) {
  const Complex pole = fit.fit.poles(r);
  const Eigen::Vector2d direction(pole.real(), pole.imag());
  const double variance =
      direction.dot(fit.pole_covariance.block<2, 2>(2 * r, 2 * r) * direction);
  return std::sqrt(std::max(0.0, variance)) / std::norm(pole);
}

void take_over(const SetUpFit& from,
               Index mode,
               Index column,
               SetUpPoles& poles,
               RunModes& result) {
  poles.poles(column) = from.fit.poles(mode);
  poles.log_sd(column) = log_deviation(from, mode);
  for (std::size_t k = 0; k < from.frfs.size(); ++k) {
    const auto row = static_cast<Index>(k);
    result.residues(from.frfs[k], column) = from.fit.residues(row, mode);
    result.residue_variance(from.frfs[k], column) =
        from.residue_variance(row, mode);
  }
}

void summarise(const std::vector<SetUpFit>& fits,
               const Group& group,
               Index column,
               RunModes& result) {
  Complex mean = 0.0;
  double low = group.frequency;
  double high = group.frequency;
  const auto n = static_cast<double>(group.members.size());
  for (const Member& member : group.members) {
    const SetUpFit& own = fits[member.fit];
    const Complex pole = own.fit.poles(member.mode);
    mean += pole / n;
    low = std::min(low, std::abs(pole));
    high = std::max(high, std::abs(pole));
    take_over(own, member.mode, column, result.set_ups[member.fit], result);
  }
  double re = 0.0;
  double im = 0.0;
  for (const Member& member : group.members) {
    const Complex off = fits[member.fit].fit.poles(member.mode) - mean;
    re += off.real() * off.real() / (n - 1.0);
    im += off.imag() * off.imag() / (n - 1.0);
  }
  result.poles(column) = mean;
  result.scatter(column) = {std::sqrt(re), std::sqrt(im)};
  result.frequency_range(column) = (high - low) / group.frequency;
}

/// Room for so many modes, none of them found in any set-up yet.
RunModes empty_modes(const Curves& curves,
                     const std::vector<SetUpFit>& fits,
                     Index count) {
  RunModes result;
  result.poles.resize(count);
  result.scatter.resize(count);
  result.frequency_range.resize(count);
  result.residues = Eigen::MatrixXcd::Zero(curves.count(), count);
  result.residue_variance = Eigen::MatrixXd::Zero(curves.count(), count);
  result.H.resize(curves.lines(), curves.count());
  result.frf_weight.resize(curves.count());
  for (const SetUpFit& fit : fits) {
    result.frf_weight(fit.frfs) = fit.fit.frf_weight;
    result.H(Eigen::all, fit.frfs) = fit.fit.H;
    result.set_ups.push_back({fit.set_up,
                              Eigen::VectorXcd::Zero(count),
                              Eigen::VectorXd::Zero(count)});
  }
  return result;
}

}  // namespace

bool sensors_rove(const Curves& curves) {
  const std::set<std::size_t> all(curves.set_up.begin(), curves.set_up.end());
  std::map<Dof, std::set<std::size_t>> seen;
  for (std::size_t f = 0; f < curves.set_up.size(); ++f) {
    seen[curves.response[f]].insert(curves.set_up[f]);
  }
  return all.size() > 1 && std::ranges::all_of(seen, [&](const auto& entry) {
           return 2 * entry.second.size() <= all.size();
         });
}

std::optional<RunModes> identify_per_set_up(const Curves& curves,
                                            const IdentifyOptions& options,
                                            const Progress& progress) {
  if (std::ranges::all_of(curves.set_up,
                          [](std::size_t k) { return k == 0; })) {
    return std::nullopt;
  }
  const std::vector<SetUpFit> fits = fit_set_ups(curves, options, progress);
  for (const SetUpFit& own : fits) {
    if (own.fit.poles.size() == 0) return std::nullopt;
  }
  const std::vector<Group> groups = group_modes(fits);
  if (groups.empty()) return std::nullopt;
  const auto count = static_cast<Index>(groups.size());
  RunModes result = empty_modes(curves, fits, count);
  for (Index c = 0; c < count; ++c) {
    summarise(fits, groups[static_cast<std::size_t>(c)], c, result);
  }
  return result;
}

}  // namespace tapfit::modal
