#include "updating/measurement/measurement.hpp"

#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/hits/find_hits.hpp"
#include "modal/fit/continue_frfs.hpp"
#include "modal/identify/identify_modes.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "updating/measurement/bundle_modes.hpp"
#include "updating/measurement/ready_frfs.hpp"
#include "updating/measurement/truncation_corrected_frfs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace tapfit::updating {

namespace {

// Of FRFs from recordings there are no lines outside the test's band.
modal::IdentifyOptions as_selected(const ModeChoices& choices,
                                   const acquisition::TestBundle& bundle) {
  modal::IdentifyOptions options;
  options.band_hz = choices.band_hz ? choices.band_hz : bundle.band_hz;
  options.edits = choices.edits;
  return options;
}

// What is not there to be looked at.
InputError no_records(const acquisition::TestBundle& bundle) {
  const bool alone = bundle.uff.has_value();
  return {fmt::format("the test consists of {}: it has no recordings",
                      bundle.modes ? "modes" : "ready FRFs"),
          (alone ? *bundle.uff : bundle.folder / "test.json").string(),
          alone ? "for hits and recordings give a file of time records "
                  "(dataset 58, function type 1)"
                : "for hits and recordings give \"runs\""};
}

// From a little below the lowest mode to a little above the highest.
std::array<double, 2> span_of(const modal::ModeSet& modes) {
  constexpr double margin = 1.2;
  return {modes.modes.front().frequency_hz / margin,
          modes.modes.back().frequency_hz * margin};
}

// Once of each.
void warn_of(const std::vector<acquisition::LeftOut>& left_out,
             acquisition::TestBundle& bundle) {
  for (const acquisition::LeftOut& run : left_out) {
    const std::string words = statement(run);
    if (std::ranges::count(bundle.warnings, words) > 0) continue;
    bundle.warnings.push_back(words);
  }
}

// Whoever sees the FRFs only is told as well.
signal::FrfSet with_warnings(const acquisition::HitSet& hits,
                             signal::FrfSet set) {
  std::vector<std::string> said;
  for (const Finding& finding : hits.findings) said.push_back(in_full(finding));
  set.statements.insert(set.statements.begin(), said.begin(), said.end());
  return set;
}

}  // namespace

Measurement::Measurement(const std::filesystem::path& folder,
                         acquisition::Unreadable unreadable)
    : bundle_(acquisition::read_test_bundle(folder)), unreadable_(unreadable) {
  acquisition::check_run_files(bundle_, unreadable_);
}

const std::vector<acquisition::LeftOut>& Measurement::left_out() const {
  static const std::vector<acquisition::LeftOut> none;
  return recordings_ ? recordings_->left_out : none;
}

const std::vector<acquisition::Recording>& Measurement::recordings(
    const Progress& progress) {
  if (!recordings_ && (bundle_.frfs || bundle_.modes)) {
    throw no_records(bundle_);
  }
  if (!recordings_) {
    progress("recordings: reading", 0.0);
    if (unreadable_ == acquisition::Unreadable::LeftOut) {
      recordings_ = acquisition::read_readable(bundle_);
    } else {
      recordings_ = {acquisition::read_recordings(bundle_), {}};
    }
    warn_of(recordings_->left_out, bundle_);
  }
  return recordings_->recordings;
}

const acquisition::HitSet& Measurement::hits(const Progress& progress) {
  if (!hits_) {
    static_cast<void>(recordings(progress));
    progress("hits: finding", 0.0);
    acquisition::HitOptions options;
    options.trigger_percent = bundle_.trigger_percent;
    options.pre_trigger_s = bundle_.pre_trigger_s;
    options.block_s = bundle_.block_s;
    hits_ =
        unreadable_ == acquisition::Unreadable::LeftOut
            ? acquisition::find_readable_hits(bundle_, *recordings_, options)
            : acquisition::find_hits(bundle_, recordings_->recordings, options);
    warn_of(recordings_->left_out, bundle_);
    overrule_found();
  }
  return *hits_;
}

const signal::FrfSet& Measurement::frfs(const Progress& progress) {
  if (!frfs_ && bundle_.modes) frfs_.emplace();
  if (!frfs_ && bundle_.frfs) {
    progress("FRFs: reading", 0.0);
    ReadyFrfs ready = read_ready_frfs(bundle_, progress);
    if (same_modes(choices_, {})) modes_ = std::move(ready.modes);
    frfs_ = std::move(ready.set);
  }
  if (!frfs_) {
    const auto& all = recordings(progress);
    const auto& found = hits(progress);
    TruncationCorrectedFrfs found_frfs =
        estimate_truncation_corrected_frfs(bundle_, all, found, progress);
    lasting_poles_ = std::move(found_frfs.poles);
    if (same_modes(choices_, {})) modes_ = std::move(found_frfs.modes);
    frfs_ = with_warnings(found, std::move(found_frfs.set));
  }
  return *frfs_;
}

