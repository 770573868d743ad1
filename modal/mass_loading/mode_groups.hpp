// Modes of different set-ups that are one: close in frequency, in the same
// order, each set-up having one at most once.
#pragma once

#include "modal/mass_loading/set_up_fit.hpp"

#include <complex>
#include <vector>

namespace tapfit::modal {

/// A mode of one of the set-ups.
struct GroupMember {
  std::size_t fit = 0;
  Eigen::Index mode = 0;

  bool operator==(const GroupMember&) const = default;
};

/// One mode, in each set-up at most once.
struct ModeGroup {
  std::vector<GroupMember> members;

  bool operator==(const ModeGroup&) const = default;
};

/// The set-ups' fits, and which modes of them are one.
struct SetUpFits {
  std::vector<SetUpFit> fits;
  std::vector<ModeGroup> groups;  ///< of the modes that count, by frequency
};

/// Each set-up is placed among the others until none changes its place.
[[nodiscard]] std::vector<ModeGroup> group_modes(
    const std::vector<SetUpFit>& fits);

/// Fits what a set-up's selection of modes missed and two others have.
void find_missing(const IdentifyOptions& options,
                  std::vector<SetUpFit>& fits,
                  std::vector<ModeGroup>& groups);

/// Modes that are in half of the set-ups or more, by frequency.
[[nodiscard]] std::vector<ModeGroup> common_modes(
    const std::vector<SetUpFit>& fits, std::vector<ModeGroup> groups);

/// Mean over the set-ups that have the mode [rad/s].
[[nodiscard]] std::complex<double> mean_pole(const std::vector<SetUpFit>& fits,
                                             const ModeGroup& group);

/// Takes the mode with the nearest mean frequency out of every set-up.
/// @throws InputError of mode_to_drop()
void drop_group(double hz, SetUpFits& parts);

/// Puts a pole in near a frequency in every set-up where one can be fitted.
/// @throws InputError of add_pole() in the first set-up where none takes it
void add_group(double hz, SetUpFits& parts);

}  // namespace tapfit::modal
