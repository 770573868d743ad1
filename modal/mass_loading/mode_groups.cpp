#include "modal/mass_loading/mode_groups.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "modal/fit/fit_residual.hpp"
#include "modal/select/edit_poles.hpp"
#include "modal/select/needed_modes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double farthest = 0.12;  // ln f of a set-up from the mean of all

double log_frequency(const std::vector<SetUpFit>& fits,
                     const GroupMember& member) {
  return std::log(std::abs(fits[member.fit].fit.poles(member.mode)));
}

double mean_log(const std::vector<SetUpFit>& fits, const ModeGroup& group) {
  double sum = 0.0;
  for (const GroupMember& member : group.members) {
    sum += log_frequency(fits, member);
  }
  return sum / static_cast<double>(group.members.size());
}

/// Which group each mode of a set-up belongs to, or -1: in the same order, at
/// the least sum of squared distances, (apart / farthest)^2 for a mode that
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
                        farthest,
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
                 std::vector<ModeGroup>& groups) {
  std::vector<double> there;
  for (const ModeGroup& group : groups) there.push_back(mean_log(fits, group));
  std::vector<double> here;
  for (Index r = 0; r < fits[own].fit.poles.size(); ++r) {
    here.push_back(log_frequency(fits, {own, r}));
  }
  const std::vector<Index> group_of = aligned(here, there);
  for (std::size_t r = 0; r < here.size(); ++r) {
    const GroupMember member{own, static_cast<Index>(r)};
    if (group_of[r] >= 0) {
      groups[static_cast<std::size_t>(group_of[r])].members.push_back(member);
    } else {
      groups.push_back({{member}});
    }
  }
  std::ranges::sort(groups, {}, [&fits](const ModeGroup& group) {
    return mean_log(fits, group);
  });
}

void take_out(std::size_t own, std::vector<ModeGroup>& groups) {
  for (ModeGroup& group : groups) {
    std::erase_if(group.members, [own](const GroupMember& member) {
      return member.fit == own;
    });
  }
  std::erase_if(groups,
                [](const ModeGroup& group) { return group.members.empty(); });
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
  if (apart(trial.poles(before), pole) >= farthest) return false;
  // It must not take another's place.
  for (Index r = 0; r < before; ++r) {
    const double width = -own.fit.poles(r).real();
    if (std::abs(trial.poles(r) - own.fit.poles(r)) > width) return false;
  }
  if (!are_needed(own.curves, trial, options)) return false;
  own.fit = std::move(trial);
  return true;
}

}  // namespace

std::vector<ModeGroup> group_modes(const std::vector<SetUpFit>& fits) {
  std::vector<ModeGroup> groups;
  std::vector<std::size_t> order(fits.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // The fullest first: what others lack is then a gap, not a new group.
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t k) {
    return fits[k].fit.poles.size();
  });
  for (const std::size_t k : order) place_modes(fits, k, groups);
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<ModeGroup> before = groups;
    for (const std::size_t k : order) {
      take_out(k, groups);
      place_modes(fits, k, groups);
    }
    if (groups == before) break;
  }
  return groups;
}

std::complex<double> mean_pole(const std::vector<SetUpFit>& fits,
                               const ModeGroup& group) {
  Complex sum = 0.0;
  for (const GroupMember& member : group.members) {
    sum += fits[member.fit].fit.poles(member.mode);
  }
  return sum / static_cast<double>(group.members.size());
}

void find_missing(const IdentifyOptions& options,
                  std::vector<SetUpFit>& fits,
                  std::vector<ModeGroup>& groups) {
  std::vector<Complex> poles;
  for (const ModeGroup& group : groups) poles.push_back(mean_pole(fits, group));
  std::vector<std::vector<std::size_t>> found(fits.size());  // groups, in order
  for_each_parallel(fits.size(), [&](std::size_t k) {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::vector<GroupMember>& members = groups[g].members;
      const bool there = std::ranges::any_of(
          members, [k](const GroupMember& member) { return member.fit == k; });
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

std::vector<ModeGroup> common_modes(const std::vector<SetUpFit>& fits,
                                    std::vector<ModeGroup> groups) {
  const std::size_t enough = std::max<std::size_t>(2, (fits.size() + 1) / 2);
  std::erase_if(groups, [&](const ModeGroup& group) {
    return group.members.size() < enough;
  });
  return groups;
}

void drop_group(double hz, SetUpFits& parts) {
  Eigen::ArrayXd omega(std::ssize(parts.groups));
  for (Index g = 0; g < omega.size(); ++g) {
    omega(g) = std::abs(
        mean_pole(parts.fits, parts.groups[static_cast<std::size_t>(g)]));
  }
  const auto dropped = parts.groups.begin() + mode_to_drop(omega, hz);
  const std::vector<GroupMember> members = dropped->members;
  parts.groups.erase(dropped);
  for (const GroupMember& out : members) {
    SetUpFit& own = parts.fits[out.fit];
    drop_pole(own.curves, out.mode, own.fit);
    for (ModeGroup& group : parts.groups) {
      for (GroupMember& other : group.members) {
        if (other.fit == out.fit && other.mode > out.mode) --other.mode;
      }
    }
  }
}

void add_group(double hz, SetUpFits& parts) {
  ModeGroup group;
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
  std::ranges::sort(parts.groups, {}, [&parts](const ModeGroup& one) {
    return mean_log(parts.fits, one);
  });
}

}  // namespace tapfit::modal
