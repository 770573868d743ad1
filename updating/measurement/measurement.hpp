// The room updating/measurement. One test's measurement: each stage worked out
// when first asked for.
// In:  A bundle's folder and what was decided by hand.
// Out: Recordings, hits, FRFs, modes; the model that the bundle names.
// May include: its row in CONTRIBUTING.md.
//
// A test's measurement from its files to its modes. Each stage is worked out
// when first asked for and kept; overruling a hit drops what follows from it.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/progress.hpp"
#include "acquisition/hits/hits.hpp"
#include "acquisition/hits/readable_recordings.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "updating/measurement/mode_choices.hpp"
#include "updating/measurement/overruled_hit.hpp"

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

namespace tapfit::updating {

class Measurement {
 public:
  /// @throws InputError as of acquisition::read_test_bundle, check_run_files
  Measurement(const std::filesystem::path& folder,
              acquisition::Unreadable unreadable);

  [[nodiscard]] const acquisition::TestBundle& bundle() const {
    return bundle_;
  }
  /// @throws InputError for a test of ready FRFs or modes, which has none
  const std::vector<acquisition::Recording>& recordings(
      const Progress& progress);
  /// Runs that cannot be used, as far as recordings() and hits() have shown.
  [[nodiscard]] const std::vector<acquisition::LeftOut>& left_out() const;
  const acquisition::HitSet& hits(const Progress& progress);
  /// None where the test consists of modes.
  const signal::FrfSet& frfs(const Progress& progress);
  const modal::ModeSet& modes(const Progress& progress);

  /// The FRFs of recordings with another estimator or window; the poles of
  /// modes that outlast the block are those of frfs().
  /// @throws InputError as of signal::estimate_frfs
  [[nodiscard]] signal::FrfSet frfs_as(signal::FrfOptions options,
                                       const Progress& progress);
  /// The FRFs on other lines, once frfs() and modes() are there.
  /// @param s [rad/s]
  [[nodiscard]] signal::FrfSet frfs_on(const Eigen::VectorXcd& s,
                                       const Progress& progress) const;
  /// What the FRFs see of a hit after the trigger; as of frfs() [s]; 0: modes.
  [[nodiscard]] double block_s() const;
  /// The bundle's band, or what was measured; as of frfs() and modes() [Hz].
  [[nodiscard]] std::array<double, 2> band() const;

  /// Judges a hit the other way round, or as before where it was overruled.
  /// @return whether its judgement changed
  bool overrule(const OverruledHit& which);
  [[nodiscard]] const std::vector<OverruledHit>& overruled() const {
    return overruled_;
  }
  /// Hits to overrule as soon as they are found.
  void set_overruled(const std::vector<OverruledHit>& hits) {
    overruled_ = hits;
  }

  [[nodiscard]] const ModeChoices& choices() const { return choices_; }
  /// Identifies the modes with these choices; where that fails, all stays as it
  /// was.
  /// @return whether the modes are new
  /// @throws InputError as of modal::identify_modes; for a test of modes,
  ///   which are what they are
  bool choose(const ModeChoices& choices, const Progress& progress);
  /// Choices for when the modes are first asked for.
  void set_choices(const ModeChoices& choices) { choices_ = choices; }

 private:
  void overrule_found();

  acquisition::TestBundle bundle_;
  acquisition::Unreadable unreadable_;
  std::optional<acquisition::ReadableRecordings> recordings_;
  std::optional<acquisition::HitSet> hits_;
  std::vector<OverruledHit> overruled_;
  std::optional<signal::FrfSet> frfs_;
  Eigen::VectorXcd lasting_poles_;  // of modes that outlast the block
  ModeChoices choices_;
  std::optional<modal::ModeSet> modes_;
};

}  // namespace tapfit::updating