const modal::ModeSet& Measurement::modes(const Progress& progress) {
  if (!modes_ && bundle_.modes) {
    progress("modes: reading", 0.0);
    modes_ = read_bundle_modes(bundle_);
  }
  // Taking off the ringing may have found them.
  const signal::FrfSet& set = frfs(progress);
  if (!modes_) {
    modes_ =
        modal::identify_modes(set, as_selected(choices_, bundle_), progress);
  }
  return *modes_;
}

bool Measurement::choose(const ModeChoices& choices, const Progress& progress) {
  if (bundle_.modes && !same_modes(choices, {})) {
    throw InputError("the test's modes are given: none can be dropped or added",
                     bundle_.modes->file.string(),
                     "change the file of modes, or band_hz in test.json");
  }
  const signal::FrfSet& set = frfs(progress);
  const bool known = modes_ && same_modes(choices, choices_);
  if (!known && !bundle_.modes) {
    modes_ =
        modal::identify_modes(set, as_selected(choices, bundle_), progress);
  }
  choices_ = choices;
  return !known;
}

signal::FrfSet Measurement::frfs_as(signal::FrfOptions options,
                                    const Progress& progress) {
  static_cast<void>(frfs(progress));
  options.lasting_poles = lasting_poles_;
  const acquisition::HitSet& found = hits(progress);
  return with_warnings(
      found,
      signal::estimate_frfs(
          bundle_, recordings(progress), found, options, progress));
}

signal::FrfSet Measurement::frfs_on(const Eigen::VectorXcd& s,
                                    const Progress& progress) const {
  if (bundle_.frfs) return modal::continue_frfs(*frfs_, *modes_, s);
  return with_warnings(*hits_,
                       signal::estimate_frfs_at(bundle_,
                                                recordings_->recordings,
                                                *hits_,
                                                s,
                                                lasting_poles_,
                                                progress));
}

double Measurement::block_s() const {
  if (bundle_.modes) return 0.0;
  if (hits_) {
    return static_cast<double>(hits_->block - hits_->pre_trigger) /
           hits_->sample_rate_hz;
  }
  const Eigen::VectorXd f = frfs_->frequency_hz();
  return static_cast<double>(f.size() - 1) / (f(f.size() - 1) - f(0));
}

std::array<double, 2> Measurement::band() const {
  if (bundle_.modes) return bundle_.band_hz.value_or(span_of(*modes_));
  const Eigen::VectorXd f = frfs_->frequency_hz();
  if (bundle_.frfs) {
    // Closer to the ends a damped line sees too much that was not measured.
    constexpr double margin = 1.1;
    const std::array<double, 2> seen = {
        margin * std::max(f.minCoeff(), 1.0 / block_s()),
        f.maxCoeff() / margin};
    const std::array<double, 2> asked = bundle_.band_hz.value_or(seen);
    return {std::max(asked[0], seen[0]), std::min(asked[1], seen[1])};
  }
  if (bundle_.band_hz) return *bundle_.band_hz;
  const double rate = hits_->sample_rate_hz;
  return {std::max(f.minCoeff(), 1e-3 * rate),
          std::min(f.maxCoeff(), 0.4 * rate)};
}

bool Measurement::overrule(const OverruledHit& which) {
  static_cast<void>(hits({}));
  acquisition::Hit& judged = hits_->runs.at(which.run).at(which.hit);
  const bool before = judged.accepted;
  acquisition::overrule(judged);
  if (judged.accepted == before) return false;
  // Overruled twice, it is judged as before.
  if (std::erase(overruled_, which) == 0) overruled_.push_back(which);
  frfs_.reset();
  lasting_poles_.resize(0);
  modes_.reset();
  return true;
}

// What was overruled before the hits were found; of runs that are left out it
// stays for when they can be read again.
void Measurement::overrule_found() {
  const auto is_left_out = [this](std::size_t run) {
    return std::ranges::count(left_out(), run, &acquisition::LeftOut::run) > 0;
  };
  for (const auto& [run, hit, together] : overruled_) {
    if (is_left_out(run)) continue;
    if (run < hits_->runs.size() && hit < hits_->runs[run].size()) {
      acquisition::overrule(hits_->runs[run][hit]);
      continue;
    }
    hits_.reset();
    throw InputError(
        "the saved session overrules a hit that is not there",
        fmt::format("run {}, hit {}", run + 1, hit + 1),
        "recordings or trigger have changed since: take the hit out of the "
        "session's file");
  }
}

}  // namespace tapfit::updating
