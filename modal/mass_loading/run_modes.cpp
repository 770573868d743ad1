#include "modal/mass_loading/run_modes.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "modal/fit/fit_residual.hpp"
#include "modal/fit/pole_covariance.hpp"
#include "modal/fit/shape_uncertainty.hpp"
#include "modal/poles/frf_matrix.hpp"
#include "modal/poles/plscf.hpp"
#include "modal/poles/stabilisation.hpp"
#include "modal/select/edit_poles.hpp"
#include "modal/select/needed_modes.hpp"
#include "modal/select/select_from_orders.hpp"
#include "modal/select/unrefined_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double kFarthest = 0.12;  // ln f of a set-up from the mean of all

}  // namespace

struct SetUpFit {
  std::size_t set_up = 0;
  std::vector<Index> frfs;
  Curves curves;  ///< those FRFs
  std::vector<Track> tracks;
  ModalFit fit;
  Eigen::MatrixXd residue_variance;
  Eigen::MatrixXd pole_covariance;
};

struct Member {
  std::size_t fit = 0;
  Index mode = 0;

  bool operator==(const Member&) const = default;
};

/// One mode, in each set-up at most once.
struct Group {
  std::vector<Member> members;

  bool operator==(const Group&) const = default;
};

struct SetUpFits {
  std::vector<SetUpFit> fits;
  std::vector<Group> groups;  ///< of the modes that count, by frequency
};

namespace {

SetUpFit fit_set_up(const Curves& curves,
                    std::size_t set_up,
                    const std::vector<Index>& frfs,
                    const IdentifyOptions& options,
                    const Progress& progress) {
  SetUpFit result;
  result.set_up = set_up;
  result.frfs = frfs;
  result.curves = select_curves(curves, frfs);
  const Curves& part = result.curves;
  const FrfMatrix matrix = arrange_frfs(part);
  const std::vector<OrderPoles> orders =
      plscf_poles(part, matrix, options.max_order, progress);
  result.tracks =
      stabilise(
          orders, part.s(0).imag(), part.s(part.lines() - 1).imag(), options)
          .tracks;
  result.fit =
      select_from_orders(part, matrix, orders, result.tracks, options, progress)
          .fit;
  return result;
}

std::vector<SetUpFit> fit_set_ups(const Curves& curves,
                                  const IdentifyOptions& options,
                                  const Progress& progress) {
  std::map<std::size_t, std::vector<Index>> frfs;
  for (std::size_t f = 0; f < curves.set_up.size(); ++f) {
    frfs[curves.set_up[f]].push_back(static_cast<Index>(f));
  }
  const std::vector<std::pair<std::size_t, std::vector<Index>>> set_ups(
      frfs.begin(), frfs.end());
  std::vector<SetUpFit> fits(set_ups.size());
  // The stages of set-ups that are at work together are told as set-ups done.
  std::mutex reporting;
  std::size_t done = 0;
  const Progress together{[&](std::string_view, double) {
                            const std::lock_guard lock(reporting);
                            progress("set-ups",
                                     static_cast<double>(done) /
                                         static_cast<double>(set_ups.size()));
                          },
                          progress.stop};
  for_each_parallel(set_ups.size(), [&](std::size_t k) {
    const auto& [set_up, own] = set_ups[k];
    fits[k] = fit_set_up(curves, set_up, own, options, together);
    const std::lock_guard lock(reporting);
    ++done;
  });
  return fits;
}

double log_frequency(const std::vector<SetUpFit>& fits, const Member& member) {
  return std::log(std::abs(fits[member.fit].fit.poles(member.mode)));
}

double mean_log(const std::vector<SetUpFit>& fits, const Group& group) {
  double sum = 0.0;
  for (const Member& member : group.members) {
    sum += log_frequency(fits, member);
  }
  return sum / static_cast<double>(group.members.size());
}

/// Which group each mode of a set-up belongs to, or -1: in the same order, at
/// the least sum of squared distances, (apart / kFarthest)^2 for a mode that
/// joins a group and 1/2 for each that stays alone, mode or group. (Alignment
/// of two sequences: S. B. Needleman, C. D. Wunsch, J. Mol. Biol. 48, 1970.)
std::vector<Index> aligned(const std::vector<double>& modes,
                           const std::vector<double>& groups) {
  constexpr double alone = 0.5;
  const auto n = static_cast<Index>(modes.size());
  const auto m = static_cast<Index>(groups.size());
  const auto joined = [&](Index i, Index j) {
    return std::pow((modes[static_cast<std::size_t>(i)] -
                     groups[static_cast<std::size_t>(j)]) /
                        kFarthest,
                    2);
  };
  Eigen::MatrixXd cost(n + 1, m + 1);
  cost.col(0) =
      alone * Eigen::VectorXd::LinSpaced(n + 1, 0.0, static_cast<double>(n));
  cost.row(0) =
      alone * Eigen::RowVectorXd::LinSpaced(m + 1, 0.0, static_cast<double>(m));
  for (Index i = 1; i <= n; ++i) {
    for (Index j = 1; j <= m; ++j) {
      cost(i, j) = std::min({cost(i - 1, j) + alone,
                             cost(i, j - 1) + alone,
                             cost(i - 1, j - 1) + joined(i - 1, j - 1)});
    }
  }
  std::vector<Index> result(modes.size(), -1);
  for (Index i = n, j = m; i > 0 && j > 0;) {
    if (cost(i, j) == cost(i - 1, j) + alone) {
      --i;
    } else if (cost(i, j) == cost(i, j - 1) + alone) {
      --j;
    } else {
      result[static_cast<std::size_t>(--i)] = --j;
    }
  }
  return result;
}

/// Puts the modes of one set-up into the groups of the others.
void place_modes(const std::vector<SetUpFit>& fits,
                 std::size_t own,
                 std::vector<Group>& groups) {
  std::vector<double> there;
  for (const Group& group : groups) there.push_back(mean_log(fits, group));
  std::vector<double> here;
  for (Index r = 0; r < fits[own].fit.poles.size(); ++r) {
    here.push_back(log_frequency(fits, {own, r}));
  }
  const std::vector<Index> group_of = aligned(here, there);
  for (std::size_t r = 0; r < here.size(); ++r) {
    const Member member{own, static_cast<Index>(r)};
    if (group_of[r] >= 0) {
      groups[static_cast<std::size_t>(group_of[r])].members.push_back(member);
    } else {
      groups.push_back({{member}});
    }
  }
  std::ranges::sort(groups, {}, [&fits](const Group& group) {
    return mean_log(fits, group);
  });
}

void take_out(std::size_t own, std::vector<Group>& groups) {
  for (Group& group : groups) {
    std::erase_if(group.members,
                  [own](const Member& member) { return member.fit == own; });
  }
  std::erase_if(groups,
                [](const Group& group) { return group.members.empty(); });
}

/// Modes of different set-ups that are one: each set-up is placed among the
/// others until none changes its place.
std::vector<Group> group_modes(const std::vector<SetUpFit>& fits) {
  std::vector<Group> groups;
  std::vector<std::size_t> order(fits.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // The fullest first: what others lack is then a gap, not a new group.
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t k) {
    return fits[k].fit.poles.size();
  });
  for (const std::size_t k : order) place_modes(fits, k, groups);
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Group> before = groups;
    for (const std::size_t k : order) {
      take_out(k, groups);
      place_modes(fits, k, groups);
    }
    if (groups == before) break;
  }
  return groups;
}

