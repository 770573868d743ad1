#include "updating/test_check/test_check.hpp"

#include "acquisition/bundle/runs_alike.hpp"
#include "acquisition/checks/blow_response.hpp"
#include "acquisition/checks/force_channel.hpp"
#include "acquisition/checks/one_point.hpp"
#include "acquisition/checks/record_findings.hpp"
#include "acquisition/checks/rejected_hits.hpp"
#include "acquisition/checks/repeated_runs.hpp"
#include "acquisition/checks/steady_tones.hpp"
#include "acquisition/checks/tip_change.hpp"
#include "acquisition/checks/value_jumps.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "modal/checks/channel_phase.hpp"
#include "modal/checks/modal_mass.hpp"
#include "modal/checks/motion_kind.hpp"
#include "modal/checks/run_poles.hpp"
#include "modal/checks/run_residues.hpp"
#include "modal/mass_loading/stated_masses.hpp"
#include "signal/checks/calibration_findings.hpp"
#include "signal/checks/delay_findings.hpp"
#include "signal/checks/exchanged_labels.hpp"
#include "signal/checks/frf_findings.hpp"
#include "signal/checks/reciprocity_findings.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/test_check/body_mass.hpp"
#include "updating/test_check/wrong_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

using acquisition::TestBundle;

Finding as_finding(const InputError& error, Subject where) {
  return {Severity::Error,
          std::move(where),
          error.where().empty()
              ? error.fault()
              : fmt::format("{} ({})", error.fault(), error.where()),
          {},
          error.remedy()};
}

/// One check after the other; what one stage cannot be had for, later ones
/// cannot either.
class Checker {
 public:
  Checker(Session& session,
          std::optional<double> body_kg,
          const Progress& progress)
      : session_(session), body_kg_(body_kg), progress_(progress) {}

  TestCheck check() {
    input();
    points();
    body_.emplace(session_.bundle(), body_kg_, deck_mass());
    if (session_.bundle().modes) {
      given_modes();
    } else if (session_.bundle().frfs || records()) {
      frfs();
    }
    add(body_->findings());
    sort_by_severity(found_.findings);
    return std::move(found_);
  }

 private:
  // What is said of runs whose blows stand elsewhere means nothing.
  void add(std::vector<Finding> more) {
    std::erase_if(more, [&](const Finding& of) {
      return !of.where.runs.empty() &&
             std::ranges::all_of(of.where.runs, [&](std::size_t r) {
               return exchanged_.contains(r);
             });
    });
    append(std::move(more), found_.findings);
  }

  void input() {
    for (const std::string& warning : session_.bundle().warnings) {
      add({{Severity::Note, {}, warning, {}, {}}});
    }
  }

  // They are read and checked on the way; what was left out is said.
  void given_modes() {
    if (!reached([&] { (void)session_.modes(progress_); })) return;
    for (const std::string& warning : session_.modes().warnings) {
      add({{Severity::Note, {}, warning, {}, {}}});
    }
  }

  // Where the test's own points are on the model.
  void points() {
    if (session_.bundle().points.empty() || !session_.has_model()) return;
    reached([&] { found_.placed = session_.deck(progress_).measuring.size(); });
  }

  // Adds what is thrown as a finding.
  bool reached(const std::function<void()>& stage) {
    try {
      stage();
      return true;
    } catch (const InputError& error) {
      add({as_finding(error, {})});
      return false;
    }
  }

  // False where FRFs cannot follow.
  bool records() {
    const TestBundle& bundle = session_.bundle();
    if (!reached([&] { (void)session_.recordings(progress_); })) return false;
    acquisition::HitSet none;
    none.runs.resize(bundle.runs.size());
    const bool hit = reached([&] { (void)session_.hits(progress_); });
    const acquisition::HitSet& hits = hit ? session_.hits() : none;
    const auto& recordings = session_.recordings();
    progress_("checks of the records", 0.0);
    for (const acquisition::LeftOut& run : session_.left_out()) {
      add({as_finding(run.why, {{run.run}, {}, {}, {}})});
    }
    add(acquisition::repeated_run_findings(bundle, recordings));
    add(acquisition::repeated_channel_findings(bundle, recordings));
    add(acquisition::one_point_findings(bundle, recordings));
    found_.records = channel_records(bundle, recordings, hits);
    add(record_findings(bundle, found_.records));
    add_exchanges(
        acquisition::force_channel_findings(bundle, recordings, hits));
    if (!hit || exchanged_.size() == bundle.runs.size()) return false;
    add(hits.findings);
    add(acquisition::jump_findings(bundle, recordings, hits));
    add_tones(acquisition::tone_findings(bundle, recordings, hits));
    add(acquisition::trigger_findings(bundle, recordings, hits));
    add(acquisition::tip_change_findings(bundle, hits));
    add(acquisition::rejected_hit_findings(bundle, recordings, hits));
    add(acquisition::clipping_findings(bundle, recordings, hits));
    add(blow_response_findings(bundle,
                               blow_responses(bundle, recordings, hits)));
    coherence();
    return std::ranges::any_of(hits.runs, [](const auto& run) {
      return std::ranges::any_of(run, &acquisition::Hit::accepted);
    });
  }