Complex mean_pole(const std::vector<SetUpFit>& fits, const Group& group) {
  Complex sum = 0.0;
  for (const Member& member : group.members) {
    sum += fits[member.fit].fit.poles(member.mode);
  }
  return sum / static_cast<double>(group.members.size());
}

/// Looks for a mode in a set-up that it was not found in, starting from where
/// the others have it; whether the FRFs need it there.
bool find_there(const Complex& pole,
                const IdentifyOptions& options,
                SetUpFit& own) {
  const Index before = own.fit.poles.size();
  Eigen::VectorXcd start(before + 1);
  start << own.fit.poles, pole;
  ModalFit trial = refine_poles(own.curves, start, 15);
  const auto apart = [](const Complex& a, const Complex& b) {
    return std::abs(std::log(std::abs(a) / std::abs(b)));
  };
  if (apart(trial.poles(before), pole) >= kFarthest) return false;
  // It must not take another's place.
  for (Index r = 0; r < before; ++r) {
    const double width = -own.fit.poles(r).real();
    if (std::abs(trial.poles(r) - own.fit.poles(r)) > width) return false;
  }
  if (!are_needed(own.curves, trial, options)) return false;
  own.fit = std::move(trial);
  return true;
}

/// What a set-up's selection of modes missed and two others have.
void find_missing(const IdentifyOptions& options,
                  std::vector<SetUpFit>& fits,
                  std::vector<Group>& groups) {
  std::vector<Complex> poles;
  for (const Group& group : groups) poles.push_back(mean_pole(fits, group));
  std::vector<std::vector<std::size_t>> found(fits.size());  // groups, in order
  for_each_parallel(fits.size(), [&](std::size_t k) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::vector<Member>& members = groups[g].members;
      const bool there = std::ranges::any_of(
          members, [k](const Member& member) { return member.fit == k; });
      if (there || members.size() < 2) continue;
      if (find_there(poles[g], options, fits[k])) found[k].push_back(g);
    }
  });
  for (std::size_t k = 0; k < fits.size(); ++k) {
    Index mode = fits[k].fit.poles.size() - std::ssize(found[k]);
    for (const std::size_t g : found[k])
      groups[g].members.push_back({k, mode++});
  }
}