  void add_tones(std::vector<Finding> found) {
    for (const Finding& of : found) {
      if (of.severity >= Severity::Warning) toned_.insert(of.where.channel);
    }
    add(std::move(found));
  }

  [[nodiscard]] bool is_toned(const signal::Frf& frf) const {
    return toned_.contains(channel_of(session_.bundle(), frf));
  }

  // A tone is in each run by another phase, as if a sensor had moved.
  [[nodiscard]] bool may_be_a_tone(const Finding& of) const {
    return std::ranges::any_of(of.where.runs, [this](std::size_t r) {
      const acquisition::TestBundle& bundle = session_.bundle();
      return std::ranges::any_of(bundle.runs[r].sensors, [&](const auto& s) {
        return toned_.contains(bundle.channels[s.channel].name);
      });
    });
  }

  void add_exchanges(std::vector<Finding> found) {
    std::set<std::size_t> runs;
    for (const Finding& of : found) {
      runs.insert(of.where.runs.begin(), of.where.runs.end());
    }
    add(std::move(found));
    exchanged_ = std::move(runs);
  }

  void coherence() {
    const TestBundle& bundle = session_.bundle();
    found_.coherence.resize(bundle.runs.size());
    found_.apart.resize(bundle.runs.size());
    for (const acquisition::RunGroup& group : acquisition::runs_alike(bundle)) {
      progress_("coherence of hits",
                static_cast<double>(group.front()) /
                    static_cast<double>(bundle.runs.size()));
      const signal::GroupSpectra spectra = signal::group_spectra(
          bundle, session_.recordings(), session_.hits(), group);
      const signal::HitCoherence of = group_coherence(spectra);
      for (const std::size_t r : group) {
        found_.coherence[r] = part_of(of, bundle, r);
      }
      for (const auto& [run, hit] : hits_apart(of)) {
        found_.apart[run].push_back(hit);
      }
      signal::DelayChanges delays =
          delay_changes(bundle, session_.hits(), spectra);
      add(std::move(delays.findings));
      for (const signal::HitAt& at : delays.hits) late_.insert(at);
      for (Finding& finding : coherence_findings(bundle, of, group)) {
        if (!is_late(finding.where)) add({std::move(finding)});
      }
    }
  }

  // A hit of another delay stands apart for no other reason.
  bool is_late(const Subject& where) const {
    return where.runs.size() == 1 && where.hit &&
           late_.contains({where.runs.front(), *where.hit});
  }

  // Hits of two delays average to what looks like another structure.
  bool has_two_delays(const std::vector<std::size_t>& runs) const {
    return std::ranges::any_of(late_, [&](const signal::HitAt& at) {
      return std::ranges::find(runs, at.run) != runs.end();
    });
  }

  void frfs() {
    if (!reached([&] { (void)session_.frfs(progress_); })) return;
    const signal::FrfSet& set = session_.frfs();
    found_.points = signal::driving_points(set);
    // A tone is a peak of any phase.
    for (signal::DrivingPoint& point : found_.points) {
      if (is_toned(set.frfs[point.frf])) point.rather.reset();
    }
    found_.pairs = signal::reciprocals(set);
    const std::vector<Finding> kinds = modes();
    std::set<std::string> other_kind;
    for (const Finding& kind : kinds) other_kind.insert(kind.where.channel);
    both_ways(other_kind);
    add(set.findings);
    if (set.level.is_nonlinear()) {
      add({{Severity::Warning, {}, statement(set.level), {}, {}}});
    }
    add(signal::spread_findings(set));
    masses();
  }

  // What an exchange of two labels explains is said once.
  void both_ways(const std::set<std::string>& other_kind) {
    const TestBundle& bundle = session_.bundle();
    const signal::FrfSet& set = session_.frfs();
    const auto exchanges = signal::exchanged_labels(set, found_.pairs);
    const auto exchanged = [&](std::size_t f) {
      return std::ranges::any_of(exchanges, [&](const auto& exchange) {
        return is_of(exchange, set.frfs[f]);
      });
    };
    const auto explained = [&](std::size_t f) {
      return labels_.channels.contains(set.frfs[f].run) || exchanged(f);
    };
    std::vector<signal::DrivingPoint> points = found_.points;
    std::erase_if(points, [&](const auto& p) {
      return exchanged(p.frf) || (p.mixed() && is_toned(set.frfs[p.frf]));
    });
    // A channel of another kind has no fair driving point either.
    for (Finding& finding : driving_point_findings(bundle, set, points)) {
      if (other_kind.contains(finding.where.channel)) continue;
      add({std::move(finding)});
    }
    std::vector<signal::Reciprocal> pairs = found_.pairs;
    std::erase_if(pairs, [&](const auto& p) {
      return !p.by_a_factor() && (explained(p.frf) || explained(p.other));
    });
    add(exchange_findings(bundle, set, found_.pairs, exchanges));
    add(reciprocity_findings(bundle, set, pairs));
  }

  // Returns those that say that a channel measures no acceleration.
  std::vector<Finding> modes() {
    const TestBundle& bundle = session_.bundle();
    const signal::FrfSet& set = session_.frfs();
    if (!reached([&] { (void)session_.modes(progress_); })) return {};
    const modal::ModeSet& modes = session_.modes();
    progress_("checks of the modes", 0.0);
    std::vector<Finding> poles = run_pole_findings(bundle, set, modes);
    std::set<std::size_t> foreign;
    for (const Finding& of : poles) {
      if (of.severity != Severity::Error) continue;
      foreign.insert(of.where.runs.begin(), of.where.runs.end());
    }
    std::erase_if(poles, [&](const Finding& of) {
      return of.severity == Severity::Error && has_two_delays(of.where.runs);
    });
    add(std::move(poles));
    std::vector<Finding> residues = run_residue_findings(bundle, set, modes);
    labels_ = wrong_labels(bundle, set, residues, found_.points);
    for (Finding& finding : without_exchanged(std::move(residues), labels_)) {
      // Runs that are no part of the test have patterns of their own.
      const bool said = !finding.where.runs.empty() &&
                        std::ranges::all_of(
                            finding.where.runs,
                            [&](std::size_t r) { return foreign.contains(r); });
      if (said) continue;
      if (may_be_a_tone(finding)) {
        finding.severity = Severity::Warning;
        finding.likely += "; or it is the steady tone of a sensor there";
      }
      add({std::move(finding)});
    }
    body_->compare_with(set, modes, found_.points);
    add(modal_mass_findings(bundle, set, modes, body_->kg()));
    add(modal::stated_mass_findings(bundle, modes.shifts));
    // Told by driving points, which are none where blows are mislabelled.
    std::vector<Finding> kinds;
    if (labels_.blows.empty()) {
      kinds = motion_kind_findings(bundle, set, modes);
    }
    std::set<std::string> told;
    for (const Finding& kind : kinds) told.insert(kind.where.channel);
    for (Finding& finding : channel_phase_findings(bundle, set, modes)) {
      if (told.contains(finding.where.channel)) continue;
      if (finding.severity == Severity::Error) {
        kinds.push_back(finding);
      } else {
        add({std::move(finding)});
      }
    }
    add(kinds);
    return kinds;
  }

  // 0 where it is not known [kg].
  double deck_mass() {
    if (!session_.bundle().deck) return 0.0;
    try {
      const structure::Deck& deck = session_.deck(progress_);
      return total_mass(deck, structure::assemble(deck));
    } catch (const InputError&) {
      return 0.0;  // what is wrong with the deck is said elsewhere
    }
  }

  void masses() {
    if (!(body_->kg() > 0.0)) return;
    add(mass_line_findings(session_.bundle(),
                           session_.frfs(),
                           found_.points,
                           body_->kg(),
                           body_->tolerance()));
  }

  Session& session_;
  std::optional<double> body_kg_;
  const Progress& progress_;
  std::optional<BodyMass> body_;
  std::set<std::size_t> exchanged_;  // runs whose hammer is another channel
  std::set<std::string> toned_;      // channels with a tone that matters
  WrongLabels labels_;
  std::set<signal::HitAt> late_;  // or early, against most of their placement
  TestCheck found_;
};

}  // namespace

bool TestCheck::may_go_on() const {
  return std::ranges::none_of(findings, [](const Finding& finding) {
    return finding.severity == Severity::Error;
  });
}

TestCheck check_test(Session& session,
                     std::optional<double> body_kg,
                     const Progress& progress) {
  return Checker(session, body_kg, progress).check();
}

}  // namespace tapfit::updating