/// Modes that are in half of the set-ups or more, by frequency.
std::vector<Group> common_modes(const std::vector<SetUpFit>& fits,
                                std::vector<Group> groups) {
  const std::size_t enough = std::max<std::size_t>(2, (fits.size() + 1) / 2);
  std::erase_if(groups, [&](const Group& group) {
    return group.members.size() < enough;
  });
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
  const Complex mean = mean_pole(fits, group);
  double low = std::abs(mean);
  double high = low;
  const auto n = static_cast<double>(group.members.size());
  for (const Member& member : group.members) {
    const SetUpFit& own = fits[member.fit];
    const Complex pole = own.fit.poles(member.mode);
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
  if (const Member& only = group.members.front(); n == 1.0) {
    const Eigen::MatrixXd& covariance = fits[only.fit].pole_covariance;
    re = covariance(2 * only.mode, 2 * only.mode);
    im = covariance(2 * only.mode + 1, 2 * only.mode + 1);
  }
  result.poles(column) = mean;
  result.scatter(column) = {std::sqrt(re), std::sqrt(im)};
  result.frequency_range(column) = (high - low) / std::abs(mean);
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
  result.unrefined_H.resize(curves.lines(), curves.count());
  result.frf_weight.resize(curves.count());
  for (const SetUpFit& fit : fits) {
    result.frf_weight(fit.frfs) = fit.fit.frf_weight;
    result.H(Eigen::all, fit.frfs) = fitted_accelerance(fit.curves, fit.fit);
    result.unrefined_H(Eigen::all, fit.frfs) =
        unrefined_fit(fit.curves, fit.tracks, fit.fit.poles);
    result.set_ups.push_back({fit.set_up,
                              Eigen::VectorXcd::Zero(count),
                              Eigen::VectorXd::Zero(count)});
  }
  return result;
}

/// All of the set-ups as one.
RunModes joined(const Curves& curves, SetUpFits parts) {
  for (SetUpFit& own : parts.fits) {
    const Noise noise =
        weighted_noise(own.curves, own.fit, NoiseFrom::AllLines);
    own.residue_variance = residue_variance(own.curves, own.fit, noise);
    own.pole_covariance = pole_covariance(own.curves, own.fit, noise);
  }
  const auto count = static_cast<Index>(parts.groups.size());
  RunModes result = empty_modes(curves, parts.fits, count);
  for (Index c = 0; c < count; ++c) {
    summarise(parts.fits, parts.groups[static_cast<std::size_t>(c)], c, result);
  }
  result.made_of = std::make_shared<const SetUpFits>(std::move(parts));
  return result;
}

void drop_group(double hz, SetUpFits& parts) {
  Eigen::ArrayXd omega(std::ssize(parts.groups));
  for (Index g = 0; g < omega.size(); ++g) {
    omega(g) = std::abs(
        mean_pole(parts.fits, parts.groups[static_cast<std::size_t>(g)]));
  }
  const auto dropped = parts.groups.begin() + mode_to_drop(omega, hz);
  const std::vector<Member> members = dropped->members;
  parts.groups.erase(dropped);
  for (const Member& out : members) {
    SetUpFit& own = parts.fits[out.fit];
    drop_pole(own.curves, out.mode, own.fit);
    for (Group& group : parts.groups) {
      for (Member& other : group.members) {
        if (other.fit == out.fit && other.mode > out.mode) --other.mode;
      }
    }
  }
}

void add_group(double hz, SetUpFits& parts) {
  Group group;
  std::optional<InputError> why_not;
  for (std::size_t k = 0; k < parts.fits.size(); ++k) {
    SetUpFit& own = parts.fits[k];
    try {
      add_pole(own.curves, own.tracks, hz, own.fit);
      group.members.push_back({k, own.fit.poles.size() - 1});
    } catch (const InputError& error) {
      if (!why_not) why_not = error;
    }
  }
  if (group.members.empty()) throw InputError(*why_not);
  parts.groups.push_back(std::move(group));
  std::ranges::sort(parts.groups, {}, [&parts](const Group& one) {
    return mean_log(parts.fits, one);
  });
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
  std::vector<SetUpFit> fits = fit_set_ups(curves, options, progress);
  for (const SetUpFit& own : fits) {
    if (own.fit.poles.size() == 0) return std::nullopt;
  }
  std::vector<Group> found = group_modes(fits);
  find_missing(options, fits, found);
  std::vector<Group> groups = common_modes(fits, std::move(found));
  if (groups.empty()) return std::nullopt;
  return joined(curves, {std::move(fits), std::move(groups)});
}

RunModes edited(const Curves& curves,
                const std::vector<PoleEdit>& edits,
                const RunModes& modes) {
  if (edits.empty()) return modes;
  SetUpFits parts = *modes.made_of;
  for (const PoleEdit& edit : edits) {
    if (edit.what == PoleEdit::What::Drop) {
      drop_group(edit.hz, parts);
    } else {
      add_group(edit.hz, parts);
    }
  }
  return joined(curves, std::move(parts));
}

}  // namespace tapfit::modal
